// Makes pictures of some moments of a recorded operation, and a video clip of one of these moments.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"

namespace resect {

struct KeyMoments {
  std::vector<std::string> pictures;  // per element of `times`: bytes of a PNG file, or ""
  std::string clip;                   // bytes of an MP4 file; empty: there is none
};
// Draws a picture of 640 x 400 pixels for each element of `times`, s. There are three exceptions,
// for which the picture is "": the element has no time; an earlier element has the same time; the
// elements before it have kMostKeyPictures different times already. If ffmpeg is installed, also
// makes a clip. The clip is about the first time in the list `times`: it lasts from 1.4 s before
// this time to 0.6 s after it. A recording has a new branch wherever the user went back in time;
// the branch that ends at RecordingFile::moment() is played. Throws Error if this machine cannot
// draw pictures.
KeyMoments keyMoments(const std::filesystem::path& recording,
                      const std::vector<std::optional<double>>& times,
                      const Progress& progress = {});
inline constexpr std::size_t kMostKeyPictures = 6;

}  // namespace resect
