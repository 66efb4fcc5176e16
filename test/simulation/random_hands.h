// Hands that work at random on an organ with four instruments: press, drag, hook, cut, snip, drive
// through, and are elsewhere at once.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "geometry/resting_pose.h"
#include "organ/builtin/builtin_liver.h"
#include "simulation/simulation.h"
#include "support/test_tools.h"

namespace resect::test {

// Of about the size and the response of those in data/tools; handles along Z.
inline std::vector<std::unique_ptr<Tool>> instruments() {
  std::vector<std::unique_ptr<Tool>> tools;
  const auto add = [&](const char* kind, TriangleMesh mesh, auto describe) {
    tools.push_back(test::describedTool(kind, std::move(mesh), describe));
  };
  add("scalpel", boxMesh({{-0.0003, -0.008, 0}, {0.0003, 0.003, 0.15}}), [](ToolModel& m) {
    m.edge = {{0, -0.008, 0}, {0, -0.0082, 0.02}, {0, -0.008, 0.04}};
    m.bluntness = 0.2;  // so that it cuts, wherever it passes
  });
  add("hook", boxMesh({{-0.0015, -0.0015, 0}, {0.0015, 0.0015, 0.15}}), [](ToolModel& m) {
    m.hook = {{0, -0.01, 0.01}, {0, 0, 0}, {0, 0.01, 0.01}};
    m.slipForce = 1.2;
  });
  add("baton", boxMesh({{-0.006, -0.006, 0}, {0.006, 0.006, 0.15}}), [](ToolModel&) {});
  add("scissors", boxMesh({{-0.0005, -0.002, 0.04}, {0.0005, 0.002, 0.15}}), [](ToolModel& m) {
    m.edge = {{0, 0, 0}, {0, 0, 0.02}, {0, 0, 0.04}};
    m.jaws = {{0, 0, 0.045}, Vec3::UnitX(), 0.6};
    m.bluntness = 0.2;
  });
  return tools;
}

// One piece of work: an instrument moves along straight lines without turning, or is somewhere else
// at once.
struct Act {
  int tool;
  Eigen::Quaterniond rotation;
  std::vector<Vec3> way;
  double speed;    // m/s
  double squeeze;  // closings per second
};

inline Act randomAct(Random& random, int tools, const Aabb& organ) {
  const auto within = [&](double low, double high) {
    return Vec3(random.uniform(organ.min.x(), organ.max.x()),
                random.uniform(low, high) * organ.max.y(),
                random.uniform(organ.min.z(), organ.max.z()));
  };
  Act act;
  act.tool = random.below(tools);
  const double tilt = random.uniform(0, 1), turn = random.uniform(0, 2 * std::numbers::pi);
  act.rotation = Eigen::AngleAxisd(turn, Vec3::UnitY()) *
                 Eigen::AngleAxisd(tilt - 0.5 * std::numbers::pi, Vec3::UnitX());
  act.way = {within(1.4, 1.6)};
  act.way.push_back(within(0.1, 0.9));
  for (int i = random.below(3); i > 0; --i)
    act.way.push_back(act.way.back() + 0.06 * (within(0, 1) - within(0, 1)).normalized());
  act.way.push_back(within(1.4, 1.6));
  act.speed = random.below(8) == 0 ? 1 : random.uniform(0.05, 0.4);
  act.squeeze = random.uniform(0.5, 3);
  return act;
}

// One hand after another, each with one instrument; the others lie far away.
class RandomHands {
 public:
  RandomHands(Random& random, int tools, const Aabb& organ)
      : random_(random), tools_(tools), organ_(organ) {}

  // The next frame; time: before it, s. works: false while the organ comes to lie.
  FrameInput next(double time, bool works) {
    FrameInput input;
    input.tools.assign(std::size_t(tools_), {{Vec3(0, 1, 0), {1, 0, 0, 0}}, false, 0});
    moved_ = Vec3::Zero();
    jumps_ = false;
    if (!works) return input;
    jumps_ = leg_ + 1 >= act_.way.size();
    if (jumps_) {
      act_ = randomAct(random_, tools_, organ_);
      leg_ = 0;
      ++acts_;
      // Sometimes inside the tissue at once.
      at_ = act_.way[random_.below(10) == 0 ? 1 : 0];
    } else {
      const Vec3 left = act_.way[leg_ + 1] - at_;
      const double step = act_.speed / 60;
      moved_ = left.norm() <= step ? left : Vec3(left * (step / left.norm()));
      at_ += moved_;
      if (left.norm() <= step) ++leg_;
    }
    const double phase = std::fmod(time * act_.squeeze, 1.0);
    input.tools[std::size_t(act_.tool)] = {{at_, act_.rotation}, true, std::abs(2 * phase - 1)};
    return input;
  }

  int tool() const { return act_.tool; }
  const Vec3& moved() const { return moved_; }  // the instrument, in the frame, m
  bool jumps() const { return jumps_; }         // in the frame it is somewhere else at once
  std::int64_t acts() const { return acts_; }

 private:
  Random& random_;
  int tools_;
  Aabb organ_;
  Act act_{};
  std::size_t leg_ = 0;
  Vec3 at_ = Vec3::Zero(), moved_ = Vec3::Zero();
  bool jumps_ = false;
  std::int64_t acts_ = 0;
};

// The built-in liver as it lies on the table, with what turned and lifted it.
struct LyingLiver {
  TriangleMesh mesh;
  Pose pose;
};
inline LyingLiver lyingLiver() {
  LyingLiver liver{builtinLiver(0.004), {}};
  liver.pose.rotation = restingRotation(liver.mesh);
  for (Vec3& p : liver.mesh.points) p = liver.pose.rotation * p;
  liver.pose.position.y() = 0.001 - bounds(liver.mesh).min.y();
  for (Vec3& p : liver.mesh.points) p += liver.pose.position;
  return liver;
}

}  // namespace resect::test
