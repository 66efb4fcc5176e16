#include "formats/images/nrrd_file.h"
#include "fuzz_target.h"

RESECT_FUZZ_TARGET(try {
  resect::readNrrdFile("input.nrrd", bytes);
} catch (const resect::LacksFile&){})
