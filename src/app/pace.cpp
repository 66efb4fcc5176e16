#include "app/pace.h"

#include <algorithm>

#include "base/stage_clock.h"

namespace resect {
namespace {

constexpr std::size_t kKept = 64;  // pictures

void keep(std::vector<double>& times, double time) {
  if (times.size() == kKept) times.erase(times.begin());
  times.push_back(time);
}

int countAfter(const std::vector<double>& times, double time) {
  return int(std::ranges::count_if(times, [&](double t) { return t > time; }));
}

}  // namespace

double steadySecondsOf(std::uint64_t stamp) {
  const double now = steadySeconds();
  const auto age = std::uint32_t(std::uint64_t(now * 1e3) - stamp);
  constexpr std::uint32_t kOldest = 10'000;
  return age < kOldest ? now - 1e-3 * age : now;
}

void Pace::inputCame(double at) { waiting_.push_back({at, false}); }

void Pace::pictureBegins(double looked, double lastRemoval) {
  keep(begun_, looked);
  for (Input& input : waiting_) input.inPicture = true;
  if (lastRemoval == seenRemoval_) return;
  seenRemoval_ = lastRemoval;
  removal_ = std::max(removal_, countAfter(begun_, lastRemoval));
}

void Pace::pictureIsDrawn() { drawing_ += steadySeconds() - begun_.back(); }

void Pace::pictureShown() {
  const double now = steadySeconds();
  keep(shown_, now);
  ++count_;
  for (const Input& input : waiting_) {
    if (!input.inPicture) continue;
    latencies_.push_back(now - input.at);
    const int pictures = countAfter(shown_, input.at);
    pictures_ = std::max(pictures_, pictures);
    late_ += pictures > 2;
  }
  std::erase_if(waiting_, [](const Input& input) { return input.inPicture; });
}

std::optional<Pace::Second> Pace::take() {
  const double now = steadySeconds();
  if (now - since_ < 1) return {};
  std::optional<Second> second;
  if (count_ > 0) {
    std::ranges::sort(latencies_);
    second = {count_ / (now - since_),
              drawing_ / count_,
              latencies_.empty() ? 0 : latencies_[latencies_.size() / 2],
              latencies_.empty() ? 0 : latencies_.back(),
              pictures_,
              int(latencies_.size()),
              late_,
              removal_};
  }
  since_ = now;
  count_ = pictures_ = late_ = removal_ = 0;
  drawing_ = 0;
  latencies_.clear();
  return second;
}

}  // namespace resect
