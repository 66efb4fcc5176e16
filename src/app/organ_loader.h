// Loads an organ in the background while the window goes on.
//
// Files from outside are read by a separate process (this program's `info` and `convert`), which
// can be stopped at any moment; the cells are made in a thread. The running operation is not
// touched until all is done.
#pragma once

#include <QProcess>
#include <QTimer>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "operation/scenario.h"
#include "simulation/simulation.h"

namespace resect {

// The scenario with one of each shipped instrument, its own first, all in the tool box.
Scenario withAllInstruments(Scenario scenario);

class OrganLoader {
 public:
  OrganLoader();
  ~OrganLoader();  // abandons loading in progress

  struct Result {
    Scenario scenario;
    std::unique_ptr<Simulation> simulation;  // null: `problem` says why
    std::vector<std::string> notes;
    std::string problem;
  };

  // One at a time; a new call abandons the one before without waiting for it. `progress` gets
  // shares 0..1, or -1 while nothing is known; `done` is called last, unless cancel() was called.
  // Both on the window's thread.
  void load(const Scenario& scenario, std::function<void(double)> progress,
            std::function<void(Result)> done);
  void cancel();
  bool busy() const { return timer_.isActive(); }

 private:
  struct Job;
  void poll();
  void readNext();  // starts the reader of the next organ's file; after the last one the job
  void removeConverted();

  std::function<void(double)> progress_;
  std::function<void(Result)> done_;
  std::unique_ptr<QProcess> reader_;
  std::size_t next_ = 0;                // the organ whose file is read
  std::vector<std::string> converted_;  // files that readers wrote
  int files_ = 0;
  std::unique_ptr<Job> job_;
  std::vector<std::unique_ptr<Job>> givenUp_;  // abandoned jobs whose threads are still running
  QTimer timer_;
};

// Examines a file: runs `resect info` on it, or on one of its parts, in a separate process. `done`
// gets its JSON, or an empty text and the error sentence.
class FileExaminer {
 public:
  ~FileExaminer() { cancel(); }
  void examine(
      const std::string& file, const std::string& part,
      const std::function<void(const std::string& json, const std::string& problem)>& done);
  void cancel();

 private:
  std::unique_ptr<QProcess> process_;
};

}  // namespace resect
