// The smoke over tissue that boils, for viewers: puffs that rise, widen and fade.
//
// The smoke is only drawn; it has no effect on the simulation. It is computed from the reports of
// the steps (StepReport::smoke) and from simulated time, so the same frames give the same smoke.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/aabb.h"
#include "simulation/simulation.h"

namespace resect {

// The smoke that arises within about 1/30 s.
struct SmokePuff {
  Vec3 from = Vec3::Zero();  // where it began, world, m
  double began = 0;          // simulated time, s
  double strength = 0;       // 0 to 1
};

struct SmokePlume {
  std::vector<SmokePuff> puffs;  // the oldest first
};

// Call this after every step: adds the smoke of the step, and removes puffs that have faded. time:
// simulated time at the end of the step, s. duration: of the step, s.
void followSmoke(SmokePlume& plume, std::span<const Smoke> smoke, double time, double duration);

// Smoke as it is drawn: a soft ball.
struct SmokeBall {
  Vec3f centre = Vec3f::Zero();  // world, m
  float radius = 0;              // m
  float density = 0;             // opacity at the centre of the ball, 0 to 1
};

// The plume at a time, s.
std::vector<SmokeBall> smokeBalls(const SmokePlume& plume, double time);
Aabb smokeBox(std::span<const SmokeBall> balls);  // round all balls; world, m

}  // namespace resect
