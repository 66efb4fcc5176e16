// Is a video whole, and is one that is not refused?
#include "formats/video.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include "formats/mp4_check.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;
using test::refuses;
using test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

// A box of ISO/IEC 14496-12 of this length in all.
std::string box(const std::string& type, unsigned char length) {
  return std::string(3, '\0') + char(length) + type + std::string(length - 8u, 'x');
}

bool isWhole(const TemporaryFolder& folder, const std::string& bytes) {
  const int file = ::open(folder.write("film.mp4", bytes).c_str(), O_RDONLY);
  const bool whole = isWholeMp4(file);
  ::close(file);
  return whole;
}

}  // namespace

TEST_CASE("an .mp4 file is whole when its boxes fill it and hold index and pictures") {
  const TemporaryFolder folder;
  const std::string start = box("ftyp", 24) + box("moov", 100), whole = start + box("mdat", 60);
  CHECK(isWhole(folder, whole));
  // A length of 8 bytes.
  const std::string large = std::string("\0\0\0\1mdat\0\0\0\0\0\0\0\x18", 16) + "pictures";
  CHECK(isWhole(folder, start + large));
  for (std::size_t size = 0; size < whole.size(); ++size)
    CHECK_FALSE(isWhole(folder, whole.substr(0, size)));
  CHECK_FALSE(isWhole(folder, start + std::string("\0\0\0\0mdat", 8)));  // not closed
  CHECK_FALSE(isWhole(folder, box("ftyp", 24) + box("mdat", 60)));
  CHECK_FALSE(isWhole(folder, start + large.substr(0, 20)));
}

TEST_CASE("a video that is not finished leaves what was there, one that is replaces it") {
  if (!haveFfmpeg()) {
    MESSAGE("ffmpeg is not installed");
    return;
  }
  const TemporaryFolder folder;
  const fs::path file = folder.write("film.mp4", "old");
  const RgbImage picture{32, 16, std::vector<std::uint8_t>(3 * 32 * 16, 100)};
  {
    VideoWriter video(file, 32, 16, 10);
    video.add(picture);
  }
  CHECK(test::bytesOf(file) == "old");
  VideoWriter video(file, 32, 16, 10);
  for (int i = 0; i < 5; ++i) video.add(picture);
  video.finish();
  CHECK(isWhole(folder, test::bytesOf(file)));
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1);
  CHECK(refuses([&] { video.finish(); }, "finished"));
}

TEST_CASE("a video is an ordinary .mp4 file") {
  const TemporaryFolder folder;
  fs::create_symlink("/dev/null", folder / "null.mp4");
  CHECK(refuses([&] { checkVideoFile(folder / "null.mp4"); }, "ordinary file"));
  CHECK(refuses([&] { checkVideoFile(folder / "film.avi"); }, ".mp4"));
}
