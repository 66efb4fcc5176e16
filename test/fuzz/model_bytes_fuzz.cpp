#include "fuzz_target.h"
#include "io/model.h"

RESECT_FUZZ_TARGET(resect::bytesToModel(bytes, "input"))
