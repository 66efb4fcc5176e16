// Are the files known that belong to a model?
#include "formats/gltf_files.h"

#include <doctest/doctest.h>

#include "support/temporary_folder.h"

using namespace resect;
namespace fs = std::filesystem;

TEST_CASE("the files beside a .gltf model are known by the names in it") {
  const test::TemporaryFolder folder;
  const fs::path model =
      folder.write("a.gltf", R"({"buffers": [{"uri": "my%20buffer.bin"}, {"uri": "data:,x"}, {}, 7],
                    "images": [{"uri": "sub/skin.png"}]})");
  std::vector<fs::path> files = {folder / "none.gltf", model, folder.write("bad.gltf", "[[[{"),
                                 folder.write("b.obj", R"({"buffers": [{"uri": "c"}]})")};
  addFilesOfGltf(files);
  REQUIRE(files.size() == 6);
  CHECK(files[4] == folder / "my buffer.bin");
  CHECK(files[5] == folder / "sub/skin.png");
}
