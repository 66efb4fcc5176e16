#include "peers/timing.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace resect::bench {
namespace {

std::vector<double> timesOf(const Work& work, int runs) {
  std::vector<double> times;
  for (int i = 0; i < runs; ++i) times.push_back(secondsOf(work));
  return times;
}

}  // namespace

double secondsOf(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

void timeBoth(const Work& resect, const Work& peer, const Effort& effort, Comparison& line) {
  const double warm = secondsOf(resect);
  // Runs of some microseconds are repeated until the median rests on enough of them.
  const int ours = std::clamp(int(0.05 / std::max(warm, 1e-6)), effort.runs, 1000);
  std::vector<double> before = timesOf(resect, ours);
  std::vector<double> theirs;
  const double first = secondsOf(peer);
  if (first > 1) theirs.push_back(first);
  const int wanted =
      std::clamp(int(effort.patience / std::max(first, 1e-6)), 1, effort.runs) - int(theirs.size());
  for (const double time : timesOf(peer, wanted)) theirs.push_back(time);
  const std::vector<double> after = timesOf(resect, ours);
  line.drift = median(after) / median(before);
  before.insert(before.end(), after.begin(), after.end());
  line.resect = median(before);
  line.resectRuns = int(before.size());
  line.peerTime = median(theirs);
  line.peerRuns = int(theirs.size());
}

std::vector<int> threadCounts() {
  const int all = int(std::thread::hardware_concurrency());
  return all > 1 ? std::vector{1, all} : std::vector{1};
}

}  // namespace resect::bench
