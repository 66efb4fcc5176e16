#include "formats/meshes/obj_file.h"
#include "fuzz_target.h"

RESECT_FUZZ_TARGET(resect::readObjFile("input.obj", bytes))
