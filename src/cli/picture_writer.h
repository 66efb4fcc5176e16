// Draws pictures of an operation, and writes them as numbered files, as a video, or as both.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "inventor/picture/picture_quality.h"
#include "io/output/run_files.h"
#include "operation/scenario.h"
#include "simulation/simulation.h"

namespace resect {

struct PictureSettings {
  std::string folder;  // folder for frame_0001.png, frame_0002.png ...; "": no such files
  std::string video;   // name of an .mp4 file; "": no video
  std::string size;    // size in pixels, such as "1280x720"
  double rate = 10;    // pictures per simulated second
  PictureQuality quality;
  bool hands = true;  // whether hands hold the instruments in the operative field
  // Whether numbered pictures that are already in the folder are removed before the first new one
  // is written.
  bool overwrite = false;
};

// The numbered pictures that a PictureWriter writes to the folder.
NumberedOutputs framesIn(const std::string& folder);

class PictureWriter {
 public:
  // Draws the first picture, which shows the operation before its first frame. Throws Error if the
  // size is invalid or EGL is missing, or if a video is wanted and ffmpeg is missing.
  PictureWriter(const Scenario& scenario, Simulation& simulation, const PictureSettings& settings);
  ~PictureWriter();
  PictureWriter(const PictureWriter&) = delete;
  PictureWriter& operator=(const PictureWriter&) = delete;

  // Call after every step. Draws a picture when one is due: every 1 / rate simulated seconds.
  void follow(const Simulation& simulation, const StepReport& step);

  // Draws a picture of the last frame, if this was not done yet, and finishes the video. Returns
  // lines that tell a person which files were written: one line for the numbered pictures, and one
  // line for the video.
  std::vector<std::string> finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Parses a size in pixels, such as "1280x720". Throws a usage Error unless both numbers are from 16
// to 8192.
void parseSize(const std::string& text, int& width, int& height);

}  // namespace resect
