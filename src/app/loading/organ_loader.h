// Loads an organ in the background while the window stays usable.
//
// Model files are read by a separate process (this program's commands `info` and `convert`), which
// can be stopped at any moment. The cells are made in a thread. The running operation is not
// touched until the new organ is complete.
#pragma once

#include <QProcess>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "operation/live/operation_history.h"
#include "operation/scenario.h"
#include "record/recorder.h"
#include "simulation/simulation.h"

namespace resect {

// If the scenario has no instruments, gives it the instruments that come with Resect. Instruments
// that stop bleeding are left out if no organ can bleed. Sets the rest pose of every instrument to
// its place in the tool box.
Scenario withInstruments(Scenario scenario);

// Returns the setup with half of the processor's threads for the tissue, which leaves the other
// half for drawing. If the setup already has a number of threads, returns it unchanged.
TissueSetup besideDrawing(TissueSetup setup);

class OrganLoader {
 public:
  OrganLoader();
  ~OrganLoader();  // abandons loading in progress; waits for all threads to end

  struct Result {
    Scenario scenario;
    std::unique_ptr<Simulation> simulation;  // null if loading failed; `problem` says why
    std::vector<std::string> notes;
    std::string problem;
    std::string recording = {};  // recording from which the operation was loaded; empty: none
    // History and recorder of an operation that goes on where its recording ended
    // (operation_loader.h). Both are empty in all other cases.
    std::optional<OperationHistory> history = {};
    std::shared_ptr<Recorder> recorder = {};
  };

  // Loads one scenario at a time. A new call abandons the loading that is in progress, and does not
  // wait for its thread. `progress` gets the share of the work that is done, 0 to 1, or -1 while
  // this share is unknown. `done` is called at the end, unless loading was abandoned. Both
  // functions are called on the window's thread.
  void load(const Scenario& scenario, std::function<void(double)> progress,
            std::function<void(Result)> done);
  void cancel();
  bool busy() const { return timer_.isActive(); }

 private:
  struct Job;
  // A model file that the job needs, and the part of this file that is read.
  struct ModelToRead {
    std::string* file;
    std::string* part;
    bool repair = false;
  };
  void poll();
  void readNext();  // starts reading the next model file; after the last one, starts the job
  void removeConverted();

  std::function<void(double)> progress_;
  std::function<void(Result)> done_;
  std::unique_ptr<QProcess> reader_;
  std::vector<ModelToRead> toRead_;     // its pointers point into the job's scenario
  std::size_t next_ = 0;                // index in toRead_ of the file being read
  std::vector<std::string> converted_;  // files that the reading processes wrote
  int files_ = 0;                       // number of files converted so far
  std::unique_ptr<Job> job_;
  std::vector<std::unique_ptr<Job>> givenUp_;  // abandoned jobs whose threads are still running
  QTimer timer_;
};

// Examines one file at a time in a separate process. A new call ends the previous examination; the
// `done` of that examination is then not called. examine() runs `resect info` on the file, or on
// one of its parts. `done` gets the JSON that the process prints, and an empty `problem`. On
// failure, `done` gets an empty `json`, and the sentence of the error as `problem`. slices: name of
// the file for a picture of a label image's slices; "": no picture is written.
class FileExaminer {
 public:
  ~FileExaminer() { cancel(); }
  void examine(
      const std::string& file, const std::string& part, const std::string& slices,
      const std::function<void(const std::string& json, const std::string& problem)>& done);
  // Writes the surface of the file, or of the parts that `part` names, to the file `ply` with
  // `resect convert`. `done` gets the sentence of the error as `problem`, or an empty `problem` if
  // there was no error.
  void writeSurface(const std::string& file, const std::string& part, const std::string& ply,
                    const std::function<void(const std::string& problem)>& done);
  void cancel();

 private:
  void start(const QStringList& arguments,
             const std::function<void(const std::string& json, const std::string& problem)>& done);

  std::unique_ptr<QProcess> process_;
};

}  // namespace resect
