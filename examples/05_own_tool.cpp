// 05: an energy device of one's own: an instrument with a working part of thirty lines.
//
// A working part answers one question: what does it do to the tissue that its instrument touches?
// It queues edits and never changes tissue itself; the simulation does the rest. This electrode
// works while its pedal is pressed: in each second it vaporises so many of the particles that it
// touches, however many frames the second has; what it touches else it labels as charred.

#include <fmt/core.h>

#include <algorithm>

#include "geometry/primitives.h"
#include "geometry/topology.h"
#include "organ/discretize.h"
#include "simulation/simulation.h"

using namespace resect;

class Electrode : public WorkingPart {
 public:
  static constexpr std::uint8_t kCharred = 1;
  static constexpr double kPerSecond = 360;  // particles, with the pedal pressed down

  void act(const Touch& touch, std::vector<TissueEdit>& edits) const override {
    const double power = touch.way.to.pedal;
    if (power == 0) return;
    const auto most = std::size_t(power * kPerSecond * touch.duration + 0.5);
    for (std::size_t i = 0; i < touch.contacts.cells.size(); ++i) {
      const std::int64_t cell = touch.contacts.cells[i];
      if (i < most)
        edits.push_back(touch.edit(RemoveCell{cell}));
      else
        edits.push_back(touch.edit(SetLabel{cell, kCharred}));
    }
  }
};

std::unique_ptr<Tool> electrode(double tipRadius) {
  auto tool = std::make_unique<Tool>();
  tool->model.name = "electrode";
  tool->model.mesh = sphereMesh({0, 0, 0}, tipRadius);
  tool->bounds = bounds(tool->model.mesh);
  tool->parts.push_back(std::make_unique<Electrode>());
  return tool;
}

int main() {
  const TriangleMesh ball = sphereMesh({0, 0, 0}, 0.04);
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(electrode(0.012));
  Simulation simulation(makeOrgan(discretize(ball, latticeForSpacing(bounds(ball), 0.004)), {}),
                        std::move(tools));

  // Held still in the skin: without the pedal nothing happens, with it until nothing is left there.
  FrameInput input;
  input.tools.push_back({{Vec3(0, 0.04, 0), Eigen::Quaterniond::Identity()}});
  StepReport report;
  simulation.step(input, report);
  bool good = report.removed == 0 && report.contacts[0].cells.size() > 10;
  input.tools[0].pedal = 1;
  std::int64_t removed = 0, frames = 0, charred = 0;
  do {
    simulation.step(input, report);
    removed += report.removed;
    charred += std::ranges::count_if(report.edits, [](const TissueEdit& edit) {
      return std::holds_alternative<SetLabel>(edit.what);
    });
    good = good && report.removed <= 6 && ++frames < 1000;
    fmt::print("frame {:2}: touches {:2}, takes {}\n", report.frame,
               report.contacts[0].cells.size(), report.removed);
  } while (good && report.removed > 0);
  fmt::print("{} particles in {} frames, charred on the way {} times; {} left\n", removed, frames,
             charred, simulation.organ().particles);
  good = good && removed > 10 && charred > 0;
  return good && topology(simulation.organ().surface.mesh()).closed() ? 0 : 1;
}
