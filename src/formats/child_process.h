// How is work on an untrusted file done so that nothing it does can harm this program?
//
// In a forked child with limits, whose bytes come back over a pipe. About 2 ms per call plus the
// copy.
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

// Runs `work` in a child and returns its bytes. An Error that `work` throws is thrown here with the
// same sentence and status; any other end (crash, limit, exception) becomes an Error about
// `subject`, the name of the file: what happened, and what to do.
//
// `work` runs on the copy of the calling thread alone: it may use neither threads nor locks that
// other threads of this process may hold, and what it changes in memory is lost. Its standard
// output and error go to nowhere; it cannot write files or leave a core dump.
//
// `meanwhile` is called here some ten times a second until the child is done, and once more when it
// ended otherwise; what it throws ends the child and is passed on.
std::string runInChild(const std::string& subject, const ChildLimits& limits,
                       const std::function<std::string()>& work,
                       const std::function<void()>& meanwhile = {});

// A number that a child of this process sets and this process reads, or the other way round.
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
