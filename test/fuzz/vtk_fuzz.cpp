#include "formats/meshes/vtk_file.h"
#include "fuzz_target.h"

RESECT_FUZZ_TARGET(resect::readVtkFile("input.vtk", bytes))
