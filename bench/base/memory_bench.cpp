// Memory bandwidth of this machine. The floors of docs/performance.md are counted with it.
#include <benchmark/benchmark.h>

#include <cstring>
#include <vector>

namespace resect {
namespace {

void copyMegabytes(benchmark::State& state) {
  const std::vector<char> from(std::size_t(state.range(0)) * 1'000'000, 1);
  std::vector<char> to(from.size());
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::ClobberMemory();
  }
  // Read and written.
  state.SetBytesProcessed(state.iterations() * 2 * std::int64_t(from.size()));
}
BENCHMARK(copyMegabytes)->Arg(16)->Arg(60)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace resect
