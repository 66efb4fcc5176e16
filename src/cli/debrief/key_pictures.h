// Pictures of some moments of a recorded operation.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"

namespace resect {

// For each time, s, the bytes of a PNG file of 640 x 400 pixels; empty where there is no time,
// where an earlier one is the same, and after the first kMostKeyPictures different times. The
// course that leads to the recording's moment is played. Throws Error if nothing can be drawn here.
std::vector<std::string> keyPictures(const std::filesystem::path& recording,
                                     const std::vector<std::optional<double>>& times,
                                     const Progress& progress = {});
inline constexpr std::size_t kMostKeyPictures = 6;

}  // namespace resect
