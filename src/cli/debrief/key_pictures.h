// Pictures of some moments of a recorded operation, and a clip of the first one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"

namespace resect {

struct KeyMoments {
  std::vector<std::string> pictures;  // bytes of PNG files; may be empty
  std::string clip;                   // bytes of an MP4 file; empty: there is none
};
// For each time, s, a picture of 640 x 400 pixels; none where there is no time, where an earlier
// one is the same, and after the first kMostKeyPictures different times. Of the first time that
// there is a clip of two seconds, if ffmpeg is installed. The course that leads to the recording's
// moment is played. Throws Error if nothing can be drawn here.
KeyMoments keyMoments(const std::filesystem::path& recording,
                      const std::vector<std::optional<double>>& times,
                      const Progress& progress = {});
inline constexpr std::size_t kMostKeyPictures = 6;

}  // namespace resect
