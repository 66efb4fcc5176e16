// How does an operation become a row of numbered pictures, or a video?
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "operation/scenario.h"
#include "simulation/simulation.h"

namespace resect {

struct PictureSettings {
  std::string folder;  // for frame_0001.png ...; "" = none kept
  std::string video;   // .mp4, or ""
  std::string size;    // "1280x720"
  double rate = 10;    // pictures per simulated second
};

class PictureWriter {
 public:
  // Throws before any work when the size is wrong, EGL is missing, or a video is wanted without
  // ffmpeg.
  PictureWriter(const Scenario& scenario, Simulation& simulation, const PictureSettings& settings);
  ~PictureWriter();
  PictureWriter(const PictureWriter&) = delete;
  PictureWriter& operator=(const PictureWriter&) = delete;

  // After every step; draws when a picture is due: at the start, then every 1 / rate seconds, and
  // at the last frame.
  void follow(const Simulation& simulation, const StepReport& step);

  // Makes the video; returns what was written, a line each.
  std::vector<std::string> finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// "1280x720" to numbers; a usage Error outside 16 to 8192.
void parseSize(const std::string& text, int& width, int& height);

}  // namespace resect
