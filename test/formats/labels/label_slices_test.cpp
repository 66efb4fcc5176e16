// Slices of label images lie as a radiologist expects them.
#include "formats/labels/label_slices.h"

#include <doctest/doctest.h>

using namespace resect;

namespace {

// A block of parenchyma, with a tumour at its left, front and top; the voxels' axes lead to the
// right, the front and the head, so that columns and rows of slices are reversed.
LabelImage block() {
  LabelImage image;
  image.dims = {20, 20, 20};
  image.step = Vec3(-0.002, -0.002, 0.002).asDiagonal();
  image.origin = {0.1, 0.3, -0.2};
  image.layers.emplace_back().assign(8000, 1);
  image.labels = {{1, "liver", 0, 7936}, {2, "tumour", 0, 64}};
  for (int z = 10; z < 20; ++z)
    for (int y = 10; y < 20; ++y)
      for (int x = 0; x < 10; ++x) image.layers[0][std::size_t((z * 20 + y) * 20 + x)] = 2;
  return image;
}

bool isTumour(const RgbImage& picture, int x, int y) { return picture.at(x, y)[1] > 180; }

}  // namespace

TEST_CASE("slices show the patient's right on the left, the front and the head up") {
  const LabelImage image = block();
  SliceFrame frame = sliceFrame(image);
  CHECK(frame.side == doctest::Approx(1.1 * 0.038));
  frame.middle = image.origin + image.step * Vec3(5, 15, 15);  // in the tumour
  constexpr int kHeight = 40;
  const RgbImage picture = labelSlices(image, frame, kHeight);
  REQUIRE(picture.width == 3 * kHeight);
  // From below: the tumour is at the right and up; from the front: at the right and up; from the
  // left, where the front is on the left: at the left and up.
  for (const bool right : {false, true})
    for (const bool low : {false, true}) {
      CAPTURE(right);
      CAPTURE(low);
      const int x = right ? 30 : 10, y = low ? 30 : 10;
      CHECK(isTumour(picture, x, y) == (right && !low));
      CHECK(isTumour(picture, kHeight + x, y) == (right && !low));
      CHECK(isTumour(picture, 2 * kHeight + x, y) == (!right && !low));
    }
  CHECK(picture.at(0, 0)[0] == 0);  // the margin is black
  LabelImage empty = image;
  std::ranges::fill(empty.layers[0], std::uint16_t(0));
  CHECK(labelSlices(empty, sliceFrame(empty), kHeight).pixels.empty());
}
