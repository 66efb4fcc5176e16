// Measures the speed of an operation on this machine. Also searches for the largest number of
// particles (cells of tissue) with which the operation keeps real time. For this, the organs are
// divided into smaller or larger cells.
//
// An operation keeps real time if the computation of at least 95 % of its frames takes no longer
// than the duration of a frame.
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
    std::int64_t frames = 0, bricks = 0;  // bricks: number of bricks evaluated again
    double seconds = 0;  // time of the stages updateField and updateSurface in these frames
  };
  double spacing = 0;  // cube root of a cell's volume in the first organ, m
  // Counts before the operation. bytes: memory that the simulation holds at that time.
  std::int64_t particles = 0, triangles = 0, bytes = 0;
  bool tissueMoves = false;
  // missed: number of frames whose computation took longer than frameDuration.
  std::int64_t frames = 0, missed = 0;
  double frameDuration = 0;   // s
  TimeSummary frame;          // computing time of a frame: sum of all stages
  std::vector<Stage> stages;  // in the order in which a step runs them
  std::int64_t inHand = 0;    // number of frames with an instrument in hand
  Updates updates;
  std::int64_t substeps = 0;         // time steps of the tissue's motion, sum over all organs
  double perParticleAndSubstep = 0;  // mean time in the stage moveTissue per particle and substep,
                                     // s; 0 for still tissue
  std::string instructionSet;        // used by the kernels that compute the tissue's motion
  std::uint64_t stateHash = 0;       // at the end; as RunSummary::stateHash

  double bytesPerParticle() const { return double(bytes) / double(particles); }
  bool realTime() const { return frame.p95 <= frameDuration; }
};

// Runs all frames of the scenario. simulation: made from this scenario, and not yet stepped. Only
// the steps are timed. observer: called after each frame (operation/run.h).
BenchReport benchScenario(Simulation& simulation, const Scenario& scenario,
                          const FrameObserver& observer = {});

// Result of the search for the largest number of particles. All figures are measured; none is
// extrapolated.
struct RealTimeLimit {
  std::optional<BenchReport> holds;  // most particles measured that kept real time
  std::optional<BenchReport> fails;  // fewest particles measured that did not keep real time
};

// Searches for the largest number of particles that keeps real time. first: the report of a run
// with the scenario's own spacing (length of a cell's side). measure: runs the operation with
// another spacing, m, and reports. Tries at most `trials` other spacings, and at most
// `mostParticles` particles. The search ends earlier if `fails` has at most 15 % more particles
// than `holds`, or if the next number of particles would differ by less than 2 % from the previous
// number.
RealTimeLimit findRealTimeLimit(const BenchReport& first,
                                const std::function<BenchReport(double spacing)>& measure,
                                int trials = 4, double mostParticles = 1e6);

}  // namespace resect
