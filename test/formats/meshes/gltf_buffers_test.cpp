// Are the files known that may belong to a model?
#include "formats/meshes/gltf_buffers.h"
#include "formats/beside_files.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/temporary_folder.h"

using namespace resect;
namespace fs = std::filesystem;

TEST_CASE("the files that a .gltf's reader may be given are those beside it") {
  const test::TemporaryFolder folder;
  std::vector<fs::path> files = {folder.write("a.gltf", "{}"), folder.write("b.obj", "")};
  const fs::path buffer = folder.write("my buffer.bin", ""), other = folder.write("c.glbin", "");
  folder.write("picture.png", "");
  addFilesBeside(files);
  REQUIRE(files.size() == 4);
  CHECK(std::ranges::find(files, buffer) != files.end());
  CHECK(std::ranges::find(files, other) != files.end());

  std::vector<fs::path> none = {folder / "b.obj", folder / "nowhere" / "d.gltf"};
  addFilesBeside(none);
  CHECK(none.size() == 2);
}

TEST_CASE("a .gltf and its buffers are known by endings in upper and lower case") {
  CHECK(isGltf("a.GLTF"));
  CHECK(isGltf("b.gltf"));
  CHECK(!isGltf("c.glb"));
  CHECK(isGltfBuffer("d.Bin"));
  CHECK(isGltfBuffer("e.GLBUF"));
  CHECK(!isGltfBuffer("f.gltf"));
  const test::TemporaryFolder folder;
  std::vector<fs::path> files = {folder.write("model.GLTF", "{}")};
  const fs::path buffer = folder.write("model.BIN", "");
  addFilesBeside(files);
  REQUIRE(files.size() == 2);
  CHECK(files[1] == buffer);
}
