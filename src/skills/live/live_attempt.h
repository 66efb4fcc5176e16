// An attempt while somebody works on it: whether the goal is reached, what is next, and where the
// places of the goal are in the moving tissue.
//
// The attempt is scored from its recording (read_attempt.h) and not from this, which forgets what
// was taken back only in part.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "operation/live/live_operation.h"
#include "skills/attempt/attempt_reader.h"

namespace resect {

struct AttemptProgress {
  double time = 0;                 // s from the start; 0: nothing is known yet
  bool reached = false;            // the goal
  double since = 0;                // s from the start: for so long it has been reached
  std::string next;                // what to do next, a sentence
  std::optional<double> bleeding;  // s: for so long it has bled, or bled until it was stopped
  double rested = 0;               // s: for so long no instrument has been at work
  std::size_t target = 0;          // number of the target that is next, from 0
  std::vector<Vec3> places;        // targets, plane or line; world, m
  std::vector<Vec3> normals;       // of the surface there, unit
  // The structure of the goal: its middle, and how far it reaches from there; world, m.
  std::optional<Vec3> structure;
  double structureRadius = 0;
};

class LiveAttempt : public std::enable_shared_from_this<LiveAttempt> {
 public:
  // scenario: with a task; simulation: before the operation. Throws Error if the organ lacks what
  // the task names.
  LiveAttempt(const Scenario& scenario, const Simulation& simulation);

  // What tells this object of the operation, after `next` was told. It keeps this object alive.
  OperationWatch watch(OperationWatch next);
  // From any thread. Renewed ten times a second.
  AttemptProgress progress() const;

 private:
  void began(const Branch& branch);
  void stepped(Moment moment, const StepReport& report, const Simulation& simulation);
  void publish(const Simulation& simulation);

  Attempt attempt_;
  AttemptReader reader_;
  std::size_t organ_ = 0;
  std::vector<std::int64_t> structure_;  // cells of the goal's structure
  std::int64_t every_;                   // frames from one progress to the next
  std::int64_t branch_ = 0;              // that is followed
  bool lost_ = false;                    // the operation went on where this object has not been
  std::optional<double> reachedSince_;   // s from the start
  double worked_ = 0;                    // s: when an instrument was at work last
  mutable std::mutex mutex_;             // guards what follows
  AttemptProgress progress_;
};

}  // namespace resect
