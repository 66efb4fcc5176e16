#include "formats/images/label_image.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace resect {

void checkGrid(const std::string& path, const LabelImage& image) {
  const Vec3i& n = image.dims;
  if ((n.array() < 1).any() || double(n.x()) * n.y() * n.z() > double(kMostVoxels))
    throw error("{}: is an image of {} x {} x {} voxels; 1 to {} million are read", path, n.x(),
                n.y(), n.z(), kMostVoxels / 1000000);
  const Vec3 size = image.spacing();
  if (!image.step.allFinite() || !image.origin.allFinite() || (size.array() < 1e-6).any() ||
      (size.array() > 1).any() || image.voxelVolume() < 1e-3 * size.prod())
    throw error(
        "{}: its voxels have {:g} x {:g} x {:g} mm along axes that make no image; export "
        "it again",
        path, 1e3 * size.x(), 1e3 * size.y(), 1e3 * size.z());
}

std::string orientation(const LabelImage& image) {
  std::string letters;
  for (int a = 0; a < 3; ++a) {
    Eigen::Index along;
    image.step.col(a).cwiseAbs().maxCoeff(&along);
    letters += image.step(along, a) < 0 ? "RAI"[along] : "LPS"[along];
  }
  return letters;
}

double obliqueness(const LabelImage& image) {
  double least = 1;
  for (int a = 0; a < 3; ++a)
    least = std::min(least, image.step.col(a).normalized().cwiseAbs().maxCoeff());
  return std::acos(std::min(least, 1.0)) * 180 / std::numbers::pi;
}

std::string description(const LabelImage& image) {
  const Vec3 size = 1e3 * image.spacing();
  const double oblique = obliqueness(image);
  return fmt::format(
      "{} label image, {} x {} x {} voxels of {:.4g} x {:.4g} x {:.4g} mm, axes {}{}", image.format,
      image.dims.x(), image.dims.y(), image.dims.z(), size.x(), size.y(), size.z(),
      orientation(image), oblique > 0.1 ? fmt::format(", oblique by {:.0f} degrees", oblique) : "");
}

std::string shownName(const ImageLabel& label) {
  return label.name.empty() ? fmt::format("label {}", label.value) : label.name;
}

}  // namespace resect
