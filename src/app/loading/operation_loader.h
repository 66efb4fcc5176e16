// Opens a recorded operation in the background, so that it goes on where it was.
#pragma once

#include <QTimer>
#include <filesystem>

#include "app/loading/organ_loader.h"

namespace resect {

class OperationLoader {
 public:
  OperationLoader();
  ~OperationLoader();  // abandons loading in progress; waits for all threads to end

  // Loads one operation at a time; a new call abandons the one before. The recording stays as it
  // is: what is done from now on is kept in another one (Result::recorder), if `record`.
  // historyBytes: as operationOf() takes them.
  // `progress` and `done` are called as OrganLoader::load() calls them.
  void load(const std::filesystem::path& file, bool record, std::size_t historyBytes,
            std::function<void(double)> progress, std::function<void(OrganLoader::Result)> done);
  void cancel();

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
