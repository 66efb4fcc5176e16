// Opens a recorded operation in the background, so that it goes on where it was, or begins anew.
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
    bool anew = false;             // from the start of the operation, without what was done
    bool record = true;            // unless anew: into another recording, Result::recorder
    std::size_t historyBytes = 0;  // as operationOf() takes them
  };
  // Loads one operation at a time; a new call abandons the one before. The recording stays as it
  // is. `progress` and `done` are called as OrganLoader::load() calls them.
  void load(Wish wish, std::function<void(double)> progress,
            std::function<void(OrganLoader::Result)> done);
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
