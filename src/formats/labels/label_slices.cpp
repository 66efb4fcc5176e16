#include "formats/labels/label_slices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "anatomy/structure_kind.h"
#include "base/text/file_stem.h"
#include "formats/labels/label_file.h"
#include "formats/labels/label_model.h"
#include "geometry/aabb.h"

namespace resect {
namespace {

using Colour = std::array<std::uint8_t, 3>;

// As atlases draw them.
Colour colourOf(const std::string& name, std::size_t number) {
  if (const auto kind = structureKind(name)) switch (*kind) {
      case StructureKind::Parenchyma:
        return {150, 72, 60};
      case StructureKind::Tumour:
        return {240, 220, 130};
      case StructureKind::Cyst:
        return {150, 200, 210};
      case StructureKind::Gallbladder:
        return {110, 150, 70};
      case StructureKind::Cavity:
        return {60, 66, 78};
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

std::size_t shownLabel(const LabelImage& image) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < image.labels.size(); ++i) {
    if (structureKind(image.labels[i].name) == StructureKind::Parenchyma) return i;
    if (image.labels[i].voxels > image.labels[best].voxels) best = i;
  }
  return best;
}

}  // namespace

SliceFrame sliceFrame(const LabelImage& image) {
  SliceFrame frame;
  const auto shown = std::uint16_t(shownLabel(image) + 1);
  Aabb box;
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const RawArray<std::uint16_t>& layer : image.layers) {
    std::size_t i = 0;
    for (int z = 0; z < image.dims.z(); ++z)
      for (int y = 0; y < image.dims.y(); ++y)
        for (int x = 0; x < image.dims.x(); ++x, ++i) {
          if (layer[i] == 0) continue;
          const Vec3 place = image.origin + image.step * Vec3(x, y, z);
          box.grow(place);
          if (layer[i] == shown) sum += place, ++count;
        }
  }
  if (box.empty()) return frame;
  frame.centre = box.centre();
  frame.middle = count > 0 ? Vec3(sum / count) : frame.centre;
  frame.side = 1.1 * std::max(box.size().maxCoeff(), 1e-3);
  return frame;
}

RgbImage labelSlices(const LabelImage& image, const SliceFrame& frame, int height,
                     const std::string& name) {
  if (frame.side == 0) return {};
  // Directions to the right and down in each slice, in left-posterior-superior.
  const std::array<std::array<Vec3, 2>, 3> views{{{Vec3::UnitX(), Vec3::UnitY()},
                                                  {Vec3::UnitX(), -Vec3::UnitZ()},
                                                  {Vec3::UnitY(), -Vec3::UnitZ()}}};
  const double pixel = frame.side / height;
  RgbImage picture{3 * height, height, {}};
  picture.pixels.assign(std::size_t(3 * height) * std::size_t(height) * 3, 0);
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < image.labels.size(); ++i) {
    const std::string& own = image.labels[i].name;
    colours.push_back(colourOf(own.empty() ? name : own, i));
  }
  const Mat3 toVoxels = image.step.inverse();
  for (std::size_t view = 0; view < views.size(); ++view) {
    const auto& [right, down] = views[view];
    const Vec3 across = right.cross(down);
    const Vec3 middle = frame.centre + across * across.dot(frame.middle - frame.centre);
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
        const std::size_t first = 3 * (std::size_t(y) * std::size_t(3 * height) +
                                       view * std::size_t(height) + std::size_t(x));
        for (const RawArray<std::uint16_t>& layer : image.layers)
          if (layer[voxel] > 0)
            std::ranges::copy(colours[layer[voxel] - 1u],
                              picture.pixels.begin() + std::ptrdiff_t(first));
      }
  }
  return picture;
}

RgbImage readLabelSlices(const std::vector<std::string>& files, int height) {
  SliceFrame frame;
  RgbImage all;
  for (const std::string& file : files) {
    const bool first = &file == &files.front();
    const std::string answer = inImageReader(file, {}, [&](const LabelImage& image) {
      if (first) frame = sliceFrame(image);
      const std::vector<std::uint8_t> pixels =
          labelSlices(image, frame, height, fileStem(file)).pixels;
      std::string bytes(sizeof frame, '\0');
      std::memcpy(bytes.data(), &frame, sizeof frame);
      return bytes.append(pixels.begin(), pixels.end());
    });
    const std::size_t size = std::size_t(9) * std::size_t(height) * std::size_t(height);
    if (answer.size() != sizeof frame + size) {
      if (first) return {};
      continue;  // nothing is labelled in it
    }
    if (first) {
      std::memcpy(static_cast<void*>(&frame), answer.data(), sizeof frame);
      all = {3 * height, height, std::vector<std::uint8_t>(size, 0)};
    }
    const char* const pixels = answer.data() + sizeof frame;
    for (std::size_t i = 0; i < size; i += 3)
      if (pixels[i] || pixels[i + 1] || pixels[i + 2])
        std::copy(pixels + i, pixels + i + 3, all.pixels.begin() + std::ptrdiff_t(i));
  }
  return all;
}

}  // namespace resect
