// Measures the speed of an operation on this machine, and the largest organ that keeps real time.
//
// An operation keeps real time if 95 % of its frames are computed within their duration.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/stage_clock.h"
#include "operation/run.h"
#include "operation/scenario.h"

namespace resect {

struct BenchReport {
  struct Stage {
    std::string name;
    TimeSummary time;
  };
  // Frames in which edits changed the surface.
  struct Updates {
    std::int64_t frames = 0, bricks = 0;  // bricks: evaluated again in these frames
    double seconds = 0;  // of the stages updateField and updateSurface in these frames
  };
  double spacing = 0;                                    // cube root of a cell's volume, m
  std::int64_t particles = 0, triangles = 0, bytes = 0;  // before the operation
  bool tissueMoves = false;
  std::int64_t frames = 0, missed = 0;  // missed: took longer than their duration
  double frameDuration = 0;             // s
  TimeSummary frame;                    // time of all stages together
  std::vector<Stage> stages;            // in the order of the step
  std::int64_t inHand = 0;              // frames with an instrument in hand
  Updates updates;
  std::int64_t substeps = 0;         // of tissue that moves
  double perParticleAndSubstep = 0;  // s, of the stage moveTissue; 0 for still tissue
  std::string instructionSet;        // of the kernels that move tissue
  std::uint64_t stateHash = 0;       // at the end, as of runScenario()

  double bytesPerParticle() const { return double(bytes) / double(particles); }
  bool realTime() const { return frame.p95 <= frameDuration; }
};

// Runs all frames of the scenario on a simulation made for it; nothing but the steps is timed.
BenchReport benchScenario(Simulation& simulation, const Scenario& scenario,
                          const FrameObserver& observer = {});

// Result of the search for the largest organ. Sizes are measured, not extrapolated.
struct RealTimeLimit {
  std::optional<BenchReport> holds;  // the largest organ measured that kept real time
  std::optional<BenchReport> fails;  // the smallest organ measured that did not
};

// Searches for the largest organ that keeps real time. `measure` runs the operation with another
// spacing, m; `first` is its result at the present spacing. At most `trials` more spacings are
// tried, with at most `mostParticles`. The search ends when the sizes that hold and fail are within
// 15 % of each other.
RealTimeLimit findRealTimeLimit(const BenchReport& first,
                                const std::function<BenchReport(double spacing)>& measure,
                                int trials = 4, double mostParticles = 1e6);

}  // namespace resect
