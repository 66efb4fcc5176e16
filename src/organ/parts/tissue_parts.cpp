#include "organ/parts/tissue_parts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "base/stop.h"
#include "tissue/stencil.h"

namespace resect {
namespace {

// Flags, per cell of the lattice, of those that lie beside a severed grid edge; empty without one.
// Bonds can be severed between these cells only.
std::vector<std::uint8_t> cellsBesideCuts(const Organ& organ) {
  std::vector<std::uint8_t> beside;
  if (organ.severed.empty()) return beside;
  const Lattice& lattice = organ.rest.lattice;
  const int refine = organ.field.refine();
  beside.assign(std::size_t(lattice.cellCount()), 0);
  for (std::int64_t b = 0; b < organ.field.brickCount(); ++b) {
    if (!organ.severed.near(b)) continue;
    // The cells whose centres are nodes of the brick or of the planes just above it.
    const Vec3i node = kBrickNodes * organ.field.brick(b);
    Vec3i low, high;
    for (int a = 0; a < 3; ++a) {
      low[a] = std::max(0, (node[a] + refine - 1) / refine - 2);
      high[a] = std::min(lattice.dims[a] - 1, (node[a] + kBrickNodes) / refine - 2);
    }
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) beside[std::size_t(lattice.index({x, y, z}))] = 1;
  }
  return beside;
}

class PartFinder {
 public:
  explicit PartFinder(const OperatedOrgan& organ)
      : lattice_(organ.organ.rest.lattice),
        alive_(organ.organ.alive),
        tissue_(*organ.tissue),
        moving_(organ.tissue->moves()) {
    if (!moving_) beside_ = cellsBesideCuts(organ.organ);
  }

  TissueParts run() {
    findRuns();
    joinRows();
    joinBonded();
    TissueParts parts;
    std::vector<std::int32_t> number(runs_.size(), -1);
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      std::int32_t& part = number[std::size_t(rootOf(std::int32_t(r)))];
      if (part < 0) part = parts.count++;
      runs_[r].part = part;
    }
    parts.runs = std::move(runs_);
    return parts;
  }

 private:
  // Whether the cell is a run of its own, which bonds alone join to others.
  bool single(std::int64_t cell) const {
    return moving_ || (!beside_.empty() && beside_[std::size_t(cell)]);
  }

  void findRuns() {
    const std::int32_t length = lattice_.dims.x();
    const std::int64_t rows = std::int64_t(lattice_.dims.y()) * lattice_.dims.z();
    firstOfRow_.reserve(std::size_t(rows) + 1);
    for (std::int64_t row = 0; row < rows; ++row) {
      firstOfRow_.push_back(std::int32_t(runs_.size()));
      const std::uint8_t *const begin = alive_.data() + row * length, *const end = begin + length;
      for (const std::uint8_t* at = begin; at < end;) {
        at = static_cast<const std::uint8_t*>(std::memchr(at, 1, std::size_t(end - at)));
        if (!at) break;
        auto* stop = static_cast<const std::uint8_t*>(std::memchr(at, 0, std::size_t(end - at)));
        if (!stop) stop = end;
        addRuns(at - alive_.data(), stop - alive_.data());
        at = stop;
      }
    }
    firstOfRow_.push_back(std::int32_t(runs_.size()));
    parent_.resize(runs_.size());
    for (std::size_t i = 0; i < parent_.size(); ++i) parent_[i] = std::int32_t(i);
  }

  void addRuns(std::int64_t cell, std::int64_t end) {
    bool open = false;  // whether the last run goes on
    for (; cell < end; ++cell) {
      if (!moving_ && beside_.empty()) {
        runs_.push_back({cell, std::int32_t(end - cell), 0});
        return;
      }
      if (single(cell) || !open) runs_.push_back({cell, 0, 0});
      ++runs_.back().length;
      open = !single(cell);
    }
  }

