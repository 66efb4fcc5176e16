#include "formats/images/meta_image_file.h"
#include "fuzz_target.h"

RESECT_FUZZ_TARGET(try {
  resect::readMetaImageFile("input.mha", bytes);
} catch (const resect::LacksFile&){})
