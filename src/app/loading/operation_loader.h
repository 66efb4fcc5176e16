// Opens a recorded operation in the background. The operation then goes on where the recording
// ended, or starts again from its beginning.
#pragma once

#include <QTimer>
#include <filesystem>

#include "app/loading/organ_loader.h"

namespace resect {

class OperationLoader {
 public:
  OperationLoader();
  ~OperationLoader();  // abandons loading in progress; waits for all threads to end

  struct Wish {
    std::filesystem::path file;
    bool anew = false;  // start again from the beginning, without the recorded work
    // Go on recording, into a new file (OrganLoader::Result::recorder). Has no effect if `anew` is
    // true.
    bool record = true;
    std::size_t historyBytes = 0;  // largest memory for the states of earlier moments, bytes
  };
  // Loads one operation at a time; a new call abandons the loading in progress. The recording's
  // file is not changed. `progress` and `done` are called as OrganLoader::load() calls them.
  void load(Wish wish, std::function<void(double)> progress,
            std::function<void(OrganLoader::Result)> done);
  void cancel();
  bool busy() const { return job_ != nullptr; }

 private:
  struct Job;
  void poll();

  std::function<void(double)> progress_;
  std::function<void(OrganLoader::Result)> done_;
  std::unique_ptr<Job> job_;
  std::vector<std::unique_ptr<Job>> givenUp_;  // abandoned jobs whose threads are still running
  QTimer timer_;
};

}  // namespace resect
