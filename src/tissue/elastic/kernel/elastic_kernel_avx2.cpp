// The passes of tissue/elastic/kernel/elastic_kernel.inl compiled for one instruction set.
#include "tissue/elastic/kernel/elastic_kernel.h"
#include "tissue/elastic/kernel/elastic_kernels.h"

#if defined(__x86_64__)
#pragma GCC target("avx2")
namespace resect::avx2 {

constexpr int kLanes = 8;
#include "tissue/elastic/kernel/elastic_kernel.inl"

}  // namespace resect::avx2

namespace resect {

const ElasticKernel& avx2Kernel() {
  static constexpr ElasticKernel kKernel = {"avx2", avx2::stressPass, avx2::motionPass,
                                            avx2::placements};
  return kKernel;
}

}  // namespace resect
#endif
