#include "app/loading/operation_loader.h"

#include <atomic>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/progress.h"
#include "base/stop.h"
#include "io/operation_setup.h"
#include "record/recorded_history.h"
#include "record/session_recordings.h"

namespace resect {

struct OperationLoader::Job {
  Wish wish;
  OrganLoader::Result result;
  std::atomic<double> share{-1};
  std::atomic<bool> cancelled{false}, done{false};
  std::thread thread;

  ~Job() {
    cancelled = true;
    if (thread.joinable()) thread.join();
  }
  void work() {
    const StopBy stop(cancelled);
    try {
      RecordingFile recording =
          RecordingFile::open(wish.file, [this](double) { return !cancelled; });
      RecordedSetup setup = recording.setup();
      for (ScenarioOrgan& organ : setup.scenario.organs) organ.tissue = besideDrawing(organ.tissue);
      result.recording = wish.file.string();
      if (wish.anew) {
        result.simulation = std::make_unique<Simulation>(simulationOf(setup));
        result.scenario = std::move(setup.scenario);
        noteSlowFrames(*result.simulation, result.scenario, &result.notes);
        done = true;
        return;
      }
      RecordedOperation operation = operationOf(
          recording, std::move(setup), {},
          [this](double now) {
            share = now;
            return !cancelled;
          },
          wish.historyBytes);
      share = -1;
      if (wish.record) try {
          result.recorder =
              recordSession(operation.setup.scenario, recording, *operation.simulation);
        } catch (const Error& e) {
          result.notes.push_back(e.what());
        }
      result.scenario = std::move(operation.setup.scenario);
      result.simulation = std::move(operation.simulation);
      result.history = std::move(operation.history);
    } catch (const Cancelled&) {
      result.problem = "cancelled";
    } catch (const std::exception& e) {
      result.problem = e.what();
    }
    done = true;
  }
};

OperationLoader::OperationLoader() {
  QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { poll(); });
  timer_.setInterval(40);
}

void OperationLoader::cancel() {
  timer_.stop();
  done_ = {};
  // Its thread notices at its next check; nobody waits for it.
  if (job_) {
    job_->cancelled = true;
    givenUp_.push_back(std::move(job_));
  }
  std::erase_if(givenUp_, [](const auto& job) { return job->done.load(); });
}

OperationLoader::~OperationLoader() { cancel(); }

void OperationLoader::load(Wish wish, std::function<void(double)> progress,
                           std::function<void(OrganLoader::Result)> done) {
  cancel();
  progress_ = std::move(progress);
  done_ = std::move(done);
  job_ = std::make_unique<Job>();
  job_->wish = std::move(wish);
  job_->thread = std::thread([job = job_.get()] { job->work(); });
  timer_.start();
}

void OperationLoader::poll() {
  if (!job_->done) return progress_(job_->share);
  timer_.stop();
  const std::unique_ptr<Job> job = std::move(job_);
  std::exchange(done_, {})(std::move(job->result));
}

}  // namespace resect
