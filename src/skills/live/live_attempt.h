// An attempt in progress: whether the goal is reached, what to do next, and where the places of the
// goal are in the moving tissue.
//
// When work is taken back, a LiveAttempt forgets only a part of it (AttemptReader::rewind()). So
// the final score is computed from the recording (read_attempt.h) instead.
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
  bool reached = false;            // whether the goal is reached
  double since = 0;                // s from the start: when it was reached; 0: it is not reached
  std::string next;                // what to do next, a sentence
  std::optional<double> bleeding;  // s of bleeding, to now or to its stop; none: no bleeding
  double rested = 0;               // s since an instrument was last in hand
  std::size_t target = 0;          // number of the next target, from 0
  std::vector<Vec3> places;        // targets, plane or line; world, m
  std::vector<Vec3> normals;       // of the surface there, unit
  // The goal's structure: mean of its present cell centres (world), and the largest distance of a
  // cell centre from there; m.
  std::optional<Vec3> structure;
  double structureRadius = 0;
};

class LiveAttempt : public std::enable_shared_from_this<LiveAttempt> {
 public:
  // scenario: with a task; simulation: before the operation. Throws Error if the organ lacks what
  // the task names.
  LiveAttempt(const Scenario& scenario, const Simulation& simulation);

  // Returns a watch for the operation. It calls `next` first, then informs this object, which it
  // keeps alive.
  OperationWatch watch(OperationWatch next);
  // May be called from any thread. The result changes ten times per simulated second.
  AttemptProgress progress() const;

 private:
  void began(const Branch& branch);
  void stepped(Moment moment, const StepReport& report, const Simulation& simulation);
  void publish(const Simulation& simulation);

  Attempt attempt_;
  AttemptReader reader_;
  std::size_t organ_ = 0;
  std::vector<std::int64_t> structure_;  // cells of the goal's structure
  std::int64_t every_;                   // frames from one update of progress_ to the next
  std::int64_t branch_ = 0;              // number of the branch that is followed
  bool lost_ = false;                    // whether the operation went on in another branch
  std::optional<double> reachedSince_;   // s from the start
  double worked_ = 0;                    // s: when an instrument was last in hand
  mutable std::mutex mutex_;             // guards progress_
  AttemptProgress progress_;
};

}  // namespace resect
