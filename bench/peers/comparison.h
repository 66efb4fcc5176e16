// Results of the comparison with other libraries.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace resect::bench {

// How much time may go into it.
struct Effort {
  bool quick = false;     // small sizes only, for a first look
  int runs = 9;           // of each, where one run does not take too long
  double patience = 600;  // s that the runs of a peer in one line may take together; at least one
};

// Times are medians, s. Zero for the peer: a line of our own, beside a goal and not beside a peer.
struct Comparison {
  std::string row;   // "A"
  std::string work;  // what is done
  std::string peer;  // by whom else
  double size = 0;
  std::string sizeUnit;  // "particles"
  int threads = 1;
  double resect = 0, peerTime = 0;
  int resectRuns = 0, peerRuns = 0;
  double drift = 1;       // our median after the peer's runs over the one before them
  double goal = 0;        // times faster; 0: none is set
  std::string agreement;  // what was checked, and what came out
  bool agrees = true;     // as it must

  double ratio() const { return peerTime / resect; }
};

// A figure of our own that a goal is set for.
struct Figure {
  std::string row, what, value, goal;
};

struct Findings {
  std::vector<Comparison> comparisons;
  std::vector<Figure> figures;
};

}  // namespace resect::bench
