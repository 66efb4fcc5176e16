// The passes of tissue/elastic/kernel/elastic_kernel.inl compiled for one instruction set.
#include "tissue/elastic/kernel/elastic_kernel.h"
#include "tissue/elastic/kernel/elastic_kernels.h"

namespace resect::baseline {

constexpr int kLanes = 4;
#include "tissue/elastic/kernel/elastic_kernel.inl"

}  // namespace resect::baseline

namespace resect {

const ElasticKernel& baselineKernel() {
  static constexpr ElasticKernel kKernel = {"baseline", baseline::stressPass, baseline::motionPass,
                                            baseline::placements};
  return kKernel;
}

}  // namespace resect
