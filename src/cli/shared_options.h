// Command-line options that are the same in several commands.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/picture_writer.h"
#include "record/course.h"

namespace resect {

// Options for pictures of an operation, as the user wrote them: where the pictures are written, and
// how they look.
struct PictureOptions {
  // frames: folder for numbered pictures; "": no numbered pictures. video: video file; "": no
  // video.
  std::string frames, video;
  std::string size = "1280x720", view, setting, quality = "window";
  double rate = 10;  // pictures per simulated second
  bool hands = true;

  bool wanted() const { return !frames.empty() || !video.empty(); }
  // Throws a usage Error if the size, the quality, the view, the rate or the name of the video is
  // invalid. To be called before long work.
  void check() const;
  // Replaces the scenario's view (of the camera) and setting (the surroundings of the organs) by
  // those that the user asked for.
  void applyTo(Scenario& scenario) const;
};

// Converts the options to the settings of a PictureWriter. overwrite: PictureSettings::overwrite.
PictureSettings settingsOf(const PictureOptions& options, bool overwrite);

// Adds --frames, --video, --picture-rate, --size, --quality, --view, --setting and --no-hands. The
// options must live as long as the command.
void addPictureOptions(Command command, PictureOptions& options);

// Adds --quality, one of kQualityNames (inventor/picture/picture_quality.h).
void addQualityOption(Command command, std::string& quality);
// Throws a usage Error unless `quality` is one of these names.
PictureQuality requireQuality(const std::string& quality);

// Adds --setting, one of kSettingNames (operation/scenario.h).
void addSettingOption(Command command, std::string& setting);
// Throws a usage Error unless `setting` is empty or one of these names.
void requireSetting(const std::string& setting);

// Adds --breathing: the depth of the patient's breathing, a length as text. If `depth` is not
// empty, setBreathing() writes it to the scenario. setBreathing() throws a usage Error if `depth`
// is not a length or is out of range, or if the scenario has no elastic tissue.
void addBreathingOption(Command command, std::string& depth);
void setBreathing(Scenario& scenario, const std::string& depth);

// Adds --threads, 0 to 1024.
void addThreadsOption(Command command, int& threads);

// Adds --part, the name of a part of a model file. It may be given several times. The names are
// written to `part` in the form of OrganMeshOptions::part (io/organ_mesh.h).
void addPartOption(Command command, std::string& part);

// Adds --overwrite. numbered: says in the help what the option may remove, for example "the
// numbered pictures of an earlier run from the folder of --frames".
void addOverwriteOption(Command command, bool& overwrite, const std::string& numbered);

// Adds FILE, a recording to read.
void addRecordingOption(Command command, std::string& file);

// A part of a recorded operation. The recording has a new branch wherever the user went back in
// time.
struct RecordedPart {
  double from = 0, to = INFINITY;  // simulated times, s
  std::int64_t branch = -1;        // -1: the branch of RecordingFile::moment()

  void check() const;                                // throws a usage Error unless 0 <= from <= to
  std::int64_t branchIn(RecordingFile& file) const;  // the branch's number
  // The frames of this part. They lie on the path from the beginning of the recording to the end of
  // the branch. Throws Error if the part has no frames.
  std::vector<CourseSpan> of(RecordingFile& file, double frameRate) const;
};

// Adds --from, --to and --branch.
void addPartOptions(Command command, RecordedPart& part);

}  // namespace resect
