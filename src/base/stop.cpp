#include "base/stop.h"

#include "base/progress.h"

namespace resect {
namespace {

thread_local const std::atomic<bool>* current = nullptr;

}  // namespace

StopBy::StopBy(const std::atomic<bool>& flag) : before_(current) { current = &flag; }

StopBy::~StopBy() { current = before_; }

const std::atomic<bool>* stopFlag() { return current; }

void checkStop() {
  if (current && current->load(std::memory_order_relaxed)) throw Cancelled{};
}

}  // namespace resect
