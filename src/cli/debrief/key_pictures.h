// Pictures of some moments of a recorded operation, and a clip of the first one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"

namespace resect {

struct KeyMoments {
  std::vector<std::string> pictures;  // per time: bytes of a PNG file, or ""
  std::string clip;                   // bytes of an MP4 file; empty: there is none
};
// Draws a picture of 640 x 400 pixels for each element of `times`, s. The picture is "" if the
// element has no time, if an earlier element has the same time, or if kMostKeyPictures different
// times come before. If ffmpeg is installed, makes a clip from 1.4 s before to 0.6 s after the
// first time. Plays the course that leads to RecordingFile::moment(). Throws Error if this machine
// cannot draw pictures.
KeyMoments keyMoments(const std::filesystem::path& recording,
                      const std::vector<std::optional<double>>& times,
                      const Progress& progress = {});
inline constexpr std::size_t kMostKeyPictures = 6;

}  // namespace resect
