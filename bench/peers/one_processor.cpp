#include "peers/one_processor.h"

#include <charconv>
#include <filesystem>
#include <string>

namespace resect::bench {
namespace {

void keepAllThreadsTo(const cpu_set_t& processors) {
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
    const std::string name = thread.path().filename();
    pid_t id = 0;
    std::from_chars(name.data(), name.data() + name.size(), id);
    sched_setaffinity(id, sizeof processors, &processors);
  }
}

}  // namespace

OneProcessor::OneProcessor() {
  if (sched_getaffinity(0, sizeof before_, &before_) != 0) return;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(sched_getcpu(), &one);
  keepAllThreadsTo(one);
}

OneProcessor::~OneProcessor() { keepAllThreadsTo(before_); }

}  // namespace resect::bench
