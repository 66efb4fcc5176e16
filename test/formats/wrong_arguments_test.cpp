// Is an argument that cannot be right refused in one sentence, and nothing done?
#include <doctest/doctest.h>

#include "formats/png_file.h"
#include "formats/video.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;
using test::refuses;

TEST_CASE("a picture whose bytes do not fit its size is not written") {
  const test::TemporaryFolder folder;
  for (const RgbImage& wrong : {RgbImage{0, 4, {}}, RgbImage{-2, -2, std::vector<std::uint8_t>(12)},
                                RgbImage{4, 4, std::vector<std::uint8_t>(47)}})
    CHECK(refuses([&] { writePng(folder.path() / "wrong.png", wrong); }, "three bytes a pixel"));
  CHECK(!std::filesystem::exists(folder.path() / "wrong.png"));
}

TEST_CASE("a picture of another size than its video is refused") {
  if (!haveFfmpeg()) return;
  const test::TemporaryFolder folder;
  VideoWriter video(folder.path() / "film.mp4", 16, 16, 30);
  for (const RgbImage& wrong : {RgbImage{8, 8, std::vector<std::uint8_t>(192)},
                                RgbImage{16, 16, std::vector<std::uint8_t>(10)}})
    CHECK(refuses([&] { video.add(wrong); }, "all in one size"));
  video.add({16, 16, std::vector<std::uint8_t>(768)});
  video.finish();
  CHECK(refuses([&] { video.add({16, 16, std::vector<std::uint8_t>(768)}); }, "is finished"));
}
