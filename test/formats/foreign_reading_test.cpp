// What a reader in its sandbox may have of the files beside its own.
#include "formats/child/foreign_reading.h"

#include <doctest/doctest.h>

#include <fstream>

#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

// What comes of a reader that asks for the file `name` and answers with what it is given.
std::string asking(const std::filesystem::path& path, const std::string& name) {
  std::string answer;
  const std::string refusal = test::sentenceOf([&] {
    answer = readForeign(path, {}, [&](const ForeignFile& file) {
      const auto found = file.beside.find(name);
      if (found == file.beside.end()) throw LacksFile{name};
      return std::string(found->second.data(), found->second.size());
    });
  });
  return refusal.empty() ? answer : refusal;
}

}  // namespace

TEST_CASE(
    "a reader that asks for a file beside its own gets buffers and voxels, and nothing else") {
  const test::TemporaryFolder folder;
  for (const char* name : {"model.gltf", "scan.mhd", "model.obj", "packed.gltf.gz", "a.bin",
                           "a.raw", "letter.txt", "id_rsa"})
    std::ofstream(folder / name) << "this is " << name;
  CHECK(asking(folder / "model.gltf", "a.bin") == "this is a.bin");
  CHECK(asking(folder / "packed.gltf.gz", "a.bin") == "this is a.bin");
  CHECK(asking(folder / "scan.mhd", "a.raw") == "this is a.raw");
  for (const char* model : {"model.gltf", "scan.mhd", "model.obj"})
    for (const char* name : {"letter.txt", "id_rsa", "model.obj"}) {
      CAPTURE(model);
      CAPTURE(name);
      CHECK(asking(folder / model, name).find("neither buffers nor voxels") != std::string::npos);
    }
  CHECK(asking(folder / "model.gltf", "a.raw").find("neither") != std::string::npos);
  CHECK(asking(folder / "scan.mhd", "a.bin").find("neither") != std::string::npos);
  CHECK(asking(folder / "scan.mhd", "../a.raw").find("not beside it") != std::string::npos);
}
