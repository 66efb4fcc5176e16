#include "formats/labels/slice_interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace resect {
namespace {

constexpr double kNowhere = 1e20;  // squared distance where there is nothing

// One line of a squared distance transform, in place (Felzenszwalb and Huttenlocher 2012,
// 10.4086/toc.2012.v008a019). step: between the entries.
class DistanceLine {
 public:
  void transform(std::vector<double>& line, double step) {
    const int n = int(line.size());
    at_.resize(line.size());
    from_.resize(line.size() + 1);
    int last = -1;  // of the parabolas of the lower envelope
    for (int i = 0; i < n; ++i) {
      if (line[std::size_t(i)] >= kNowhere) continue;
      double begin = -std::numeric_limits<double>::infinity();
      while (last >= 0) {
        begin = meet(line, at_[std::size_t(last)], i, step);
        if (begin > from_[std::size_t(last)]) break;
        --last;
      }
      ++last;
      at_[std::size_t(last)] = i;
      from_[std::size_t(last)] = last == 0 ? -std::numeric_limits<double>::infinity() : begin;
    }
    if (last < 0) return;
    result_.resize(line.size());
    for (int i = 0, k = 0; i < n; ++i) {
      while (k < last && from_[std::size_t(k) + 1] <= i) ++k;
      const double away = step * (i - at_[std::size_t(k)]);
      result_[std::size_t(i)] = away * away + line[std::size_t(at_[std::size_t(k)])];
    }
    std::swap(line, result_);
  }

 private:
  // Where the parabolas that begin at entries a < b are equal, in entries.
  static double meet(const std::vector<double>& line, int a, int b, double step) {
    const double rise = (line[std::size_t(b)] - line[std::size_t(a)]) / (step * step);
    return (rise + double(b) * b - double(a) * a) / (2.0 * (b - a));
  }

  std::vector<int> at_;
  std::vector<double> from_, result_;
};

// The mask's slices across `axis`.
struct Slices {
  const Mask& mask;
  int axis, u, v;  // the other two axes, in order

  Slices(const Mask& m, int across)
      : mask(m), axis(across), u(across == 0), v(across == 2 ? 1 : 2) {}

  std::size_t width() const { return std::size_t(mask.dims[u]); }
  std::size_t height() const { return std::size_t(mask.dims[v]); }
  std::size_t index(const Mask& of, std::size_t i, std::size_t j, int slice) const {
    Vec3i at;
    at[u] = int(i), at[v] = int(j), at[axis] = slice;
    return of.index(at.x(), at.y(), at.z());
  }

  // Distances from all voxels of a slice to the nearest one that is inside, or is not.
  std::vector<double> away(int slice, bool inside, const Vec3& spacing, DistanceLine& line) const {
    std::vector<double> squared(width() * height()), values;
    for (std::size_t j = 0; j < height(); ++j)
      for (std::size_t i = 0; i < width(); ++i)
        squared[j * width() + i] =
            (mask.inside[index(mask, i, j, slice)] != 0) == inside ? 0 : kNowhere;
    for (std::size_t j = 0; j < height(); ++j) {
      values.assign(squared.begin() + std::ptrdiff_t(j * width()),
                    squared.begin() + std::ptrdiff_t((j + 1) * width()));
      line.transform(values, spacing[u]);
      std::ranges::copy(values, squared.begin() + std::ptrdiff_t(j * width()));
    }
    values.resize(height());
    for (std::size_t i = 0; i < width(); ++i) {
      for (std::size_t j = 0; j < height(); ++j) values[j] = squared[j * width() + i];
      line.transform(values, spacing[v]);
      for (std::size_t j = 0; j < height(); ++j) squared[j * width() + i] = std::sqrt(values[j]);
    }
    return squared;
  }
};

// How deep the voxels of a slice lie inside, negative outside. `any`: whether one is inside; if
// not, all depths are 0.
struct Depths {
  std::vector<double> depth;
  bool any = false;
};

Depths depthsOf(const Slices& slices, int slice, const Vec3& spacing, DistanceLine& line) {
  Depths result;
  result.depth = slices.away(slice, false, spacing, line);  // outside is everywhere: at the border
  result.any = std::ranges::any_of(result.depth, [](double d) { return d > 0; });
  if (!result.any) return result;
  const std::vector<double> outside = slices.away(slice, true, spacing, line);
  const double half = 0.5 * std::min(spacing[slices.u], spacing[slices.v]);
  for (std::size_t i = 0; i < outside.size(); ++i)
    result.depth[i] = outside[i] > 0 ? half - outside[i] : result.depth[i] - half;
  return result;
}

// Depths in an empty slice beside `last`: in the middle of `last` as far below zero as they are
// above it there.
Depths beyond(const Depths& last) {
  Depths result = last;
  const double most = *std::ranges::max_element(last.depth);
  for (double& d : result.depth) d -= 2 * most;
  return result;
}

}  // namespace

Mask withThinSlices(const Mask& mask, const Vec3& spacing, int axis, int parts) {
  Mask thin;
  thin.dims = mask.dims;
  thin.dims[axis] *= parts;
  thin.inside.assign(mask.inside.size() * std::size_t(parts), 0);
  const Slices slices(mask, axis);
  DistanceLine line;
  Depths below = depthsOf(slices, 0, spacing, line);
  for (int k = 0; k + 1 < mask.dims[axis]; ++k) {
    Depths above = depthsOf(slices, k + 1, spacing, line);
    if (below.any || above.any) {
      const Depths low = below.any ? below : beyond(above),
                   high = above.any ? above : beyond(below);
      for (int part = 0; part < parts; ++part) {
        // A part's middle lies at (slice + 1/2) / parts - 1/2: here are those from k to k + 1.
        const int slice = k * parts + parts / 2 + part;
        const double t = (slice + 0.5) / parts - 0.5 - k;
        for (std::size_t j = 0; j < slices.height(); ++j)
          for (std::size_t i = 0; i < slices.width(); ++i) {
            const std::size_t at = j * slices.width() + i;
            if ((1 - t) * low.depth[at] + t * high.depth[at] > 0)
              thin.inside[slices.index(thin, i, j, slice)] = 1;
          }
      }
    }
    below = std::move(above);
  }
  return thin;
}

}  // namespace resect
