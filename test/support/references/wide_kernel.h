// The passes of elastic tissue for vectors of sixteen cells, as AVX-512 has them, on any machine.
#pragma once

#include "tissue/elastic/kernel/elastic_kernel.h"

namespace resect::test {

const ElasticKernel& wideKernel();

}  // namespace resect::test
