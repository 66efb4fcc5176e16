#include "formats/meshes/ply_file.h"
#include "fuzz_target.h"

RESECT_FUZZ_TARGET(resect::readPlyFile("input.ply", bytes))
