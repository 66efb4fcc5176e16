// How many pictures come, and how soon do they show what the hand did and what was taken away?
//
// An input is timed from when the display server saw it, so waiting in queues counts.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace resect {

// steadySeconds() of a display server's stamp (ms, its lower 32 bits), or now where that is another
// clock.
double steadySecondsOf(std::uint64_t stamp);

class Pace {
 public:
  void inputCame(double at);
  // A picture begins that shows all inputs until `looked` and all particles taken until
  // `lastRemoval`.
  void pictureBegins(double looked, double lastRemoval);
  void pictureIsDrawn();
  void pictureShown();

  struct Second {
    double rate = 0;               // pictures per second
    double drawing = 0;            // s per picture, on average
    double latency = 0, most = 0;  // input to picture: median, longest; s
    int pictures = 0;          // that came to the screen from an input until it was shown, at most
    int inputs = 0, late = 0;  // shown, and of these with the third picture or later
    int removal = 0;  // pictures begun after particles were taken until they were gone, at most
  };
  // Once a second in which a picture was drawn; without input there is no latency: 0.
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
