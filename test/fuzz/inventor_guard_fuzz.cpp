#include "fuzz_target.h"
#include "inventor/reading/iv_guard.h"

RESECT_FUZZ_TARGET(resect::guardInventorFile("input.iv", bytes))
