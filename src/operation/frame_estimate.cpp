#include "operation/frame_estimate.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "tissue/elastic/elastic_tissue.h"

namespace resect {
namespace {

constexpr double kSecondsPerSubstep = 380e-9;  // and chunk of cells, on one thread

struct Work {
  double substeps = 0;  // of the tissue with the most
  double seconds = 0;
};

Work workOf(const Simulation& simulation, double duration) {
  Work work;
  for (const OperatedOrgan& o : simulation.organs()) {
    const auto* elastic = dynamic_cast<const ElasticTissue*>(o.tissue.get());
    if (!elastic) continue;
    const double substeps = std::ceil(duration / elastic->longestSubstep());
    const std::size_t most = elastic->settings().threads > 0
                                 ? std::size_t(elastic->settings().threads)
                                 : threadsAllowed();
    work.substeps = std::max(work.substeps, substeps);
    work.seconds += substeps * double(elastic->state().chunks.size()) * kSecondsPerSubstep /
                    double(std::min(most, threadsAllowed()));
  }
  return work;
}

}  // namespace

double expectedFrameSeconds(const Simulation& simulation, double duration) {
  return workOf(simulation, duration).seconds;
}

std::string paceNote(const Simulation& simulation, double duration) {
  const double seconds = workOf(simulation, duration).seconds;
  return fmt::format("a frame of {:.3g} ms will take about {:.2g} ms: {}", 1e3 * duration,
                     1e3 * seconds,
                     seconds <= duration ? "real time"
                                         : "slower than real time, for its thin walls need "
                                           "small cells; a larger --spacing is faster");
}

std::string slowFrameNote(const Simulation& simulation, double duration) {
  const Work work = workOf(simulation, duration);
  if (!(work.seconds > kSlowFrame)) return "";
  return fmt::format(
      "each frame will take about {:.2g} s, for its {:.2g} substeps; for fewer give softer tissue "
      "(young, poisson), denser "
      "tissue, larger cells (spacing) or more frames a second (frame_rate)",
      work.seconds, work.substeps);
}

}  // namespace resect
