// Measures the rate of pictures and the latency from input, or from removal of tissue, to the
// picture.
//
// Latency counts from the display server's time stamp of the input, so it includes queues.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace resect {

// A display server's time stamp (ms, lower 32 bits) as steadySeconds(); the present time if it is
// of another clock.
double steadySecondsOf(std::uint64_t stamp);

class Pace {
 public:
  void inputCame(double at);
  // A picture begins that includes all inputs up to `looked` and all removals up to `lastRemoval`.
  void pictureBegins(double looked, double lastRemoval);
  void pictureIsDrawn();
  void pictureShown();

  struct Second {
    double rate = 0;               // pictures per second
    double drawing = 0;            // s per picture, on average
    double latency = 0, most = 0;  // input to picture: median, longest; s
    int pictures = 0;              // most pictures from an input to the one that shows it
    int inputs = 0, late = 0;      // inputs shown; of these, with the third picture or later
    int removal = 0;               // most pictures begun from a removal to the one that shows it
  };
  // Once a second if a picture was drawn. Latency is 0 without input.
  std::optional<Second> take();

 private:
  struct Input {
    double at;
    bool inPicture;
  };
  std::vector<Input> waiting_;
  std::vector<double> begun_, shown_;  // lately
  std::vector<double> latencies_;
  int pictures_ = 0, late_ = 0, removal_ = 0, count_ = 0;
  double seenRemoval_ = 0, since_ = 0, drawing_ = 0;
};

}  // namespace resect
