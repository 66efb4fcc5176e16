#include "formats/child/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <new>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/asan_interface.h>
#endif

#include "base/error.h"
#include "formats/child/sandbox.h"

namespace resect {
namespace {

// Message of the child: the result or the error sentence, then a trailer with length and kind. A
// message without trailer is incomplete.
enum Kind : char { kResult = 'r', kFailed = 'f', kUsage = 'u', kNoMemory = 'm', kOther = 'o' };
constexpr int kAtOnce = 1 << 20;  // pipe capacity, bytes, if the system allows it
constexpr int kCannotWrite = 3;   // exit status of a child whose parent has closed the pipe

void limit(decltype(RLIMIT_CPU) resource, rlim_t soft, rlim_t hard) {
  rlimit value{};
  ::getrlimit(resource, &value);
  value.rlim_cur = std::min(soft, value.rlim_max);
  value.rlim_max = std::min(hard, value.rlim_max);
  ::setrlimit(resource, &value);
}

// Address space of this process, bytes; 0 if unknown.
rlim_t addressSpace() {
  long pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%ld", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return rlim_t(pages) * rlim_t(::sysconf(_SC_PAGESIZE));
}

void limitThisProcess(const ChildLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const auto cpu = rlim_t(std::ceil(limits.cpuSeconds));
  limit(RLIMIT_CPU, cpu, cpu + 1);
#ifndef RESECT_SANITIZED
  const rlim_t memory = addressSpace() + rlim_t(limits.memoryBytes);
  limit(RLIMIT_AS, memory, memory);
#endif
  // A crash of a library ends this process silently, whatever handlers the parent had.
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGTERM})
    ::signal(signal, SIG_DFL);
  if (::signal(SIGINT, SIG_DFL) == SIG_IGN) ::signal(SIGINT, SIG_IGN);
}

void writeAll(int pipe, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(pipe, data, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) ::_exit(kCannotWrite);
    data += written;
    size -= std::size_t(written);
  }
}

struct MessageEnd {
  std::uint64_t size;
  Kind kind;
};

void send(int pipe, Kind kind, const std::string& message) {
  writeAll(pipe, message.data(), message.size());
  MessageEnd end{};
  end.size = message.size();
  end.kind = kind;
  writeAll(pipe, reinterpret_cast<const char*>(&end), sizeof end);
}

// Removes the trailer of a message; false if it is incomplete.
bool takeEnd(std::string& bytes, Kind& kind) {
  MessageEnd end;
  if (bytes.size() < sizeof end) return false;
  std::memcpy(&end, bytes.data() + bytes.size() - sizeof end, sizeof end);
  if (end.size != bytes.size() - sizeof end) return false;
  bytes.resize(bytes.size() - sizeof end);
  kind = end.kind;
  return true;
}

#ifdef __SANITIZE_ADDRESS__
// The address sanitizer needs unlimited address space, and aborts on a failed allocation where
// operator new would throw: this hook sends the answer instead.
int gPipeOfThisChild = -1;
void answerWhenOutOfMemory(const char* report) {
  if (!std::strstr(report, "out of memory") && !std::strstr(report, "exceeds maximum")) return;
  send(gPipeOfThisChild, kNoMemory, "");
  ::_exit(0);
}
#endif

[[noreturn]] void runChild(int pipe, const ChildLimits& limits,
                           const std::function<std::string()>& work,
                           const std::function<void()>& prepare) {
  limitThisProcess(limits);
#ifdef __SANITIZE_ADDRESS__
  gPipeOfThisChild = pipe;
  __asan_set_error_report_callback(answerWhenOutOfMemory);
#endif
  Kind kind = kResult;
  std::string message;
  try {
    if (prepare) prepare();
    enterSandbox(pipe);
    message = work();
  } catch (const Error& e) {
    kind = e.status() == Error::Status::Usage ? kUsage : kFailed;
    message = e.what();
  } catch (const std::bad_alloc&) {
    kind = kNoMemory;
  } catch (const std::exception& e) {
    kind = kOther;
    message = e.what();
  } catch (...) {
    kind = kOther;
    message = "unknown exception";
  }
  send(pipe, kind, message);
  ::_exit(0);  // no destructors: the objects are the parent's
}

enum class Ended { Whole, TooLate, TooLong };

