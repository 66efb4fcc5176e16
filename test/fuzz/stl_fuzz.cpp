#include "formats/meshes/stl_file.h"
#include "fuzz_target.h"

RESECT_FUZZ_TARGET(resect::readStlFile("input.stl", bytes))
