// Writes pictures of an operation as numbered files, as a video, or both.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "operation/scenario.h"
#include "simulation/simulation.h"

namespace resect {

struct PictureSettings {
  std::string folder;  // for frame_0001.png ...; "": no files
  std::string video;   // name of an .mp4 file; "": no video
  std::string size;    // in pixels, as "1280x720"
  double rate = 10;    // pictures per simulated second
};

class PictureWriter {
 public:
  // Draws the first picture, of the start. Throws Error if the size is invalid, EGL is missing, or
  // ffmpeg is missing for a video.
  PictureWriter(const Scenario& scenario, Simulation& simulation, const PictureSettings& settings);
  ~PictureWriter();
  PictureWriter(const PictureWriter&) = delete;
  PictureWriter& operator=(const PictureWriter&) = delete;

  // Call it after every step. It draws a picture when one is due: every 1 / rate simulated seconds,
  // and after the last frame.
  void follow(const Simulation& simulation, const StepReport& step);

  // Finishes the video. Returns one line for the numbered pictures and one for the video.
  std::vector<std::string> finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Parses "1280x720". Throws a usage Error unless width and height are 16 to 8192.
void parseSize(const std::string& text, int& width, int& height);

}  // namespace resect
