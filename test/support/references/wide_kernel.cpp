#include "support/references/wide_kernel.h"

namespace resect::wide {

constexpr int kLanes = 16;
#include "tissue/elastic/kernel/elastic_kernel.inl"

}  // namespace resect::wide

namespace resect::test {

const ElasticKernel& wideKernel() {
  static constexpr ElasticKernel kKernel = {"wide", wide::stressPass, wide::motionPass,
                                            wide::placements};
  return kKernel;
}

}  // namespace resect::test