  // Joins the runs of neighbouring rows that touch, but for single cells.
  void joinRows() {
    if (moving_) return;
    constexpr int kRows[4][2] = {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}};  // y, z
    const Vec3i dims = lattice_.dims;
    for (int z = 0; z < dims.z(); ++z) {
      checkStop();
      for (int y = 0; y < dims.y(); ++y)
        for (const auto& step : kRows) {
          const int u = y + step[0], w = z + step[1];
          if (u < 0 || w < 0 || u >= dims.y()) continue;
          joinTouching(std::size_t(z) * std::size_t(dims.y()) + std::size_t(y),
                       std::size_t(w) * std::size_t(dims.y()) + std::size_t(u));
        }
    }
  }

  void joinTouching(std::size_t row, std::size_t other) {
    const std::int64_t shift =
        (std::int64_t(row) - std::int64_t(other)) * std::int64_t(lattice_.dims.x());
    std::int32_t i = firstOfRow_[row], k = firstOfRow_[other];
    const std::int32_t end = firstOfRow_[row + 1], otherEnd = firstOfRow_[other + 1];
    const auto joinIfTouching = [&](std::int32_t p, std::int32_t q) {
      const CellRun &a = runs_[std::size_t(p)], &b = runs_[std::size_t(q)];
      const std::int64_t bFirst = b.first + shift;
      if (a.first <= bFirst + b.length && bFirst <= a.first + a.length && !single(a.first) &&
          !single(b.first))
        join(p, q);
    };
    while (i < end && k < otherEnd) {
      joinIfTouching(i, k);
      const CellRun &a = runs_[std::size_t(i)], &b = runs_[std::size_t(k)];
      const std::int64_t aEnd = a.first + a.length, bEnd = b.first + shift + b.length;
      if (aEnd == bEnd && i + 1 < end) joinIfTouching(i + 1, k);  // they may meet at a corner
      aEnd < bEnd ? ++i : ++k;
    }
  }

  void joinBonded() {
    if (!moving_ && beside_.empty()) return;
    std::vector<std::int32_t> runOf(alive_.size());  // of cells with tissue
    for (std::size_t r = 0; r < runs_.size(); ++r)
      std::fill_n(runOf.begin() + runs_[r].first, runs_[r].length, std::int32_t(r));
    std::array<std::int64_t, kDirections> step{};
    for (int d = 0; d < kDirections; ++d)
      step[std::size_t(d)] =
          offsetAlong(d, 0) +
          lattice_.dims.x() *
              (offsetAlong(d, 1) + std::int64_t(lattice_.dims.y()) * offsetAlong(d, 2));
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      const std::int64_t cell = runs_[r].first;
      if (!single(cell)) continue;
      // Of two single cells the lower one joins.
      const std::uint32_t bonds = tissue_.bonds(cell);
      for (std::uint32_t rest = bonds; rest != 0; rest &= rest - 1) {
        const int d = std::countr_zero(rest);
        const std::int64_t other = cell + step[std::size_t(d)];
        if (d >= kFirstForward || !single(other)) join(std::int32_t(r), runOf[std::size_t(other)]);
      }
    }
  }

  std::int32_t rootOf(std::int32_t run) {
    while (parent_[std::size_t(run)] != run)
      run = parent_[std::size_t(run)] = parent_[std::size_t(parent_[std::size_t(run)])];
    return run;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = rootOf(a), b = rootOf(b);
    parent_[std::size_t(std::max(a, b))] = std::min(a, b);
  }

  const Lattice& lattice_;
  const std::vector<std::uint8_t>& alive_;
  const TissueModel& tissue_;
  bool moving_;
  std::vector<std::uint8_t> beside_;
  std::vector<CellRun> runs_;
  std::vector<std::int32_t> firstOfRow_;  // per row, and one more
  std::vector<std::int32_t> parent_;  // per run: of the same part, with a lower number or itself
};

}  // namespace

TissueParts tissueParts(const OperatedOrgan& organ) { return PartFinder(organ).run(); }

}  // namespace resect
