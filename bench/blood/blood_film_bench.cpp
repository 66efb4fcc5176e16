// A frame of blood that runs over a liver, all of whose skin is wet, while more is poured on its
// top. Argument: about the number of wet cells. Counters: those that are wet, and the median and
// the 99th percentile of the frames, ms of the processor, so that other programs do not count.

#include "blood/film/blood_film.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "support/bench_organs.h"

using namespace resect;

namespace {

constexpr double kFrame = 1.0 / 60;   // s
constexpr double kThickness = 0.001;  // m: of the film at the start
constexpr double kPoured = 10e-6;     // m^3/s

std::vector<std::int64_t> skinOf(const OperatedOrgan& organ) {
  const SkinCells skin(organ);
  std::vector<std::int64_t> cells;
  for (std::int64_t i = 0; i < organ.organ.rest.lattice.cellCount(); ++i)
    if (skin.isSkin(skin.numberOf(i))) cells.push_back(i);
  return cells;
}

OperatedOrgan liverOf(double particles) {
  return operatedOrgan("liver", makeOrgan(bench::liverCells(particles), {}));
}

// The skin grows with the number of particles to the power of 2/3.
OperatedOrgan liverWithSkin(double cells) {
  const double reference = 1e4;
  const double skin = double(skinOf(liverOf(reference)).size());
  return liverOf(reference * std::pow(cells / skin, 1.5));
}

void filmFrame(benchmark::State& state) {
  const OperatedOrgan organ = liverWithSkin(double(state.range(0)));
  std::vector<std::int64_t> cells = skinOf(organ);
  BloodFilm film;
  film.setUp(organ);
  for (const std::int64_t cell : cells)
    film.add(cell, toPicolitres(kThickness * film.skin()[film.skin().numberOf(cell)].area));
  // Poured on the highest.
  const Lattice& lattice = organ.organ.rest.lattice;
  const auto lower = [&](std::int64_t a, std::int64_t b) {
    return lattice.cell(a).y() < lattice.cell(b).y();
  };
  const std::int64_t top = *std::ranges::max_element(cells, lower);

  std::vector<BloodDrop> drops;
  std::vector<double> times;  // ms
  for (auto _ : state) {
    const std::clock_t start = std::clock();
    film.add(top, toPicolitres(kPoured * kFrame));
    film.place(organ);
    film.step(kFrame, true, drops);
    film.collect();
    times.push_back(1e3 * double(std::clock() - start) / CLOCKS_PER_SEC);
    drops.clear();
  }
  std::ranges::sort(times);
  state.counters["wet"] = double(film.wet().size());
  state.counters["median_ms"] = times[times.size() / 2];
  state.counters["p99_ms"] = times[std::min(times.size() - 1, times.size() * 99 / 100)];
}
BENCHMARK(filmFrame)->Arg(500)->Arg(3000)->Arg(5000)->Iterations(1200)->Unit(
    benchmark::kMillisecond);

}  // namespace
