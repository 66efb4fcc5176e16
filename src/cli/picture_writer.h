// Writes pictures of an operation as numbered files or a video.
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
  // Throws Error, before any work, if the size is invalid, EGL is missing, or ffmpeg is missing for
  // a video.
  PictureWriter(const Scenario& scenario, Simulation& simulation, const PictureSettings& settings);
  ~PictureWriter();
  PictureWriter(const PictureWriter&) = delete;
  PictureWriter& operator=(const PictureWriter&) = delete;

  // Call after every step; draws if a picture is due: at the start, then every 1 / rate seconds,
  // and at the last frame.
  void follow(const Simulation& simulation, const StepReport& step);

  // Finishes the video; returns a line for each file written.
  std::vector<std::string> finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// "1280x720" to numbers; a usage Error outside 16 to 8192.
void parseSize(const std::string& text, int& width, int& height);

}  // namespace resect
