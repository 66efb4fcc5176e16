#include "formats/labels/label_slices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "anatomy/structure_kind.h"
#include "formats/labels/label_file.h"
#include "geometry/aabb.h"

namespace resect {
namespace {

using Colour = std::array<std::uint8_t, 3>;

// As atlases draw them.
Colour colourOf(const ImageLabel& label, std::size_t number) {
  if (const auto kind = structureKind(label.name)) switch (*kind) {
      case StructureKind::Parenchyma:
        return {150, 72, 60};
      case StructureKind::Tumour:
        return {240, 220, 130};
      case StructureKind::Cyst:
        return {150, 200, 210};
      case StructureKind::Gallbladder:
        return {110, 150, 70};
      case StructureKind::PortalVein:
        return {150, 110, 200};
      case StructureKind::HepaticVein:
        return {80, 120, 220};
      case StructureKind::HepaticArtery:
        return {230, 60, 50};
      case StructureKind::BileDuct:
        return {90, 170, 80};
    }
  constexpr double kGolden = 0.618033988749895;  // turns of hue that stay apart
  const double hue = 6 * std::fmod(0.1 + kGolden * double(number), 1.0);
  Colour colour;
  for (std::size_t c = 0; c < 3; ++c) {
    const double away = std::abs(std::fmod(hue - 2.0 * double(c) + 9, 6.0) - 3);
    colour[c] = std::uint8_t(90 + 110 * std::clamp(2 - away, 0.0, 1.0));
  }
  return colour;
}

// Middle of what is shown, m, and the box of all labels.
struct Extent {
  Aabb box;
  Vec3 middle = Vec3::Zero();
};

std::size_t shownLabel(const LabelImage& image) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < image.labels.size(); ++i) {
    if (structureKind(image.labels[i].name) == StructureKind::Parenchyma) return i;
    if (image.labels[i].voxels > image.labels[best].voxels) best = i;
  }
  return best;
}

Extent extentOf(const LabelImage& image) {
  Extent extent;
  const auto shown = std::uint16_t(shownLabel(image) + 1);
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const RawArray<std::uint16_t>& layer : image.layers) {
    std::size_t i = 0;
    for (int z = 0; z < image.dims.z(); ++z)
      for (int y = 0; y < image.dims.y(); ++y)
        for (int x = 0; x < image.dims.x(); ++x, ++i) {
          if (layer[i] == 0) continue;
          const Vec3 place = image.origin + image.step * Vec3(x, y, z);
          extent.box.grow(place);
          if (layer[i] == shown) sum += place, ++count;
        }
  }
  if (count > 0) extent.middle = sum / count;
  return extent;
}

}  // namespace

RgbImage labelSlices(const LabelImage& image, int height) {
  const Extent extent = extentOf(image);
  if (extent.box.empty()) return {};
  // Directions to the right and down in each slice, in left-posterior-superior.
  const std::array<std::array<Vec3, 2>, 3> views{{{Vec3::UnitX(), Vec3::UnitY()},
                                                  {Vec3::UnitX(), -Vec3::UnitZ()},
                                                  {Vec3::UnitY(), -Vec3::UnitZ()}}};
  const Vec3 size = extent.box.size();
  const double side = 1.1 * std::max(size.maxCoeff(), 1e-3);  // m, of each slice
  const double pixel = side / height;
  RgbImage picture{3 * height, height, {}};
  picture.pixels.assign(std::size_t(3 * height) * std::size_t(height) * 3, 0);
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < image.labels.size(); ++i)
    colours.push_back(colourOf(image.labels[i], i));
  const Mat3 toVoxels = image.step.inverse();
  const Vec3 centre = extent.box.centre();
  for (std::size_t view = 0; view < views.size(); ++view) {
    const auto& [right, down] = views[view];
    const Vec3 across = right.cross(down);
    const Vec3 middle = centre + across * across.dot(extent.middle - centre);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < height; ++x) {
        const Vec3 place =
            middle + pixel * ((x + 0.5 - 0.5 * height) * right + (y + 0.5 - 0.5 * height) * down);
        const Vec3 at = (toVoxels * (place - image.origin)).array().round();
        if ((at.array() < 0).any() || (at.array() >= image.dims.cast<double>().array()).any())
          continue;
        const auto voxel = std::size_t(
            (std::int64_t(at.z()) * image.dims.y() + std::int64_t(at.y())) * image.dims.x() +
            std::int64_t(at.x()));
        for (const RawArray<std::uint16_t>& layer : image.layers)
          if (layer[voxel] > 0)
            std::ranges::copy(
                colours[layer[voxel] - 1u],
                picture.pixels.begin() +
                    std::ptrdiff_t(3 * (std::size_t(y) * std::size_t(3 * height) +
                                        view * std::size_t(height) + std::size_t(x))));
      }
  }
  return picture;
}

RgbImage readLabelSlices(const std::filesystem::path& path, int height) {
  const std::string bytes = inImageReader(path, {}, [&](const LabelImage& image) {
    const std::vector<std::uint8_t> pixels = labelSlices(image, height).pixels;
    return std::string(pixels.begin(), pixels.end());
  });
  RgbImage picture{3 * height, height, {bytes.begin(), bytes.end()}};
  if (bytes.size() != std::size_t(9) * std::size_t(height) * std::size_t(height)) return {};
  return picture;
}

}  // namespace resect
