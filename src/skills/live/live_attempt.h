// An attempt in progress: whether the goal is reached, what to do next, and where the places of the
// goal are in the moving tissue.
//
// When work is taken back, a LiveAttempt forgets only a part of that work
// (AttemptReader::rewind()). An attempt in which work was taken back is therefore scored from its
// recording (read_attempt.h).
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
  double time = 0;       // s since the start; 0: nothing is known yet
  bool reached = false;  // whether the goal is reached
  double since = 0;      // when the goal was reached, s since the start; 0: not reached
  std::string next;      // what to do next, a sentence
  // Time from the first bleeding until now, s. If the task's goal is to stop the bleeding, this
  // time ends when the bleeding is stopped. None: nothing has bled.
  std::optional<double> bleeding;
  double rested = 0;       // s since an instrument was last in hand
  std::size_t target = 0;  // number of the next target, from 0
  // places: GoalWatch::present(), world, m. normals: the surface's normals at `places`, unit.
  std::vector<Vec3> places;
  std::vector<Vec3> normals;
  // structure: mean of the present cell centres of the goal's structure, world, m. structureRadius:
  // largest distance of a cell centre from this mean, m.
  std::optional<Vec3> structure;
  double structureRadius = 0;
};

class LiveAttempt : public std::enable_shared_from_this<LiveAttempt> {
 public:
  // scenario: has a task. simulation: in its state before the operation. Throws Error if the organ
  // lacks what the task names.
  LiveAttempt(const Scenario& scenario, const Simulation& simulation);

  // Returns a watch, a set of callbacks, for the operation. Each of its callbacks first calls the
  // same callback of `next`, and then updates this object. The watch keeps this object alive.
  OperationWatch watch(OperationWatch next);
  // May be called from any thread. The result changes ten times per simulated second.
  AttemptProgress progress() const;
  // The attempt up to a frame, as readAttempt() would make it from the recording, with one
  // difference: VesselStory::bled has the values at the time of the call. After this call the
  // operation is not followed any more. frames: number of frames since the start that belong to the
  // attempt. No instrument may have been in hand in later frames. simulation: the operation's
  // simulation, which must not step during the call. No result if work was taken back. Cost: up to
  // a second (AttemptReader::measureMargins()).
  std::optional<Attempt> end(std::int64_t frames, const Simulation& simulation);

 private:
  void began(const Branch& branch);
  void stepped(Moment moment, const StepReport& report, std::span<const OperationEvent> events,
               const Simulation& simulation);
  void publish(const Simulation& simulation);

  Attempt attempt_;
  AttemptReader reader_;
  std::size_t organ_ = 0;
  std::vector<std::int64_t> structure_;  // cells of the goal's structure
  std::int64_t every_;                  // number of frames from one update of progress_ to the next
  std::vector<OperationEvent> events_;  // a tip enters or leaves the picture, a tool is put back
  bool ended_ = false;                  // by end()
  std::int64_t branch_ = 0;             // number of the branch that is followed
  bool lost_ = false;                   // whether the operation went on in another branch
  std::optional<double> reachedSince_;  // time when the goal was reached, s since the start
  double worked_ = 0;                   // time when an instrument was last in hand, s
  mutable std::mutex mutex_;            // guards progress_
  AttemptProgress progress_;
};

}  // namespace resect
