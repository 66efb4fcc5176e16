#include "record/session_recordings.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <vector>

#include "base/error.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

// Recordings in the folder, the oldest first: their names begin with date and time. The file that
// SQLite keeps beside one being written is not counted.
std::vector<fs::path> recordingsIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ec;
  for (const auto& entry : fs::directory_iterator(folder, ec))
    if (entry.path().extension() == ".resect") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

void keepNewest(const fs::path& folder, int most) {
  std::vector<fs::path> files = recordingsIn(folder);
  std::error_code ec;
  for (int i = 0; i < int(files.size()) - most; ++i)
    for (const char* end : {"", "-wal", "-shm"})
      fs::remove(files[std::size_t(i)].string() + end, ec);
}

}  // namespace

fs::path recordingsFolder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  const fs::path base =
      state && *state ? fs::path(state) : fs::path(home ? home : "/tmp") / ".local/state";
  return base / "resect" / "recordings";
}

namespace {

// A new name in the folder, which is made if need be: date, time, scenario.
fs::path newRecording(const Scenario& scenario) {
  const fs::path folder = recordingsFolder();
  std::error_code ec;
  fs::create_directories(folder, ec);
  if (ec)
    throw error("{}: cannot be made: {}; the operation is not recorded", folder.string(),
                ec.message());
  const auto now =
      std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
  return folder / fmt::format("{:%Y-%m-%d_%H-%M-%S}_{:03}_{}.resect",
                              fmt::localtime(std::chrono::system_clock::to_time_t(now)),
                              now.time_since_epoch().count() % 1000,
                              scenario.name.empty() ? "operation" : scenario.name);
}

}  // namespace

std::shared_ptr<Recorder> recordSession(const Scenario& scenario, const Simulation& simulation) {
  auto recorder = std::make_shared<Recorder>(newRecording(scenario), scenario, simulation);
  keepNewest(recordingsFolder(), kKeptRecordings);
  return recorder;
}

std::shared_ptr<Recorder> recordSession(const Scenario& scenario, RecordingFile& done,
                                        const Simulation& simulation) {
  auto recorder = std::make_shared<Recorder>(newRecording(scenario), done, scenario, simulation);
  keepNewest(recordingsFolder(), kKeptRecordings);
  return recorder;
}

OperationWatch watchOf(std::shared_ptr<Recorder> recorder) {
  return {[recorder](const Branch& branch, const Simulation& simulation) {
            recorder->begin(branch, simulation);
          },
          [recorder](const Branch& branch) { recorder->rename(branch); },
          [recorder](Moment moment, const Simulation& simulation) {
            recorder->stood(moment, simulation);
          },
          [recorder](Moment moment, const FrameInput& input, const StepReport& report,
                     std::span<const OperationEvent> events, const Simulation& simulation) {
            recorder->record(moment, input, report, events, simulation);
          }};
}

std::vector<SessionRecording> sessionRecordings() {
  std::vector<SessionRecording> recordings;
  for (const fs::path& path : recordingsIn(recordingsFolder())) {
    SessionRecording one{path, 0};
    for (const char* end : {"", "-wal"}) {
      std::error_code ec;
      if (const std::uintmax_t bytes = fs::file_size(path.string() + end, ec); !ec)
        one.bytes += bytes;
    }
    recordings.push_back(std::move(one));
  }
  std::ranges::reverse(recordings);
  return recordings;
}

}  // namespace resect
