// An Inventor file of half a million triangles: guarded, parsed, and both in a child process.

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>

#include "inventor/init.h"
#include "inventor/reading/iv_guard.h"
#include "inventor/reading/iv_reader.h"
#include "inventor/reading/model_file.h"
#include "io/mesh_file.h"
#include "organ/builtin/builtin_liver.h"

using namespace resect;

namespace {

// Written once, gone with the program.
const std::filesystem::path& liverFile() {
  struct File {
    std::filesystem::path path = std::filesystem::temp_directory_path() /
                                 ("resect_reading_bench_" + std::to_string(::getpid()) + ".iv");
    File() { writeMeshFile(path, builtinLiver(0.0009)); }
    ~File() { std::filesystem::remove(path); }
  };
  static const File file;
  return file.path;
}

std::string liverText() {
  std::ifstream in(liverFile(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void guardText(benchmark::State& state) {
  const std::string text = liverText();
  for (auto _ : state) guardInventorFile("liver.iv", text);
  state.SetBytesProcessed(state.iterations() * std::int64_t(text.size()));
}
BENCHMARK(guardText)->Unit(benchmark::kMillisecond);

void readHere(benchmark::State& state) {
  initInventor();
  const std::string text = liverText();
  for (auto _ : state) benchmark::DoNotOptimize(readInventorFile("liver.iv", text).parts.size());
}
BENCHMARK(readHere)->Unit(benchmark::kMillisecond);

void readInChild(benchmark::State& state) {
  initInventor();
  for (auto _ : state) benchmark::DoNotOptimize(readModel(liverFile()).parts.size());
}
BENCHMARK(readInChild)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
