#include "record/session_recordings.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <vector>

#include "base/error.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

// Recordings in the folder, the last written first: one that is being written comes before all
// others.
std::vector<SessionRecording> recordingsIn(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, SessionRecording>> found;
  std::error_code ec;
  for (const auto& entry : fs::directory_iterator(folder, ec)) {
    if (entry.path().extension() != ".resect") continue;
    fs::file_time_type written = fs::file_time_type::min();
    SessionRecording one{entry.path(), 0};
    for (const fs::path& file : filesOfRecording(entry.path())) {
      if (const std::uintmax_t bytes = fs::file_size(file, ec); !ec) one.bytes += bytes;
      if (const auto time = fs::last_write_time(file, ec); !ec) written = std::max(written, time);
    }
    found.emplace_back(written, std::move(one));
  }
  std::ranges::sort(found, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second.path > b.second.path;
  });
  std::vector<SessionRecording> recordings;
  for (auto& [written, one] : found) recordings.push_back(std::move(one));
  return recordings;
}

// Removes all but the newest. kept: those that stay whatever the clock says.
void removeOld(const fs::path& folder, const std::vector<fs::path>& kept) {
  int left = kKeptRecordings - int(kept.size());
  for (const SessionRecording& one : recordingsIn(folder)) {
    std::error_code ec;
    const bool stays = std::ranges::any_of(
        kept, [&](const fs::path& path) { return fs::equivalent(path, one.path, ec); });
    if (stays || --left >= 0) continue;
    for (const char* end : {"", "-wal", "-shm"}) fs::remove(one.path.string() + end, ec);
  }
}

// What of a scenario's name may be part of a file's: it may come from a foreign recording.
std::string plainName(const std::string& name) {
  std::string plain;
  for (const char c : name.substr(0, 60))
    plain += std::isalnum(static_cast<unsigned char>(c)) || c == '-' ? c : '_';
  return plain.empty() ? "operation" : plain;
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
                              now.time_since_epoch().count() % 1000, plainName(scenario.name));
}

}  // namespace

std::shared_ptr<Recorder> recordSession(const Scenario& scenario, const Simulation& simulation) {
  auto recorder = std::make_shared<Recorder>(newRecording(scenario), scenario, simulation);
  removeOld(recordingsFolder(), {recorder->path()});
  return recorder;
}

std::shared_ptr<Recorder> recordSession(const Scenario& scenario, RecordingFile& done,
                                        const Simulation& simulation) {
  auto recorder = std::make_shared<Recorder>(newRecording(scenario), done, scenario, simulation);
  removeOld(recordingsFolder(), {recorder->path(), done.name()});
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

std::vector<SessionRecording> sessionRecordings() { return recordingsIn(recordingsFolder()); }

}  // namespace resect
