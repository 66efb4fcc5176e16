#include "tissue/elastic/kernel/elastic_kernel.h"

#include <array>
#include <string_view>

#include "tissue/elastic/kernel/elastic_kernels.h"

namespace resect {
namespace {

#if defined(__x86_64__)
bool hasAvx2() { return __builtin_cpu_supports("avx2"); }
bool hasAvx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
}
#endif

}  // namespace

const ElasticKernel& fastestKernel() {
#if defined(__x86_64__)
  if (hasAvx512()) return avx512Kernel();
  if (hasAvx2()) return avx2Kernel();
#endif
  return baselineKernel();
}

const ElasticKernel* kernelNamed(const char* name) {
  const std::string_view wanted = name;
#if defined(__x86_64__)
  if (wanted == "avx512" && hasAvx512()) return &avx512Kernel();
  if (wanted == "avx2" && hasAvx2()) return &avx2Kernel();
#endif
  if (wanted == "baseline") return &baselineKernel();
  return nullptr;
}

}  // namespace resect
