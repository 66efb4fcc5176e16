// Writes pictures to a video file through the program ffmpeg, which must be installed
// (haveFfmpeg()).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "formats/png_file.h"
#include "io/output/temporary_file.h"

namespace resect {

// To be called before long work. Throws Error if the name does not end in .mp4, if it cannot be
// written as an ordinary file (io/output/output_target.h), or if ffmpeg is not installed.
void checkVideoFile(const std::filesystem::path& path);

class VideoWriter {
 public:
  // Starts ffmpeg, which writes into a temporary file beside `path`. The kernel kills ffmpeg when
  // the thread that constructed this object ends (PR_SET_PDEATHSIG). So that thread must not end
  // before finish() has returned.
  //
  // width, height: size of every picture, pixels. The codec needs even numbers; if one is odd, one
  // column or row of pixels is cropped. rate: pictures per second, > 0. Throws Error as
  // checkVideoFile() does.
  VideoWriter(const std::filesystem::path& path, int width, int height, double rate);
  // If finish() was not called, the video is discarded, and an earlier file at `path` is unchanged.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  // Throws Error with ffmpeg's message if ffmpeg has stopped, for example because the disk is full.
  void add(const RgbImage& picture);
  // Ends the video and gives the file its final name. Call this once, after the last picture.
  // Throws Error if the video is not complete.
  void finish();

 private:
  void start(double rate);
  // Closes ffmpeg's input and waits until ffmpeg ends. Returns whether its exit status is 0.
  bool ended();
  std::string complaint() const;

  std::filesystem::path path_;
  int width_, height_;
  std::optional<TemporaryFile> file_;
  int pictures_ = -1;  // socket to ffmpeg's standard input
  int messages_ = -1;  // file in memory with all that ffmpeg prints
  int process_ = -1;
};

// Whether the program ffmpeg is on the PATH.
bool haveFfmpeg();

}  // namespace resect
