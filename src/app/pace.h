// Measures the rate of pictures, and how late inputs and removals of tissue appear in a picture.
//
// Latency counts from the display server's time stamp of the input, so it includes the time that
// the input waits in queues.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace resect {

// Converts a display server's time stamp (ms, lower 32 bits) to the clock of steadySeconds(). A
// stamp that is not of the last 10 s is of another clock: the result is then the present time.
double steadySecondsOf(std::uint64_t stamp);

class Pace {
 public:
  void inputCame(double at);
  // A picture begins that includes all inputs up to `looked` and all removals up to `lastRemoval`.
  // These times, and `at`, are of steadySeconds().
  void pictureBegins(double looked, double lastRemoval);
  void pictureIsDrawn();
  void pictureShown();

  struct Second {
    double rate = 0;               // pictures per second
    double drawing = 0;            // s per picture, on average
    double latency = 0, most = 0;  // s, from input to picture: median, longest
    int pictures = 0;  // most pictures shown after an input, the one with its effect included
    int inputs = 0, late = 0;  // inputs shown; of these, only by the third picture or later
    int removal = 0;  // most pictures begun after a removal, the one that shows it included
  };
  // Gives, once a second, the figures of that second, if a picture was shown in it. Without input
  // the latencies are 0.
  std::optional<Second> take();

 private:
  struct Input {
    double at;
    bool inPicture;
  };
  std::vector<Input> waiting_;
  std::vector<double> begun_, shown_;  // times of the last pictures, s
  std::vector<double> latencies_;
  int pictures_ = 0, late_ = 0, removal_ = 0, count_ = 0;
  double seenRemoval_ = 0, since_ = 0, drawing_ = 0;
};

}  // namespace resect
