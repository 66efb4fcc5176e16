#include "fuzz_target.h"
#include "io/plain_mesh.h"

RESECT_FUZZ_TARGET(resect::parsePlainMesh(bytes, "input.ply"))
