#include "formats/images/nifti_file.h"
#include "fuzz_target.h"

RESECT_FUZZ_TARGET(try {
  resect::readNiftiFile("input.nii", bytes);
} catch (const resect::LacksFile&){})
