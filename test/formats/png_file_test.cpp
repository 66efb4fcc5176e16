#include "formats/png_file.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"

using namespace resect;
namespace fs = std::filesystem;

namespace {

RgbImage pattern(int width, int height) {
  RgbImage image{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) image.pixels.push_back(std::uint8_t(i * 37 % 251));
  return image;
}

fs::path scratch(const char* name) {
  return fs::temp_directory_path() / fmt::format("resect_png_test_{}", ::getpid()) / name;
}

}  // namespace

TEST_CASE("a picture comes back from its PNG file as it was") {
  const RgbImage image = pattern(37, 19);
  writePng(scratch("a.png"), image);
  const RgbImage back = readPng(scratch("a.png"));
  CHECK(back.width == 37);
  CHECK(back.height == 19);
  CHECK(back.pixels == image.pixels);
  CHECK(back.at(2, 1)[0] == image.pixels[3 * (37 + 2)]);
  fs::remove_all(scratch(""));
}

TEST_CASE("a PNG file that cannot be written or read is said in one sentence") {
  CHECK_THROWS_AS(writePng("/proc/no/such/folder/a.png", pattern(4, 4)), Error);
  CHECK_THROWS_AS(readPng(scratch("missing.png")), Error);
  fs::create_directories(scratch(""));
  writePng(scratch("b.png"), pattern(64, 64));
  fs::resize_file(scratch("b.png"), fs::file_size(scratch("b.png")) / 2);
  CHECK_THROWS_AS(readPng(scratch("b.png")), Error);
  std::ofstream(scratch("c.png")) << "not a picture";
  CHECK_THROWS_AS(readPng(scratch("c.png")), Error);
  fs::remove_all(scratch(""));
}
