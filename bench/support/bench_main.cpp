// Runs the benchmarks of a layer, then sets what has two ways of doing it side by side.
//
// Benchmarks named WHAT/plain and WHAT/resect are a pair: how many times faster is the second? The
// medians of their repetitions are compared, both from this run.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>
#include <string>

#include "base/kept_memory.h"

namespace {

class PairReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Aggregate && run.aggregate_name == "median")
        median_[run.run_name.function_name] = run.GetAdjustedRealTime() * 1e-9 * nanoseconds(run);
  }

  void printPairs() const {
    bool first = true;
    for (const auto& [name, plain] : median_) {
      const std::string ending = "/plain";
      if (!name.ends_with(ending)) continue;
      const std::string what = name.substr(0, name.size() - ending.size());
      const auto resect = median_.find(what + "/resect");
      if (resect == median_.end()) continue;
      if (first)
        fmt::print("\n{:<44} {:>12} {:>12} {:>14}\n", "medians of this run", "plain [ms]",
                   "resect [ms]", "times faster");
      first = false;
      fmt::print("{:<44} {:>12.4f} {:>12.4f} {:>14.0f}\n", what, 1e3 * plain, 1e3 * resect->second,
                 plain / resect->second);
    }
  }

 private:
  static double nanoseconds(const Run& run) {
    return 1e9 / benchmark::GetTimeUnitMultiplier(run.time_unit);
  }

  std::map<std::string, double> median_;  // s, by name
};

}  // namespace

int main(int argc, char** argv) {
  resect::keepFreedMemory();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  PairReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.printPairs();
}
