#include "tissue/elastic/chunk_bounds.h"

#include <algorithm>
#include <cmath>

namespace resect {
namespace {

constexpr double kRounding =
    1e-9;  // m: positions are computed in another order of summation elsewhere

typedef float Lanes __attribute__((vector_size(16)));
constexpr int kLanes = 4;

Lanes load(const float* p) {
  Lanes v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}

}  // namespace

// Uses the displacements of all sixteen cells: those of missing cells are zero, which can only
// enlarge the bounds.
Aabb chunkBounds(const ElasticState& s, const TissueChunk& chunk, const Vec3& origin) {
  const Vec3i row = s.box.cell(chunk.start);
  Aabb box = {origin + s.spacing * (row + Vec3i(chunk.first, 0, 0)).cast<double>(),
              origin + s.spacing * (row + Vec3i(chunk.last, 0, 0)).cast<double>()};
  for (int a = 0; a < 3; ++a) {
    const float* u = s.u[a].data() + chunk.start;
    Lanes low = load(u), high = low;
    for (int k = kLanes; k < kChunk; k += kLanes) {
      const Lanes next = load(u + k);
      low = next < low ? next : low;
      high = next > high ? next : high;
    }
    box.min[a] += std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
    box.max[a] += std::max(std::max(high[0], high[1]), std::max(high[2], high[3]));
  }
  return box.padded(kRounding);
}

double chunkSpeed(const ElasticState& s, const TissueChunk& chunk) {
  Lanes most{};
  for (int k = 0; k < kChunk; k += kLanes) {
    Lanes sum{};
    for (int a = 0; a < 3; ++a) {
      const Lanes v = load(s.v[a].data() + chunk.start + k);
      sum += v * v;
    }
    most = sum > most ? sum : most;
  }
  constexpr double kRoundedUp = 1 + 1e-6;
  return kRoundedUp *
         std::sqrt(double(std::max(std::max(most[0], most[1]), std::max(most[2], most[3]))));
}

}  // namespace resect
