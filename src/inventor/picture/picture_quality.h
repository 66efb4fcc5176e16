// Quality settings for pictures that are written to files.
#pragma once

#include <optional>
#include <string_view>

namespace resect {

struct PictureQuality {
  int samples = 4;  // samples per pixel, for antialiased edges; 1: no antialiasing
  // Pictures are drawn larger along each axis by this factor. Then they are reduced by averaging.
  // This smooths the shading as well as the edges.
  int enlarged = 1;
  int shadowTexels =
      1024;  // along each side of a shadow map (OperatingRoom::setShadowResolution())
};

inline constexpr const char* kQualityNames = "draft, window or film";

// draft: one sample per pixel. window: four samples, as in the program's window while nothing moves
// there. film: four samples and twice the size along each axis, which makes sixteen samples per
// pixel of the reduced picture. Empty if there is no quality of this name.
inline std::optional<PictureQuality> pictureQuality(std::string_view name) {
  if (name == "draft") return PictureQuality{1, 1, 512};
  if (name == "window") return PictureQuality{};
  if (name == "film") return PictureQuality{4, 2, 2048};
  return std::nullopt;
}

}  // namespace resect
