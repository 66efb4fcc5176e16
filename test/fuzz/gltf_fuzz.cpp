#include "formats/meshes/gltf_requirements.h"
#include "fuzz_target.h"

namespace {

// What is done before the library reads the file. A buffer in another file is no fault of it.
void read(std::string_view bytes) {
  try {
    resect::plainGltf("input.gltf", bytes, {});
  } catch (const resect::LacksFile&) {
  }
}

}  // namespace

RESECT_FUZZ_TARGET(read(bytes))
