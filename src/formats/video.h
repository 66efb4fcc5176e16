// Writes pictures to a video file with the program ffmpeg, if it is installed.
#pragma once

#include <filesystem>
#include <string>

#include "formats/png_file.h"

namespace resect {

class VideoWriter {
 public:
  // Starts ffmpeg. Every picture must have this size; the video is cropped to even numbers of
  // pixels for the codec. rate: pictures per second, > 0. Throws Error if ffmpeg is not installed
  // or the name is not .mp4.
  VideoWriter(const std::filesystem::path& path, int width, int height, double rate);
  // Without finish() no video is written.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  void add(const RgbImage& picture);
  // Closes the video and renames it to its final name.
  void finish();

 private:
  std::filesystem::path path_, temporary_;
  int width_, height_;
  int pipe_ = -1;
  int process_ = -1;
};

// Whether the program ffmpeg is on the PATH.
bool haveFfmpeg();

}  // namespace resect
