// The compiled kernels. Each runs only on a machine that has its instructions.
#pragma once

#include "tissue/elastic/kernel/elastic_kernel.h"

namespace resect {

const ElasticKernel& baselineKernel();  // what every machine of the build's target has
const ElasticKernel& avx2Kernel();
const ElasticKernel& avx512Kernel();

}  // namespace resect
