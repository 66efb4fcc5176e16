// Follows how near the instruments come to a goal's targets, line or plane.
#pragma once

#include <vector>

#include "operation/scenario.h"
#include "simulation/simulation.h"
#include "skills/attempt/attempt.h"
#include "skills/attempt/goal_places.h"

namespace resect {

class GoalWatch {
 public:
  // simulation: in its state before the operation. Throws Error if the organ lacks what the goal
  // names.
  GoalWatch(const TaskGoal& goal, const Scenario& scenario, const Simulation& simulation);
  // To be called after each step, when the frame's ToolMoments are in the attempt.
  void add(const Simulation& simulation, Attempt& attempt);
  // Forgets all but the first `frames` frames.
  void rewind(std::size_t frames, Attempt& attempt) const;

  // Positions in the world after the last frame. They are the positions of the targets, or of the
  // point through which the task's plane is laid, or of points along the task's line. Empty before
  // the first frame.
  const std::vector<TissuePoint>& present() const { return present_; }

 private:
  bool counts(const InstrumentRecord& instrument) const;
  void addDistances(Attempt& attempt) const;
  void addWork(const Simulation& simulation, Attempt& attempt) const;

  const TaskGoal goal_;
  std::size_t organ_ = 0;
  // At rest: the targets, the point of the plane, or points along the line every few mm.
  std::vector<TissuePoint> points_;
  std::vector<TissuePoint> present_;  // these points in the world, now
  std::vector<double> along_;  // per point: distance along the line from its beginning, at rest, m
  bool begun_ = false;         // whether an instrument has worked
};

// Index of the organ that a goal is about.
std::size_t goalOrgan(const TaskGoal& goal, const Scenario& scenario);

}  // namespace resect
