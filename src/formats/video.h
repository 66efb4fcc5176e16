// Writes pictures to a video file. The program ffmpeg does this work, so it must be installed
// (haveFfmpeg()).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "formats/png_file.h"
#include "io/output/temporary_file.h"

namespace resect {

// Call this before long work whose result will be written to the file. Throws Error if the name
// does not end in .mp4, if no ordinary file can be written under this name
// (io/output/output_target.h), or if ffmpeg is not installed.
void checkVideoFile(const std::filesystem::path& path);

class VideoWriter {
 public:
  // Starts ffmpeg, which writes into a temporary file beside `path`. When the thread that
  // constructed this object ends, the kernel kills ffmpeg (PR_SET_PDEATHSIG). So this thread must
  // not end before finish() has returned.
  //
  // width, height: size of every picture, pixels. The codec needs even numbers. If the width is
  // odd, one column of pixels is cropped; if the height is odd, one row. rate: pictures per
  // second, > 0. Throws Error in the same cases as checkVideoFile(), and also if ffmpeg cannot be
  // started.
  VideoWriter(const std::filesystem::path& path, int width, int height, double rate);
  // If finish() was not called, discards the video. In that case an earlier file at `path` stays as
  // it was.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  // Adds a picture to the video. If ffmpeg has stopped, for example because the disk is full,
  // throws an Error with ffmpeg's message.
  void add(const RgbImage& picture);
  // Ends the video and gives the file its final name. Call this exactly once, after the last
  // picture. Throws Error if the video is not complete.
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
  int messages_ = -1;  // file in memory with everything that ffmpeg prints
  int process_ = -1;   // ffmpeg's process; -1: not running
};

// Whether the program ffmpeg is on the PATH.
bool haveFfmpeg();

}  // namespace resect
