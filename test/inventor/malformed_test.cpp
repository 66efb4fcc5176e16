#include <doctest/doctest.h>
#include <sys/stat.h>

#include "base/error.h"
#include "geometry/measures.h"
#include "geometry/primitives.h"
#include "inventor/reading/iv_reader.h"
#include "inventor/reading/model_file.h"
#include "io/mesh_file.h"
#include "io/organ_mesh.h"
#include "support/malformed/malformed.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

// One clear sentence: says which file, is one line, and ends neither in nothing nor in a dump.
void checkSentence(const std::string& text, const std::string& name) {
  CHECK_MESSAGE(text.find(name) != std::string::npos, text);
  CHECK_MESSAGE(text.find('\n') == std::string::npos, text);
  CHECK_MESSAGE(text.size() > name.size() + 20, text);
  CHECK_MESSAGE(text.size() < 2000, text);
}

struct Outcome {
  int refused = 0, fine = 0, killed = 0;
};

// Reads each file, makes an organ of it and writes that; what is refused must leave nothing behind.
Outcome readAll(const std::vector<test::BadFile>& files) {
  Outcome outcome;
  for (const test::BadFile& file : files) {
    CAPTURE(file.name);
    const test::TemporaryFolder in, out;
    const auto path = in.write(file.name, file.bytes);
    bool read = false;
    try {
      // The files are small; one second finds those that would never end.
      const Model model = readModelWithin(path, 0.9);
      read = true;
      CHECK_MESSAGE(file.mayBeFine, "was read without complaint: " << file.name);
      ++outcome.fine;
      OrganMeshOptions options;
      options.repair = true;
      writeMeshFile(out / "organ.obj", prepareOrganMesh(model, options).mesh);
    } catch (const Error& e) {
      checkSentence(e.what(), file.name);
      if (!read) ++outcome.refused;
      if (std::string(e.what()).find("the reader stopped on it") != std::string::npos) {
        ++outcome.killed;
        MESSAGE(
            "killed its reader: " << std::string(e.what()).substr(in.path().string().size() + 1));
      }
      CHECK(std::filesystem::is_empty(out.path()));
    }
    // The reader leaves nothing beside its file either.
    CHECK(std::distance(std::filesystem::directory_iterator(in.path()), {}) == 1);
  }
  MESSAGE(files.size() << " files: " << outcome.refused << " refused, " << outcome.fine << " read, "
                       << outcome.killed << " killed their reader");
  return outcome;
}

}  // namespace

TEST_CASE("malformed Inventor and VRML files end in a sentence") {
  // Binary files are not looked into before Coin does; one nested 100 000 deep overflows its stack.
  CHECK(readAll(test::malformedInventorFiles()).killed <= 1);
}

TEST_CASE("malformed mesh files end in a sentence") {
  CHECK(readAll(test::malformedMeshFiles()).killed == 0);
}

TEST_CASE("malformed compressed files end in a sentence") {
  CHECK(readAll(test::malformedGzipFiles()).killed == 0);
}

TEST_CASE("the cube that is damaged for these tests is a cube") {
  CHECK(volume(merged(readInventorFile("cube.iv", test::binaryInventorCube()))) ==
        doctest::Approx(1));
}

TEST_CASE("a file that is cut off anywhere never becomes an organ") {
  const test::TemporaryFolder folder;
  for (const char* name : {"ball.obj", "ball.stl", "ball.ply", "ball.vtk", "ball.iv"}) {
    const TriangleMesh ball = sphereMesh({0, 0, 0}, 0.1, 8);
    writeMeshFile(folder / name, ball);
    CHECK(prepareOrganMesh(readModel(folder / name)).health.closed);
    const std::string whole = test::bytesOf(folder / name);
    for (std::size_t tenth = 1; tenth < 10; ++tenth) {
      CAPTURE(name);
      CAPTURE(tenth);
      const auto cut =
          folder.write(std::string("cut_") + name, whole.substr(0, whole.size() * tenth / 10));
      CHECK_THROWS_AS(prepareOrganMesh(readModel(cut)), Error);
    }
  }
}

TEST_CASE("what is no file at all ends in a sentence") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "folder.iv");
  REQUIRE(::mkfifo((folder / "pipe.iv").c_str(), 0600) == 0);
  std::filesystem::create_symlink(folder / "loop.iv", folder / "loop.iv");
  for (const char* name : {"folder.iv", "pipe.iv", "loop.iv", "missing.iv"}) {
    CAPTURE(name);
    try {
      readModel(folder / name);
      FAIL("no error");
    } catch (const Error& e) {
      checkSentence(e.what(), name);
    }
  }
}
