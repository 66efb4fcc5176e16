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
// Draws a picture of 640 x 400 pixels for each time, s. The picture is empty for an element without
// a time, for a time that came before, and after the first kMostKeyPictures different times. If
// ffmpeg is installed, makes a clip of two seconds about the first element with a time. Plays the
// course that leads to RecordingFile::moment(). Throws Error if this machine cannot draw pictures.
KeyMoments keyMoments(const std::filesystem::path& recording,
                      const std::vector<std::optional<double>>& times,
                      const Progress& progress = {});
inline constexpr std::size_t kMostKeyPictures = 6;

}  // namespace resect
