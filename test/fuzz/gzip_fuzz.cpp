#include "formats/gzip.h"
#include "fuzz_target.h"

RESECT_FUZZ_TARGET(resect::unpackGzip("input.gz", bytes, std::size_t(1) << 24))
