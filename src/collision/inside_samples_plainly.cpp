// Hits of the grid, gathered row by row: each row's become the steps of its columns.
#include "collision/inside_samples.h"

#include <array>
#include <cmath>
#include <utility>

#include "base/instruction_set.h"
#include "base/parallel.h"
#include "collision/grid_hits.h"
#include "collision/sample_steps.h"

namespace resect {

namespace {

constexpr std::int32_t kUnsure = -1;

// Per hit the first point beyond it, by estimate; kUnsure where it is so near a point that the
// points must be asked. slack: points that an estimate may be wrong by.
RESECT_WIDEST
void estimate(std::span<const GridHit> hits, const SampleLine& line, double slack,
              std::int32_t* to) {
  typedef double Four __attribute__((vector_size(32)));
  typedef std::int32_t FourInts __attribute__((vector_size(16)));
  const double perPitch = 1 / line.pitch, most = line.count + 0.5;
  const auto pointsAt = [&](const Four& depth) __attribute__((always_inline))->FourInts {
    Four place = (depth - line.first) * perPitch + 1;
    place = place > 0.5 ? place : Four{} + 0.5;    // all below the first are alike,
    place = place < most ? place : Four{} + most;  // and all above the last
    const FourInts point = __builtin_convertvector(place, FourInts);
    const Four behind = place - __builtin_convertvector(point, Four);
    const auto sure = (behind > slack) & (behind < 1 - slack);
    return point | ~__builtin_convertvector(sure, FourInts);
  };
  std::size_t i = 0;
  for (; i + 4 <= hits.size(); i += 4) {
    const FourInts points =
        pointsAt(Four{hits[i].depth, hits[i + 1].depth, hits[i + 2].depth, hits[i + 3].depth});
    __builtin_memcpy(to + i, &points, sizeof points);
  }
  for (; i < hits.size(); ++i) to[i] = pointsAt(Four{} + hits[i].depth)[0];
}

class RowSampler {
 public:
  RowSampler(const GridHits& hits, const SampleLine& line, int columns)
      : hits_(hits),
        line_(line),
        slack_(slackOf(line)),
        counts_(std::size_t(columns)),
        first_(std::size_t(columns)) {}

  // offsets: of the row's columns, and where the last ends; all: stretches begin at offsets[0].
  void sample(std::size_t row, std::uint32_t* offsets, InsideStretch* all) {
    std::fill(counts_.begin(), counts_.end(), 0);
    more_.clear();
    for (const RowHits& part : hits_.parts) add(part[row]);
    std::sort(more_.begin(), more_.end());
    nextMore_ = more_.begin();
    InsideStretch* to = all + offsets[0];
    for (std::size_t c = 0; c < counts_.size(); ++c) {
      to = stretches(c, to);
      offsets[c + 1] = std::uint32_t(to - all);
    }
  }

 private:
  static constexpr int kFew = 4;  // steps of a column that are kept beside each other

  void add(std::span<const GridHit> hits) {
    points_.resize(std::max(points_.size(), hits.size()));
    estimate(hits, line_, slack_, points_.data());
    std::uint8_t* const counts = counts_.data();
    std::array<Step, kFew>* const first = first_.data();
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const auto c = std::size_t(hits[i].column);
      std::int32_t point = points_[i];
      if (point == kUnsure) [[unlikely]]
        point = line_.upTo(hits[i].depth);
      const Step s = step(point, hits[i].sign);
      if (counts[c] < kFew) [[likely]]
        first[c][counts[c]++] = s;
      else
        more_.push_back({hits[i].column, s});
    }
  }

  InsideStretch* stretches(std::size_t column, InsideStretch* to) {
    const int count = counts_[column];
    if (count < 2) return to;  // what enters alone ends nowhere
    std::array<Step, kFew>& first = first_[column];
    if (count == 2) [[likely]] {
      const Step low = std::min(first[0], first[1]), high = std::max(first[0], first[1]);
      *to = {std::int32_t(low >> 1), std::int32_t(high >> 1)};
      return to + (((low & 1) == 0) & ((high & 1) == 1) & (low >> 1 < high >> 1));
    }
    sorted_.assign(first.begin(), first.begin() + count);
    for (; nextMore_ != more_.end() && std::size_t(nextMore_->first) == column; ++nextMore_)
      sorted_.push_back(nextMore_->second);
    std::sort(sorted_.begin(), sorted_.end());
    return writeStretches<Step>(sorted_, to);
  }

  const GridHits& hits_;
  SampleLine line_;
  double slack_;                      // see estimate()
  std::vector<std::uint8_t> counts_;  // of them
  std::vector<std::array<Step, kFew>> first_;
  std::vector<std::pair<std::int32_t, Step>> more_;  // by column
  std::vector<std::pair<std::int32_t, Step>>::const_iterator nextMore_;
  std::vector<Step> sorted_;
  RawArray<std::int32_t> points_;
};

}  // namespace

InsideSamples insideSamplesPlainly(const SnappedMesh& mesh, const ColumnGrid& grid,
                                   const SampleLine& line) {
  InsideSamples inside;
  inside.countX = std::size_t(grid.countX);
  inside.offsets.assign((inside.countX + 1) * std::size_t(grid.countY), 0);
  if (grid.count() == 0 || mesh.places.empty()) return inside;
  const GridHits hits = gatherHits(mesh, grid);
  inside.all.resize((std::size_t(hits.rowBegins.back()) + 1) / 2);  // a stretch needs two crossings
  parallelFor(std::size_t(grid.countY), 16, [&](std::size_t begin, std::size_t end) {
    RowSampler sampler(hits, line, grid.countX);
    for (std::size_t row = begin; row < end; ++row) {
      std::uint32_t* const offsets = inside.offsets.data() + row * (inside.countX + 1);
      offsets[0] = std::uint32_t((std::size_t(hits.rowBegins[row]) + 1) / 2);
      sampler.sample(row, offsets, inside.all.data());
    }
  });
  return inside;
}

}  // namespace resect