// Reads until the child closes its end.
Ended readAll(int pipe, const ChildLimits& limits, const std::function<void()>& meanwhile,
              std::string& bytes) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(limits.wallSeconds);
  std::string block(kAtOnce, '\0');
  auto due = Clock::now();
  for (;;) {
    const double left = std::chrono::duration<double>(end - Clock::now()).count();
    if (left <= 0) return Ended::TooLate;
    if (meanwhile && Clock::now() >= due) {
      meanwhile();
      due = Clock::now() + std::chrono::milliseconds(100);
    }
    pollfd request{pipe, POLLIN, 0};
    const int ready = ::poll(&request, 1, int(std::min(left * 1000 + 1, 100.0)));
    if (ready < 0 && errno != EINTR) return Ended::Whole;
    if (ready <= 0) continue;
    const ssize_t got = ::read(pipe, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return Ended::Whole;
    bytes.append(block.data(), std::size_t(got));
    if (bytes.size() > limits.answerBytes + sizeof(MessageEnd)) return Ended::TooLong;
  }
}

int waitFor(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

[[noreturn]] void throwOutcome(const std::string& subject, const ChildLimits& limits, int status) {
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU || signal == SIGKILL)
    throw error("{}: reading it took more than {:.0f} s of computing, so it was given up; {}",
                subject, limits.cpuSeconds, limits.ifTooLarge);
  if (signal != 0)
    throw error(
        "{}: the reader stopped on it ({}), so it is damaged or beyond what can be read; {}",
        subject, ::strsignal(signal), limits.ifDamaged);
#ifdef RESECT_SANITIZED
  // A sanitizer reported an error in the child: do not hide it.
  if (WEXITSTATUS(status) != 0 && WEXITSTATUS(status) != kCannotWrite) std::abort();
#endif
  throw error("{}: the reader stopped on it, so it is damaged or beyond what can be read; {}",
              subject, limits.ifDamaged);
}

}  // namespace

std::string runInChild(const std::string& subject, const ChildLimits& limits,
                       const std::function<std::string()>& work,
                       const std::function<void()>& meanwhile,
                       const std::function<void()>& prepare) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw error("{}: no pipe for its reader: {}; close other programs", subject,
                std::strerror(errno));
  ::fcntl(ends[0], F_SETPIPE_SZ, kAtOnce);
  // Flushed before the fork, so that buffered output is not written twice.
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw error("{}: no process for its reader: {}; close other programs", subject,
                std::strerror(errno));
  }
  if (child == 0) {
    ::close(ends[0]);
    runChild(ends[1], limits, work, prepare);
  }
  ::close(ends[1]);
  std::string bytes;
  Ended ended{};
  try {
    ended = readAll(ends[0], limits, meanwhile, bytes);
  } catch (...) {
    ::close(ends[0]);
    ::kill(child, SIGKILL);
    waitFor(child);
    throw;
  }
  ::close(ends[0]);
  if (ended != Ended::Whole) ::kill(child, SIGKILL);
  const int status = waitFor(child);
  if (ended == Ended::TooLate)
    throw error("{}: reading it took more than {:.1f} s, so it was given up; {}", subject,
                limits.wallSeconds, limits.ifTooLarge);
  if (ended == Ended::TooLong)
    throw error("{}: its content is larger than the {} MB that are taken; {}", subject,
                limits.answerBytes >> 20, limits.ifTooLarge);
  Kind kind{};
  if (!takeEnd(bytes, kind)) {
    if (meanwhile) meanwhile();  // the user may have killed the child
    throwOutcome(subject, limits, status);
  }
  if (kind == kResult) return bytes;
  if (kind == kFailed) throw Error(bytes);
  if (kind == kUsage) throw Error(bytes, Error::Status::Usage);
  if (kind == kNoMemory)
    throw error("{}: reading it needs more than {} MB of memory; {}", subject,
                limits.memoryBytes >> 20, limits.ifTooLarge);
  if (kind != kOther) throwOutcome(subject, limits, status);
  throw error("{}: the reader failed ({}); {}", subject, bytes, limits.ifDamaged);
}

static_assert(std::atomic<double>::is_always_lock_free);  // a lock would not work across processes

SharedNumber::SharedNumber(double value) {
  void* memory =
      ::mmap(nullptr, sizeof *value_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  value_ = new (memory) std::atomic<double>(value);
}

SharedNumber::~SharedNumber() { ::munmap(value_, sizeof *value_); }

}  // namespace resect
