// How does an organ come into the window while the window goes on?
//
// Files that people give are read by a process of their own (this program's `info` and `convert`),
// which can be stopped at any moment; the cells are made in a thread. Nothing of the running
// operation is touched until all is done.
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

// The scenario with one of each instrument that comes with Resect, its own first, all in the tool
// box: what a person operates with.
Scenario withAllInstruments(Scenario scenario);

class OrganLoader {
 public:
  OrganLoader();
  ~OrganLoader();  // gives up what is under way

  struct Result {
    Scenario scenario;
    std::unique_ptr<Simulation> simulation;  // null: `problem` says why
    std::vector<std::string> notes;
    std::string problem;
  };

  // One at a time; a new call gives up the one before, without waiting for it. `progress` gets
  // shares 0..1, or -1 while nothing is known; `done` comes last, unless cancel() was called. Both
  // on the window's thread.
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
  std::vector<std::string> converted_;  // what readers wrote
  int files_ = 0;
  std::unique_ptr<Job> job_;
  std::vector<std::unique_ptr<Job>> givenUp_;  // whose threads have not noticed yet
  QTimer timer_;
};

// What is in a file: runs `resect info` on it, or on its part of that name, in a process of its
// own. `done` gets its JSON, or an empty text and the sentence that it ended with.
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
