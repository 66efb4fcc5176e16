#include "formats/meshes/off_file.h"
#include "fuzz_target.h"

RESECT_FUZZ_TARGET(resect::readOffFile("input.off", bytes))
