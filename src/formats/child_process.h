// Runs work on untrusted bytes in a forked child process inside a sandbox (formats/sandbox.h), with
// limits on time and memory. The result comes back through a pipe. Cost: about 3 ms per call plus
// the copy.
//
// If the work crashes, loops endlessly or takes too much memory, this process goes on unharmed.
// Code that a file plants in the child can reach nothing but the pipe.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

namespace resect {

struct ChildLimits {
  double cpuSeconds = 5;                           // of the child; > 0
  double wallSeconds = 20;                         // from start to last byte; > 0
  std::size_t memoryBytes = std::size_t(2) << 30;  // address space on top of this process's;
                                                   // no limit in sanitized builds
};

// Runs `work` in a child and returns its bytes. An Error that `work` throws is rethrown here with
// the same sentence and status; any other end (crash, limit, exception) becomes an Error about
// `subject`, the file's name, that says what happened and what to do.
//
// The child has a copy of the calling thread only, so `work` must not wait for other threads, nor
// take locks that other threads of this process may hold. Its changes in memory are lost. It cannot
// open files: what it is to read must be in memory before the call.
//
// `prepare` runs in the child before the sandbox is entered. It is for libraries that load files of
// their own at first use, and must not look at untrusted bytes.
//
// `meanwhile` is called in this process about ten times a second until the child is done, and once
// more if the child ended without an answer. If it throws, the child is killed and the exception is
// passed on.
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
