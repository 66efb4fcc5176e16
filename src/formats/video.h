// Writes pictures to a video file by the program ffmpeg, which must be installed (haveFfmpeg()).
#pragma once

#include <filesystem>
#include <string>

#include "formats/png_file.h"

namespace resect {

class VideoWriter {
 public:
  // Starts ffmpeg. path: ends in .mp4. width, height: size of every picture, pixels; the codec
  // needs even numbers, so of an odd number one pixel is cropped. rate: pictures per second, > 0.
  // Throws Error if ffmpeg is not installed or the path does not end in .mp4.
  VideoWriter(const std::filesystem::path& path, int width, int height, double rate);
  // If finish() was not called, no video is left behind.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  void add(const RgbImage& picture);
  // Ends the video and gives the file its final name. Call this once, after the last picture.
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
