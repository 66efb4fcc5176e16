// What a session shows of blood and vessels, and to guide the hand.
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "inventor/gl/vectors.h"
#include "inventor/hand/operating_session.h"
#include "tools/parts/clip_part.h"

namespace resect {
namespace {

// Of ends that lie so close that their rings would cover each other, the one that bleeds most
// stays; when it is closed, the next one shows.
void keepApart(std::vector<BleedingEnd>& ends) {
  constexpr double kApart = 0.004;  // m
  std::ranges::stable_sort(ends, std::greater(), &BleedingEnd::radius);
  std::vector<BleedingEnd> kept;
  for (const BleedingEnd& end : ends)
    if (std::ranges::none_of(kept, [&](const BleedingEnd& other) {
          return (end.place - other.place).norm() < kApart;
        }))
      kept.push_back(end);
  ends = std::move(kept);
}

}  // namespace

// Draws the puddles and drops, and what lay where they were.
void OperatingSession::followLooseBlood() {
  if (!state_.loose && !loose_) return;
  for (const auto* blood : {loose_.get(), state_.loose.get()}) {
    if (!blood) continue;
    if (!blood->poolBox.empty()) damage_.boxes.push_back(blood->poolBox);
    Aabb drops;
    for (const Vec3f& drop : blood->drops) drops.grow(drop.cast<double>());
    if (!drops.empty()) damage_.boxes.push_back(drops.padded(0.004));
  }
  loose_ = state_.loose;
  room().setLooseBlood(loose_.get());
}

// Whether nobody sees that points have moved.
bool same(const auto& a, const auto& b) {
  constexpr double kSeen = 0.2e-3;  // m
  return std::ranges::equal(
      a, b, [](const auto& p, const auto& q) { return (p - q).squaredNorm() < kSeen * kSeen; });
}

// Draws bare vessels and clips anew if they have changed visibly.
void OperatingSession::followBareVessels() {
  const BareVessels *now = state_.bare.get(), *before = bare_.get();
  if (!now && !before) return;
  if (now && before && same(now->walls.points, before->walls.points) &&
      now->walls.cut == before->walls.cut && same(now->clips.points, before->clips.points))
    return;
  for (const BareVessels* vessels : {before, now})
    if (vessels && !vessels->box.empty()) damage_.boxes.push_back(vessels->box);
  bare_ = state_.bare;
  room().setBareVessels(bare_.get());
}

// Draws what hangs on the organ anew if it has moved visibly.
void OperatingSession::followAdnexa() {
  const SurfaceCopy *now = state_.adnexa.get(), *before = adnexa_.get();
  if (now == before ||
      (now && before && same(now->points, before->points) && now->triangles == before->triangles))
    return;
  for (const SurfaceCopy* shapes : {before, now})
    if (shapes) {
      Aabb box;
      for (const Vec3f& p : shapes->points) box.grow(p.cast<double>());
      damage_.boxes.push_back(box);
    }
  adnexa_ = state_.adnexa;
  room().setAdnexa(adnexa_.get());
}

// Draws the smoke, and what was behind it. In thesis mode there is no smoke.
void OperatingSession::followSmoke() {
  if (scenario_.mode == OperationMode::Thesis) return;
  std::vector<SmokeBall> balls = smokeBalls(state_.smoke, state_.time);
  const Aabb now = smokeBox(balls), before = std::exchange(smokeBox_, now);
  for (const Aabb& box : {before, now})
    if (!box.empty()) damage_.boxes.push_back(box);
  room().setSmoke(std::move(balls));
}

// Shows what there is besides the organs: blood, bare vessels, what hangs on an organ, and smoke.
void OperatingSession::followBlood() {
  followLooseBlood();
  followBareVessels();
  followAdnexa();
  followSmoke();
}

// Marks what bleeds for an instrument that can stop it, and guides the hand there.
void OperatingSession::showBleeding() {
  const int held = tools_.held();
  const SurfaceHand* hand = marksBleeding_ && held >= 0 ? tools_.surfaceHand() : nullptr;
  std::vector<BleedingEnd> ends;
  if (hand && hand->style.seeks > 0) {
    const bool clips = toolModels_[std::size_t(held)].kind == "clip_applier";
    const double least = clips ? kTrickle : kLeastMarkedFlow;
    for (const BleedingEnd& end : state_.bleedingEnds)
      if (std::abs(end.flow) >= least && (!clips || holdsClip(end.radius))) ends.push_back(end);
  }
  keepApart(ends);
  std::vector<Vec3> targets;
  for (const BleedingEnd& end : ends) targets.push_back(end.place);
  tools_.setTargets(std::move(targets));
  const Vec3 eye = toVec(room().camera()->position.getValue());
  damage_.boxes.push_back(bleeding_.show(
      ends.empty() ? std::vector<MarkLine>()
                   : bleedingRings(ends, hand->target, (eye - organBox_.centre()).normalized())));
}

std::optional<double> OperatingSession::guideDistance() const {
  constexpr double kShaft = 0.1;  // m, of an instrument from its tip
  const int held = tools_.held();
  if (!guide_ || held < 0) return {};
  const Pose pose = tools_.pose(held);
  const ToolModel& model = toolModels_[std::size_t(held)];
  return distanceFrom(*guide_, {pose * model.tip, pose * (model.tip + kShaft * model.axis)});
}

// Draws the guidance, coloured by what the instrument in hand does, and the ghosts.
void OperatingSession::showGuide() {
  std::vector<MarkLine> lines;
  if (guide_) {
    const auto distance = guideDistance();
    const Vec3 eye = toVec(room().camera()->position.getValue());
    lines = guideLines(*guide_, distance ? keepingOf(*guide_, *distance) : Keeping::Far,
                       (eye - organBox_.centre()).normalized());
  }
  damage_.boxes.push_back(guideMarks_.show(std::move(lines)));
  damage_.boxes.push_back(showsGhosts_ && !state_.showing ? ghosts_.show(state_.time)
                                                          : ghosts_.hide());
}

}  // namespace resect
