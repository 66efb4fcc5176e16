// Does an output get where its name leads, and spare what it should?
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "io/mesh_file.h"
#include "io/output/atomic_file.h"
#include "io/output/output_target.h"
#include "io/output/run_files.h"
#include "io/output/temporary_file.h"
#include "io/scenario/scenario_file.h"
#include "io/scenario/scenario_files.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;
using test::bytesOf;
using test::refuses;
using test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

void writeText(const fs::path& path, const std::string& text) {
  writeFileAtomically(path, [&](std::ostream& out) { out << text; });
}

int filesIn(const TemporaryFolder& folder) {
  return int(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("a file is replaced as a whole or not at all, and nothing is left beside it") {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  fs::permissions(file, fs::perms(0604));
  const std::string large(1'000'000, 'x');
  writeText(file, large + "end");
  CHECK(bytesOf(file) == large + "end");
  CHECK(fs::status(file).permissions() == fs::perms(0604));
  CHECK_THROWS_AS(writeFileAtomically(file,
                                      [&](std::ostream& out) {
                                        out << large;
                                        throw error("no more of it; try again");
                                      }),
                  Error);
  CHECK(refuses(
      [&] {
        writeFileAtomically(file, [](std::ostream& out) { out.setstate(std::ios::failbit); });
      },
      "a.txt"));
  CHECK(bytesOf(file).size() == large.size() + 3);
  CHECK(filesIn(folder) == 1);
  writeText(folder / "new/deep/b.txt", "b");
  CHECK(bytesOf(folder / "new/deep/b.txt") == "b");
}

TEST_CASE("nobody else may read a file before it has the permissions of the one it replaces") {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  fs::permissions(file, fs::perms(0600));
  const TemporaryFile temporary(file);
  struct stat made {};
  REQUIRE(::fstat(temporary.descriptor(), &made) == 0);
  CHECK((made.st_mode & 0777) == 0600);
}

TEST_CASE("a link stays, a pipe and a device are written into") {
  const TemporaryFolder folder;
  const fs::path real = folder.write("real", "old"), link = folder / "link", pipe = folder / "pipe";
  fs::create_symlink("real", link);
  writeText(link, "new");
  CHECK(fs::is_symlink(link));
  CHECK(bytesOf(real) == "new");

  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::string got;
  std::thread reader([&] { got = bytesOf(pipe); });
  writeText(pipe, "through");
  reader.join();
  CHECK(got == "through");
  CHECK(fs::is_fifo(pipe));

  CHECK(findTarget("/dev/null").kind == OutputTarget::Kind::Stream);
  CHECK(refuses([] { writeText("/dev/full", "a"); }, "No space left"));
  CHECK(fs::is_character_file("/dev/full"));
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  writeText(fmt::format("/dev/fd/{}", ends[1]), "a");
  char byte = 0;
  CHECK(::read(ends[0], &byte, 1) == 1);
  CHECK(byte == 'a');
  CHECK(
      refuses([&] { writeText(fmt::format("/dev/fd/{}", ends[0]), "a"); }, "not open for writing"));
  ::close(ends[0]);
  ::close(ends[1]);
  CHECK(filesIn(folder) == 3);
}

TEST_CASE("what cannot be written is said before the work") {
  const TemporaryFolder folder;
  const fs::path file = folder.write("file", "old");
  fs::create_symlink("gone", folder / "nowhere");
  fs::create_symlink("circle", folder / "circle");
  CHECK(refuses([] { findTarget(""); }, "empty"));
  CHECK(refuses([&] { findTarget(folder.path()); }, "folder"));
  CHECK(refuses([&] { findTarget(folder / "new/"); }, "folder"));
  CHECK(refuses([&] { findTarget(folder / "file/inside"); }, "not a folder"));
  CHECK(refuses([&] { findTarget(folder / "nowhere"); }, "does not exist"));
  CHECK(refuses([&] { findTarget(folder / "circle"); }, "circle"));
  CHECK(refuses([&] { findTarget(folder / std::string(300, 'n')); }, "too long"));
  CHECK(refuses([] { writeText("/proc/no/such/folder/file", ""); }, "cannot write"));
  fs::permissions(file, fs::perms(0444));
  CHECK(refuses([&] { findTarget(file); }, "write-protected"));
  CHECK(filesIn(folder) == 3);
}

TEST_CASE("a device without an extension gets a mesh as .obj, a file needs one") {
  CHECK_NOTHROW(checkWritableMeshFile("/dev/null"));
  CHECK_THROWS_AS(checkWritableMeshFile("mesh"), Error);
  CHECK_THROWS_AS(checkWritableMeshFile("/dev/null.txt"), Error);
}

TEST_CASE("temporary files are removed by the process that made them alone") {
  const TemporaryFolder folder;
  const TemporaryFile one(folder / "a"), two(folder / "a");
  REQUIRE(filesIn(folder) == 2);
  const pid_t child = ::fork();
  if (child == 0) {
    removeTemporaryFiles();
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  CHECK(filesIn(folder) == 2);
  removeTemporaryFiles();
  CHECK(filesIn(folder) == 0);
}

TEST_CASE("what is read is never written, and two outputs are never one file") {
  const TemporaryFolder folder;
  const fs::path input = folder.write("organ.stl", "old"), missing = folder / "missing";
  fs::create_symlink(input, folder / "soft");
  fs::create_hard_link(input, folder / "hard");
  fs::create_directory(folder / "sub");
  const fs::path inputs[] = {folder / "soft", folder / "none"};
  for (const fs::path& name :
       {input, folder / "soft", folder / "hard", folder / "sub/../organ.stl"})
    CHECK(refuses([&] { checkOutputs({{{"--json", name}}}, inputs); }, "is read"));
  CHECK_NOTHROW(checkOutputs({{{"--json", missing}, {"--plot", ""}, {"--surface", ""}}}, inputs));

  const auto both = [&](const fs::path& a, const fs::path& b) {
    return refuses([&] { checkOutputs({{{"--json", a}, {"--plot", b}}}); }, "--json and --plot");
  };
  CHECK(both(missing, folder / "new/../missing"));
  CHECK(both(input, folder / "hard"));
  CHECK(both(input, folder / "soft"));
  CHECK_NOTHROW(checkOutputs({{{"--json", "/dev/null"}, {"--plot", "/dev/null"}}}));
  CHECK(refuses(
      [&] {
        checkOutputs({{{"--json", missing}, {"--plot", missing / "deeper"}}});
      },
      "on the way"));
  CHECK(refuses(
      [&] {
        checkOutputs({{{"--json", missing}}, {{"--frames", missing, "frame_", ".png"}}});
      },
      "on the way"));
  CHECK(refuses(
      [&] {
        checkOutputs({{{"--surface", folder / "piece_7.stl"}},
                      {{"--pieces", folder.path(), "piece_", ".stl"}}});
      },
      "--pieces"));
}

TEST_CASE("numbered files of an earlier run are removed only when that is wanted, and they alone") {
  const TemporaryFolder folder;
  const NumberedOutputs frames{"--frames", folder.path(), "frame_", ".png"};
  for (const char* name : {"frame_.png", "frame_1x.png", "frame_1.jpg", "x"})
    folder.write(name, "");
  CHECK_NOTHROW(checkOutputs({{}, {frames}}));
  const fs::path kept = folder.write("kept", "old");
  folder.write("frame_0002.png", "");
  folder.write("frame_10000.png", "");
  fs::create_symlink(kept, folder / "frame_3.png");
  CHECK(numberedFiles(frames).size() == 3);
  CHECK(refuses([&] { checkOutputs({{}, {frames}}); }, "--overwrite"));
  CHECK_NOTHROW(checkOutputs({{}, {frames}, true}));
  CHECK(numberedFiles(frames).size() == 3);
  const fs::path inputs[] = {folder / "frame_0002.png"};
  CHECK(refuses([&] { checkOutputs({{}, {frames}, true}, inputs); }, "is read"));
  removeNumberedFiles(frames);
  CHECK(filesIn(folder) == 5);
  CHECK(bytesOf(kept) == "old");
}

TEST_CASE("a scenario reads its own file, its organs, its instruments and their models") {
  const TemporaryFolder folder;
  const fs::path organ = folder.write("organ.ply", ""), model = folder.write("blade.iv", ""),
                 tool = folder.write(
                     "blade.toml", "name = \"Blade\"\nkind = \"scalpel\"\nmodel = \"blade.iv\"\n"),
                 file = folder.write("mine.toml",
                                     "title = \"t\"\nduration = 1\n[organ]\nsource = "
                                     "\"organ.ply\"\n[[tool]]\nmodel = \"blade.toml\"\n");
  const std::vector<fs::path> files = filesRead(readScenario(file));
  for (const fs::path& one : {organ, model, tool, file})
    CHECK(std::ranges::find(files, one) != files.end());
  const auto shipped = [&](const char* end) {
    return std::ranges::any_of(files, [&](const auto& f) { return f.string().ends_with(end); });
  };
  CHECK(shipped("organs/liver.ply"));
  CHECK(shipped("room/table.iv"));
}
