// Measures how many pictures are shown per second, and how soon a picture shows the effect of an
// input or of a removal of tissue.
//
// The latency of an input is counted from the display server's time stamp of that input. So the
// latency includes the time for which the input waited in queues.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace resect {

// Converts a display server's time stamp (ms, lower 32 bits) to the clock of steadySeconds(), s. If
// the stamp is not from the last 10 s, the server seems to use another clock; then the result is
// the present time.
double steadySecondsOf(std::uint64_t stamp);

// All times are of the clock of steadySeconds(), s.
class Pace {
 public:
  void inputCame(double at);
  // To be called when the drawing of a picture begins. The picture shows the effects of all inputs
  // that came before this call. looked: when the changes in the picture were taken from the
  // operation. lastRemoval: time of the newest removal of tissue in the picture.
  void pictureBegins(double looked, double lastRemoval);
  void pictureIsDrawn();
  void pictureShown();

  struct Second {
    double rate = 0;     // pictures shown per second
    double drawing = 0;  // mean time to draw a picture, s
    // Time from an input to the picture that shows the effect of the input, s. latency: median.
    // most: longest time. Both are 0 if there was no input.
    double latency = 0, most = 0;
    // Largest number of pictures shown after an input, up to and including the first picture that
    // shows the effect of that input.
    int pictures = 0;
    // inputs: number of inputs whose effect was shown. late: number of inputs whose effect was
    // first shown by the third picture after the input, or by a later picture.
    int inputs = 0, late = 0;
    // Largest number of pictures begun after a removal of tissue, up to and including the picture
    // that shows the removal.
    int removal = 0;
  };
  // To be called often. Once a second, this function evaluates the time since the last evaluation
  // and returns the figures of this time. Between evaluations it returns no value. It also returns
  // no value if no picture was shown.
  std::optional<Second> take();

 private:
  struct Input {
    double at;
    bool inPicture;
  };
  std::vector<Input> waiting_;
  // begun_: the argument `looked` of pictureBegins(), for the last 64 pictures. shown_: times at
  // which the last 64 pictures were shown.
  std::vector<double> begun_, shown_;
  std::vector<double> latencies_;
  int pictures_ = 0, late_ = 0, removal_ = 0, count_ = 0;
  double seenRemoval_ = 0, since_ = 0, drawing_ = 0;
};

}  // namespace resect
