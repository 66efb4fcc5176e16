// C: the surface after 200 particles have been removed along a moving tool, beside VTK, which makes
// all of it anew.

#include <fmt/format.h>
#include <vtkVersion.h>

#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "organ/organ.h"
#include "peers/rows.h"
#include "peers/timing.h"
#include "peers/vtk_field.h"
#include "peers/vtk_threads.h"
#include "support/bench_organs.h"

namespace resect::bench {
namespace {

constexpr int kTaken = 200, kPlaces = 24;

struct Edit {
  std::int64_t cell;
  float value;
};

// The kTaken particles nearest to a cell, with the skin that belongs to them.
std::vector<Edit> biteAt(const Discretization& cells, const Vec3i& middle) {
  const Lattice& lattice = cells.lattice;
  struct Candidate {
    int distance;
    std::int64_t cell;
    auto operator<=>(const Candidate&) const = default;
  };
  constexpr int kReach = 9;
  std::vector<Candidate> candidates;
  std::vector<std::int64_t> skin;
  for (int z = -kReach; z <= kReach; ++z)
    for (int y = -kReach; y <= kReach; ++y)
      for (int x = -kReach; x <= kReach; ++x) {
        const Vec3i c = middle + Vec3i(x, y, z);
        if (!lattice.contains(c)) continue;
        const std::int64_t i = lattice.index(c);
        if (cells.inside[i])
          candidates.push_back({x * x + y * y + z * z, i});
        else if (cells.value[i] > 0)
          skin.push_back(i);
      }
  const std::size_t taken = std::min(candidates.size(), std::size_t(kTaken));
  std::partial_sort(candidates.begin(), candidates.begin() + taken, candidates.end());
  std::vector<std::int64_t> particles;
  for (std::size_t i = 0; i < taken; ++i) particles.push_back(candidates[i].cell);
  std::sort(particles.begin(), particles.end());
  std::vector<Edit> edits;
  for (const std::int64_t cell : particles) edits.push_back({cell, cells.value[cell]});
  for (const std::int64_t cell : skin)
    if (std::binary_search(particles.begin(), particles.end(), ownerCell(cells, cell)))
      edits.push_back({cell, cells.value[cell]});
  return edits;
}

// Places side by side along x on the liver's front, on a line through its middle.
std::vector<std::vector<Edit>> bitesAlongTool(const Discretization& cells) {
  std::vector<std::vector<Edit>> bites;
  const Vec3i dims = cells.lattice.dims;
  for (int i = 0; i < kPlaces; ++i) {
    Vec3i c(int((0.25 + 0.5 * i / (kPlaces - 1)) * dims.x()), dims.y() / 2, dims.z() - 1);
    while (c.z() > 0 && !cells.inside[cells.lattice.index(c)]) --c.z();
    bites.push_back(biteAt(cells, c));
  }
  return bites;
}

}  // namespace

Findings updateAgainstVtk(const Effort& effort) {
  std::vector<double> sizes = {1e3, 1e4, 1e5};
  if (!effort.quick) sizes.push_back(1e6);
  struct Counters {
    double particles, bricks, triangles, seconds;
  };
  std::vector<Counters> counters;
  Findings findings;
  for (const double size : sizes) {
    const Discretization cells = liverCells(size);
    const std::vector<std::vector<Edit>> bites = bitesAlongTool(cells);
    ColourField field(cells, 2);
    SurfaceTracker surface(field, 50);
    VtkField vtk(cells, field);
    const ThreadLimit limit(1);
    setVtkThreads(1);
    std::vector<double> bricks, triangles, times;
    const auto apply = [&](const std::vector<Edit>& bite, bool removed) {
      for (const Edit& edit : bite) field.setCellValue(edit.cell, removed ? 0 : edit.value);
      surface.update(field, field.update());
    };
    // A walk over all places: each bite is taken, timed, and put back.
    const auto walk = [&] {
      for (const std::vector<Edit>& bite : bites) {
        times.push_back(secondsOf([&] { apply(bite, true); }));
        const auto& changes = surface.changes();
        bricks.push_back(double(changes.bricks));
        triangles.push_back(
            std::accumulate(changes.triangles.begin(), changes.triangles.end(), 0.0,
                            [](double sum, const IndexRange& range) { return sum + range.count; }));
        apply(bite, false);
      }
    };
    walk();
    times.clear(), bricks.clear(), triangles.clear();
    Comparison line;
    line.row = "C";
    line.work = fmt::format("surface after {} particles are removed, nodes s/2 apart", kTaken);
    line.peer = fmt::format("VTK {}, all anew", vtkVersion::GetVTKVersion());
    line.size = double(cells.particleCount());
    line.sizeUnit = "particles";
    line.goal = size == 1e6 ? 40'000 : 0;
    timeBoth([&] { walk(); }, [&] { vtk.recompute(); }, effort, line);
    line.resect = median(times);
    line.resectRuns = int(times.size());
    const double difference = vtk.difference(field);
    SurfaceTracker rebuilt(field, 50);
    const bool same = rebuilt.mesh().points == surface.mesh().points &&
                      rebuilt.mesh().triangles == surface.mesh().triangles;
    line.agreement = fmt::format("field to {:.0e}; {} a rebuild bit for bit", difference,
                                 same ? "equals" : "DIFFERS FROM");
    counters.push_back({line.size, median(bricks), median(triangles), line.resect});
    findings.comparisons.push_back(std::move(line));
  }
  const auto range = [&](auto member) {
    const auto [low, high] = std::ranges::minmax(counters, {}, member);
    return fmt::format("{:.0f} to {:.0f}: {:.0f} % apart", low.*member, high.*member,
                       100 * (high.*member / low.*member - 1));
  };
  findings.figures.push_back(
      {"C", "bricks touched, smallest to largest organ", range(&Counters::bricks), "at most 20 %"});
  findings.figures.push_back({"C", "triangles touched, smallest to largest organ",
                              range(&Counters::triangles), "at most 20 %"});
  findings.figures.push_back({"C", "time at the largest organ over that at 10^4",
                              fmt::format("{:.2f}", counters.back().seconds / counters[1].seconds),
                              "at most 1.5"});
  return findings;
}

}  // namespace resect::bench
