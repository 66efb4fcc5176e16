// How carefully pictures for files are drawn.
#pragma once

#include <optional>
#include <string_view>

namespace resect {

struct PictureQuality {
  int samples = 4;  // per pixel, at which edges are antialiased; 1: edges are not antialiased
  // Pictures are drawn so many times as large along each axis and then averaged, which smooths
  // shading too.
  int enlarged = 1;
  int shadowTexels =
      1024;  // along each side of a shadow map (OperatingRoom::setShadowResolution())
};

inline constexpr const char* kQualityNames = "draft, window or film";

// draft: one sample per pixel. window: four samples, as the window shows what rests. film: sixteen
// samples. Empty if there is no quality of this name.
inline std::optional<PictureQuality> pictureQuality(std::string_view name) {
  if (name == "draft") return PictureQuality{1, 1, 512};
  if (name == "window") return PictureQuality{};
  if (name == "film") return PictureQuality{4, 2, 2048};
  return std::nullopt;
}

}  // namespace resect
