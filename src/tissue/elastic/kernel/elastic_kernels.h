// The compiled kernels. Each kernel runs only on machines that have its instructions.
#pragma once

#include "tissue/elastic/kernel/elastic_kernel.h"

namespace resect {

const ElasticKernel& baselineKernel();  // runs on every machine that the build is for
const ElasticKernel& avx2Kernel();
const ElasticKernel& avx512Kernel();

}  // namespace resect
