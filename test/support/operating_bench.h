// An operation that tests do with mouse and keys, without a window.
#pragma once

#include <Inventor/SbViewportRegion.h>
#include <Inventor/events/SoKeyboardEvent.h>
#include <Inventor/events/SoLocation2Event.h>
#include <Inventor/events/SoMouseButtonEvent.h>
#include <Inventor/manips/SoTransformManip.h>
#include <doctest/doctest.h>

#include "inventor/hand/operating_session.h"
#include "inventor/reading/model_file.h"
#include "io/operation_setup.h"
#include "operation/room.h"
#include "tools/registry.h"

namespace resect::test {

// A coarse liver, all instruments, and a mouse on a picture of 800 x 500 pixels. living: its tissue
// moves, and instruments follow its surface; else as in the thesis.
struct OperatingBench {
  Scenario scenario;
  std::unique_ptr<OperatingSession> session;
  SbViewportRegion viewport{800, 500};

  explicit OperatingBench(bool living = false, double spacing = 0.012) {
    scenario.organs[0].source.spacing = spacing;
    if (living) makeElastic(scenario);
    int place = 0;
    for (const ToolKind& kind : toolKinds())
      if (!kind.stopsBleeding)
        scenario.tools.push_back({std::string(kind.name), {}, toolBoxPlace(place++), {}});
    const ModelReader reader = [](const std::filesystem::path& p, const std::string& parts) {
      return readModel(p, parts);
    };
    Organ organ = makeOrgan(loadCells(scenario.organs[0].source, reader), {});
    auto tissue = makeTissue(scenario.organs[0].tissue, organ);
    session = std::make_unique<OperatingSession>(
        scenario,
        std::make_unique<Simulation>(std::move(organ), loadTools(scenario, reader),
                                     std::move(tissue)),
        1.6);
    settle();
  }

  ToolHandling& tools() { return session->tools(); }

  // Lets the operation do two more frames.
  void settle() {
    session->update();
    if (session->showing())
      session->operation().waitForAnswer();
    else
      session->operation().waitFor(session->state().frame + 2);
    session->update();
  }
  bool send(SoEvent& event, const SbVec2s& at, bool shift = false, bool control = false) {
    event.setPosition(at);
    event.setTime(SbTime::getTimeOfDay());
    event.setShiftDown(shift);
    event.setCtrlDown(control);
    const bool taken = session->handle(event, viewport);
    session->update();
    return taken;
  }
  void button(const SbVec2s& at, bool down, SoMouseButtonEvent::Button which, bool shift = false,
              bool control = false) {
    SoMouseButtonEvent event;
    event.setButton(which);
    event.setState(down ? SoButtonEvent::DOWN : SoButtonEvent::UP);
    send(event, at, shift, control);
  }
  void move(const SbVec2s& at, bool shift = false) {
    SoLocation2Event event;
    send(event, at, shift);
  }
  void click(const SbVec2s& at, SoMouseButtonEvent::Button which = SoMouseButtonEvent::BUTTON1) {
    move(at);
    button(at, true, which);
    button(at, false, which);
  }
  void drag(const SbVec2s& from, const SbVec2s& to,
            SoMouseButtonEvent::Button which = SoMouseButtonEvent::BUTTON1, bool shift = false) {
    move(from);
    button(from, true, which, shift);
    for (int i = 1; i <= 10; ++i)
      move(SbVec2s(short(from[0] + (to[0] - from[0]) * i / 10),
                   short(from[1] + (to[1] - from[1]) * i / 10)),
           shift);
    button(to, false, which, shift);
  }
  bool key(SoKeyboardEvent::Key key, bool shift = false, bool down = true) {
    SoKeyboardEvent event;
    event.setKey(key);
    event.setState(down ? SoButtonEvent::DOWN : SoButtonEvent::UP);
    return send(event, {400, 250}, shift);
  }
  SbVec2s pixelOf(int tool) const {
    return session->pixelOf(session->middleOfTool(tool), viewport);
  }
  // Of its surface, in front of its middle.
  Vec3 pointOfOrgan() const {
    const Vec3 middle = session->cells().lattice.box().centre();
    const auto under = session->pointUnder(session->pixelOf(middle, viewport), viewport);
    REQUIRE(under);
    return under->point;
  }
  SbVec2s nowhere() const { return {790, 490}; }  // the room's wall
  bool manipulated(int tool) {
    return session->room().toolTransform(tool)->isOfType(SoTransformManip::getClassTypeId());
  }
};

}  // namespace resect::test
