#include "operation/way/place_ways.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/stop.h"
#include "operation/way/organ_section.h"

namespace resect {
namespace {

// Sections next to the ends of the box are points, or slivers.
constexpr double kOutermost = 0.02;  // of the box

double rounded(double value) { return std::round(1e5 * value) / 1e5; }

// One organ with what places on it need.
class Ground {
 public:
  Ground(const LaidOrgan& organ, const std::string& name)
      : organ_(organ), box_(bounds(organ.surface)), name_(name) {
    if (organ.surface.triangles.empty())
      throw error("organ \"{}\" has no surface on which a tool's way could lie; use smaller cells",
                  name);
  }

  Vec3 tip(const WayKey& key, const Vec3& before) {
    if (key.kind == WayKey::Place::Same) return before;
    Vec3 place = key.place;
    if (key.kind == WayKey::Place::Landmark) {
      const auto found = landmarkPlace(organ_.landmarks, key.landmark);
      if (!found)
        throw error("organ \"{}\" has no landmark \"{}\"; name it in [organ.landmark]", name_,
                    key.landmark);
      place = *found;
    }
    Vec3 tip = pointInBox(box_, place);
    if (key.kind == WayKey::Place::Over || key.depth) {
      const double across = std::clamp(place.x(), kOutermost, 1 - kOutermost);
      const double x = pointInBox(box_, {across, 0, 0}).x();
      if (!section_ || x != sectionX_) section_.emplace(organ_.surface, sectionX_ = x);
      const OrganSection& section = *section_;
      if (key.kind == WayKey::Place::Over)
        tip.z() = section.back() + place.z() * (section.front() - section.back());
      if (key.depth) {
        const double tall = section.tallest();
        const double depth = key.share ? *key.depth * tall : *key.depth;
        tip.y() = section.topAt(tip.z()) - std::min(depth, kDeepestShare * tall);
        if (*key.depth > 0) tip.y() = std::max(tip.y(), section.lowest());
      }
    }
    return tip + key.offset + key.cells.cwiseProduct(organ_.cell);
  }

 private:
  const LaidOrgan& organ_;
  Aabb box_;
  std::string name_;
  std::optional<OrganSection> section_;  // of the key before: most strokes stay in one plane
  double sectionX_ = 0;
};

std::vector<ToolKey> keysOf(const OrganWay& way, Ground& ground, double frameRate) {
  std::vector<ToolKey> keys;
  double time = 0;
  Pose pose;
  for (const WayKey& key : way.keys) {
    const Vec3 before = pose.position;
    pose.position = ground.tip(key, before).unaryExpr(&rounded);
    if (key.rotation) pose.rotation = *key.rotation;
    if (key.time) {
      time = *key.time;
    } else if (key.speed) {
      // On a frame, so that corners of the way are passed and not cut off between two frames.
      const double frames = (pose.position - before).norm() / *key.speed * frameRate;
      time += std::max(1.0, std::ceil(frames - 1e-2)) / frameRate;
    } else {
      time += key.wait;
    }
    keys.push_back({rounded(time), pose, key.squeeze, key.pedal});
  }
  return keys;
}

// When the tool first comes below the organ's top; the time of its last key if it never does.
double firstTouch(const ScenarioTool& tool) {
  if (!tool.way) return tool.keys.front().time;
  for (std::size_t i = 0; i < tool.keys.size(); ++i) {
    const WayKey& key = tool.way->keys[i];
    if (!key.depth || *key.depth > 0) return tool.keys[i].time;
  }
  return tool.keys.back().time;
}

}  // namespace

bool hasWays(const Scenario& scenario) {
  return std::ranges::any_of(scenario.tools,
                             [](const ScenarioTool& tool) { return tool.way.has_value(); });
}

void placeWays(Scenario& scenario, std::size_t organ, const LaidOrgan& laid) {
  require(organ < scenario.organs.size(), "there is no organ {}; the scenario has {}", organ,
          scenario.organs.size());
  const std::string& name = scenario.organs[organ].source.name;
  Ground ground(laid, name);
  for (ScenarioTool& tool : scenario.tools)
    if (tool.way && (tool.way->organ == name || (tool.way->organ.empty() && organ == 0)))
      tool.keys = keysOf(*tool.way, ground, scenario.frameRate);
  endAfterKeys(scenario);
  requireSound(scenario);
}

void settleWays(Scenario& scenario, Simulation& simulation) {
  if (!hasWays(scenario) || !simulation.moves()) return;
  std::int64_t particles = 0;
  for (std::size_t i = 0; i < scenario.organs.size(); ++i)
    if (scenario.organs[i].tissue.elastic)
      particles += simulation.organs()[i].organ.rest.particleCount();
  if (particles > kMostSettled) return;
  double first = kSettling;  // s: when the first tool comes
  for (const ScenarioTool& tool : scenario.tools)
    if (!tool.keys.empty()) first = std::min(first, firstTouch(tool));
  FrameInput still;
  still.duration = 1 / scenario.frameRate;
  for (const ScenarioTool& tool : scenario.tools) still.tools.push_back({tool.rest, false, 1});
  const Bytes before = simulation.save();
  StepReport report;
  for (double time = still.duration; time < first; time += still.duration) {
    simulation.step(still, report);
    checkStop();
  }
  for (std::size_t i = 0; i < scenario.organs.size(); ++i) {
    const OperatedOrgan& o = simulation.organs()[i];
    if (!scenario.organs[i].tissue.elastic) continue;
    placeWays(
        scenario, i,
        {o.organ.surface.mesh(o.points()), o.organ.rest.landmarks, o.organ.rest.lattice.spacing});
  }
  simulation.restore(before);
}

}  // namespace resect
