// The passes of tissue/elastic/kernel/elastic_kernel.inl compiled for one instruction set.
#include "tissue/elastic/kernel/elastic_kernel.h"
#include "tissue/elastic/kernel/elastic_kernels.h"

#if defined(__x86_64__)
#pragma GCC target("avx512f,avx512vl,avx512dq,avx512bw,prefer-vector-width=512")
namespace resect::avx512 {

constexpr int kLanes = 16;
#include "tissue/elastic/kernel/elastic_kernel.inl"

}  // namespace resect::avx512

namespace resect {

const ElasticKernel& avx512Kernel() {
  static constexpr ElasticKernel kKernel = {"avx512", avx512::stressPass, avx512::motionPass,
                                            avx512::placements};
  return kKernel;
}

}  // namespace resect
#endif
