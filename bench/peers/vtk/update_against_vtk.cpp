// C: the surface after 200 particles have been removed along a moving tool, beside VTK, which makes
// all of it anew.

#include <fmt/format.h>
#include <vtkVersion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "base/parallel.h"
#include "organ/organ.h"
#include "peers/rows.h"
#include "peers/timing.h"
#include "peers/vtk/vtk_field.h"
#include "peers/vtk/vtk_threads.h"
#include "support/bench_organs.h"

namespace resect::bench {
namespace {

constexpr int kTaken = 200, kPlaces = 24;

struct Edit {
  std::int64_t cell;
  float value;
};

// The kTaken particles nearest to a tool's way of `length` cells along x, with the skin that
// belongs to them.
std::vector<Edit> biteAt(const Discretization& cells, const Vec3i& middle, int length) {
  const Lattice& lattice = cells.lattice;
  struct Candidate {
    int distance;
    std::int64_t cell;
    auto operator<=>(const Candidate&) const = default;
  };
  constexpr int kReach = 9;
  const int half = length / 2;
  std::vector<Candidate> candidates;
  std::vector<std::int64_t> skin;
  for (int z = -kReach; z <= kReach; ++z)
    for (int y = -kReach; y <= kReach; ++y)
      for (int x = -kReach - half; x <= kReach + half; ++x) {
        const Vec3i c = middle + Vec3i(x, y, z);
        if (!lattice.contains(c)) continue;
        const std::int64_t i = lattice.index(c);
        const int along = std::max(std::abs(x) - half, 0);
        if (cells.inside[i])
          candidates.push_back({along * along + y * y + z * z, i});
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

// Bites side by side along x on the liver's front, on a line through its middle.
std::vector<std::vector<Edit>> bitesAlongTool(const Discretization& cells) {
  std::vector<std::vector<Edit>> bites;
  const Vec3i dims = cells.lattice.dims;
  for (int i = 0; i < kPlaces; ++i) {
    Vec3i c(int((0.25 + 0.5 * i / (kPlaces - 1)) * dims.x()), dims.y() / 2, dims.z() - 1);
    while (c.z() > 0 && !cells.inside[cells.lattice.index(c)]) --c.z();
    bites.push_back(biteAt(cells, c, 1));
  }
  return bites;
}

// What one bite costs, medians over all places: nodes evaluated, bricks looked at, ...
// newTriangles: those that were not there before, which any way of following the bite must write.
struct Cost {
  double nodes, bricks, triangles, newTriangles, seconds;
};

struct EarlierCorners {
  bool operator()(const std::array<Vec3f, 3>& a, const std::array<Vec3f, 3>& b) const {
    return std::lexicographical_compare(a[0].data(), a[0].data() + 9, b[0].data(), b[0].data() + 9);
  }
};

// Takes bites out of an organ and puts them back.
class Biter {
 public:
  using Bites = std::vector<std::vector<Edit>>;
  Biter(const Discretization& cells, Bites bites)
      : field(cells, 2), surface(field, 50), bites_(std::move(bites)) {
    for (const std::vector<Edit>& bite : bites_) countNewTriangles(bite);
    walk();
    forget();
  }

  // To all places: each bite is taken, timed, and put back.
  void walk() {
    for (const std::vector<Edit>& bite : bites_) {
      seconds_.push_back(secondsOf([&] { apply(bite, true); }));
      const auto& changes = surface.changes();
      nodes_.push_back(double(evaluated_) * kBrickSize);
      bricks_.push_back(double(changes.bricks));
      triangles_.push_back(
          std::accumulate(changes.triangles.begin(), changes.triangles.end(), 0.0,
                          [](double sum, const IndexRange& range) { return sum + range.count; }));
      apply(bite, false);
    }
  }

  Cost cost() const {
    return {median(nodes_), median(bricks_), median(triangles_), median(newTriangles_),
            median(seconds_)};
  }
  int bitesTaken() const { return int(seconds_.size()); }

  ColourField field;
  SurfaceTracker surface;

 private:
  void apply(const std::vector<Edit>& bite, bool removed) {
    for (const Edit& edit : bite) field.setCellValue(edit.cell, removed ? 0 : edit.value);
    const std::span<const std::int64_t> bricks = field.update();
    evaluated_ = std::ranges::count_if(bricks, [&](std::int64_t b) { return field.slot(b) >= 0; });
    surface.update(field, bricks);
  }
  // Where their corners lie, of the triangles in the bricks that a bite can change.
  std::set<std::array<Vec3f, 3>, EarlierCorners> trianglesNear(
      const std::vector<Edit>& bite) const {
    const Lattice& lattice = field.lattice();
    Aabb box;
    for (const Edit& edit : bite) box.grow(lattice.centre(lattice.cell(edit.cell)));
    std::set<std::array<Vec3f, 3>, EarlierCorners> found;
    surface.visitTriangles(
        field, box.padded(4 * lattice.spacing.maxCoeff()), [&](const Triangle& t) {
          const auto at = [&](std::size_t k) { return surface.points()[std::size_t(t[k])]; };
          if (t[0] != t[1]) found.insert({at(0), at(1), at(2)});
        });
    return found;
  }
  void countNewTriangles(const std::vector<Edit>& bite) {
    const auto before = trianglesNear(bite);
    apply(bite, true);
    double count = 0;
    for (const auto& triangle : trianglesNear(bite)) count += !before.contains(triangle);
    newTriangles_.push_back(count);
    apply(bite, false);
  }
  void forget() {
    for (auto* list : {&nodes_, &bricks_, &triangles_, &seconds_}) list->clear();
  }

  Bites bites_;
  std::int64_t evaluated_ = 0;  // bricks that hold a surface; others are only looked at
  std::vector<double> nodes_, bricks_, triangles_, newTriangles_, seconds_;
};

// A block of so many particles, and a groove along the middle of its upper face, one for each way
// in which the bricks can lie beside it. Flat at every size, as a liver is not; 11 cells long,
// since a ball of 200 of the smallest block's 1 000 particles would reach its other walls.
Cost costOnBlock(double particles) {
  const ThreadLimit limit(1);
  const int height = 2 * int(std::lround(std::cbrt(particles) / 2));  // a brick has two cells
  const int width = int(std::lround(std::sqrt(particles / height)));
  Discretization block;
  block.lattice.spacing = Vec3::Constant(0.005);
  block.lattice.dims = {width, width, height};
  block.value =
      ColourValues(RawArray<std::uint8_t>(std::size_t(block.lattice.cellCount()), kFullLevel));
  block.inside.assign(std::size_t(block.lattice.cellCount()), 1);
  std::vector<std::vector<Edit>> bites;
  for (const int y : {0, 1})
    for (const int x : {0, 1})
      bites.push_back(biteAt(block, {width / 2 - x, width / 2 - y, height - 1}, 11));
  Biter biter(block, std::move(bites));
  biter.walk();
  return biter.cost();
}

void addCounters(const std::vector<Cost>& costs, const std::string& organ, Findings& findings) {
  const std::pair<const char*, double Cost::*> counters[] = {
      {"nodes evaluated", &Cost::nodes},
      {"bricks looked at", &Cost::bricks},
      {"triangles written", &Cost::triangles},
      {"triangles that were not there before", &Cost::newTriangles}};
  for (const auto& [name, member] : counters) {
    const auto [low, high] = std::ranges::minmax(costs, {}, member);
    findings.figures.push_back({"C", fmt::format("{}, least to most of all {}s", name, organ),
                                fmt::format("{:.0f} to {:.0f}: {:.0f} % apart", low.*member,
                                            high.*member, 100 * (high.*member / low.*member - 1)),
                                member == &Cost::newTriangles ? "" : "at most 20 %"});
  }
}

}  // namespace

Findings updateAgainstVtk(const Effort& effort) {
  std::vector<double> sizes = {1e3, 1e4, 1e5};
  if (!effort.quick) sizes.push_back(1e6);
  std::vector<Cost> liverCosts, blockCosts;
  Findings findings;
  for (const double size : sizes) {
    const Discretization cells = liverCells(size);
    const Biter::Bites bites = bitesAlongTool(cells);
    for (const int threads : threadCounts()) {
      const ThreadLimit limit(threads);
      setVtkThreads(threads);
      Biter biter(cells, bites);
      VtkField vtk(cells, biter.field);
      Comparison line;
      line.row = "C";
      line.work = fmt::format("surface after {} particles are removed, nodes s/2 apart", kTaken);
      line.peer = fmt::format("VTK {}, all anew", vtkVersion::GetVTKVersion());
      line.size = double(cells.particleCount());
      line.sizeUnit = "particles";
      line.threads = threads;
      line.goal = size == 1e6 ? 40'000 : 0;
      vtk.recompute();
      const double difference = vtk.difference(biter.field);
      timeBoth([&] { biter.walk(); }, [&] { vtk.recompute(); }, effort, line);
      const Cost cost = biter.cost();
      line.resect = cost.seconds;
      line.resectRuns = biter.bitesTaken();
      SurfaceTracker rebuilt(biter.field, 50);
      const bool same = rebuilt.mesh().points == biter.surface.mesh().points &&
                        rebuilt.mesh().triangles == biter.surface.mesh().triangles;
      line.agreement = fmt::format("field to {:.0e}; {} a rebuild bit for bit", difference,
                                   same ? "equals" : "DIFFERS FROM");
      line.agrees = difference < 1e-4 && same;
      findings.comparisons.push_back(std::move(line));
      if (threads == 1) liverCosts.push_back(cost);
    }
    blockCosts.push_back(costOnBlock(size));
  }
  addCounters(liverCosts, "liver", findings);
  addCounters(blockCosts, "block", findings);
  findings.figures.push_back(
      {"C", "time at the largest organ over that at 10^4",
       fmt::format("{:.2f}", liverCosts.back().seconds / liverCosts[1].seconds), "at most 1.5"});
  return findings;
}

}  // namespace resect::bench
