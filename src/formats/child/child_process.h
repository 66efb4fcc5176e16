// Runs work on untrusted bytes in a forked child process, with limits on time and memory. The child
// works inside a sandbox (formats/child/sandbox.h). The result comes back through a pipe. Cost:
// about 3 ms per call, plus copying the result.
//
// If the work crashes, loops endlessly or takes too much memory, this process goes on unharmed. If
// a file makes the child run foreign code, this code can reach nothing but the pipe.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

namespace resect {

struct ChildLimits {
  double cpuSeconds = 5;    // computing time of the child; > 0
  double wallSeconds = 20;  // time from the start to the last byte of the result; > 0
  // Most address space that the child may use in addition to the address space of this process.
  // Builds with sanitizers do not have this limit.
  std::size_t memoryBytes = std::size_t(2) << 30;
  std::size_t answerBytes = std::size_t(2) << 30;  // most bytes of the result
  // The advice in an Error. ifTooLarge: advice for the case that a limit was reached. ifDamaged:
  // advice for the case that the reader crashed on the file.
  const char* ifTooLarge = "simplify the model";
  const char* ifDamaged = "export it again";
};

// Runs `work` in a child and returns the bytes that `work` returns. If `work` throws an Error,
// runInChild() throws an Error with the same sentence and status. Any other failure (crash, limit,
// other exception) gives an Error that names `subject`, the file's name, and says what happened and
// what to do.
//
// The child has a copy of the calling thread only. So `work` must not wait for other threads, nor
// take locks that other threads of this process may hold. All changes that `work` makes in memory
// are lost. `work` cannot open files: all data that it reads must be in memory before the call.
//
// `prepare` runs in the child before the sandbox is entered. It is meant for libraries that load
// files of their own at their first use. It must not look at untrusted bytes.
//
// `meanwhile` is called in this process about ten times a second until the child is done. It is
// called one more time if the child ended without sending a result or an Error. If `meanwhile`
// throws, the child is killed and the exception is passed on.
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
