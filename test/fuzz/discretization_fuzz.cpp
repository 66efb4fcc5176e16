#include "fuzz_target.h"
#include "io/cells/discretization_file.h"

RESECT_FUZZ_TARGET(resect::parseDiscretization(bytes, "input.dis"))
