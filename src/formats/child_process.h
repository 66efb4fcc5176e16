// Runs work on untrusted bytes in a forked child process inside a sandbox (formats/sandbox.h) with
// limits; its result comes back over a pipe. Cost: about 3 ms per call plus the copy.
//
// Crashes, endless loops and excessive memory of the work do not affect this process, and planted
// code in the child reaches nothing but the pipe.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

namespace resect {

struct ChildLimits {
  double cpuSeconds = 5;                           // of the child; > 0
  double wallSeconds = 20;                         // from start to last byte; > 0
  std::size_t memoryBytes = std::size_t(2) << 30;  // address space beyond what this process has;
                                                   // not limited in sanitized builds
};

// Runs `work` in a child and returns its bytes. An Error that `work` throws is rethrown here with
// the same sentence and status; any other end (crash, limit, exception) becomes an Error about
// `subject`, the file's name, with what happened and what to do.
//
// `work` runs on the copy of the calling thread alone: it must not use threads or locks that other
// threads of this process may hold, and its changes in memory are lost. It has no files: what it
// is to read must be in memory before the call. `prepare` runs in the child before the sandbox is
// entered, for libraries that load their own files at first use; it must not look at foreign bytes.
//
// `meanwhile` is called here about ten times a second until the child is done, and once more if it
// failed; an exception from it kills the child and is passed on.
std::string runInChild(const std::string& subject, const ChildLimits& limits,
                       const std::function<std::string()>& work,
                       const std::function<void()>& meanwhile = {},
                       const std::function<void()>& prepare = {});

// A number in memory shared by this process and its children.
class SharedNumber {
 public:
  explicit SharedNumber(double value);
  ~SharedNumber();
  SharedNumber(const SharedNumber&) = delete;
  SharedNumber& operator=(const SharedNumber&) = delete;
  void set(double value) { value_->store(value, std::memory_order_relaxed); }
  double get() const { return value_->load(std::memory_order_relaxed); }

 private:
  std::atomic<double>* value_;
};

}  // namespace resect
