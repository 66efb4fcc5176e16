// Writes pictures to a video file by the program ffmpeg, which must be installed (haveFfmpeg()).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "formats/png_file.h"
#include "io/output/temporary_file.h"

namespace resect {

// To be called before long work: throws Error unless the name ends in .mp4, is that of an ordinary
// file that can be written (io/output/output_target.h), and ffmpeg is installed.
void checkVideoFile(const std::filesystem::path& path);

class VideoWriter {
 public:
  // Starts ffmpeg, which writes into a temporary file beside `path` and ends when this process
  // does. width, height: size of every picture, pixels; the codec needs even numbers, so of an odd
  // number one pixel is cropped. rate: pictures per second, > 0. Throws Error as checkVideoFile()
  // does.
  VideoWriter(const std::filesystem::path& path, int width, int height, double rate);
  // If finish() was not called, no video is left behind, and an earlier file is as it was.
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  // Throws Error with what ffmpeg said if it has stopped, as on a full disk.
  void add(const RgbImage& picture);
  // Ends the video and gives the file its final name. Call this once, after the last picture.
  // Throws Error unless the video is whole.
  void finish();

 private:
  void start(double rate);
  // Lets ffmpeg end; whether it says that all went well.
  bool ended();
  std::string complaint() const;

  std::filesystem::path path_;
  int width_, height_;
  std::optional<TemporaryFile> file_;
  int pictures_ = -1;  // socket to ffmpeg's standard input
  int messages_ = -1;  // file in memory with its standard error
  int process_ = -1;
};

// Whether the program ffmpeg is on the PATH.
bool haveFfmpeg();

}  // namespace resect
