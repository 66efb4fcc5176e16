#include "tissue/threads.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace resect {
namespace {

Vec3f along(const TissueThread& thread, const std::array<FloatArray, 3>& u) {
  Vec3f x = thread.rest;
  for (int k = 0; k < 3; ++k) x[k] += u[k][thread.b] - u[k][thread.a];
  return x;
}

}  // namespace

std::vector<TissueThread> findThreads(const ElasticState& s, std::span<const TissueThread> before) {
  const auto earlier = [](const TissueThread& x, const TissueThread& y) {
    return std::pair(x.a, x.b) < std::pair(y.a, y.b);
  };
  std::vector<TissueThread> threads;
  for (const TissueChunk& chunk : s.chunks) {
    if (!chunk.uneven) continue;
    for (std::int32_t i = chunk.start; i < chunk.start + kChunk; ++i) {
      if (!s.solid[i] || s.kappa[i] > 0) continue;
      for (int d = kFirstForward; d < kDirections; ++d) {
        const std::int32_t j = i + s.box.step[d];
        if (!(s.bonds[i] >> d & 1) || s.kappa[j] > 0) continue;
        const double young =
            0.5 * (s.materials[s.material[i]].young + s.materials[s.material[j]].young);
        TissueThread thread{i, j, kThreadShare[neighbourKind(d)] * float(young * s.spacing),
                            (s.spacing * offsetOf(d).cast<double>()).cast<float>(), 0};
        thread.length = along(thread, s.u).norm();
        const auto known = std::lower_bound(before.begin(), before.end(), thread, earlier);
        if (known != before.end() && known->a == i && known->b == j) thread = *known;
        threads.push_back(thread);
      }
    }
  }
  return threads;
}

void pullThreads(std::span<const TissueThread> threads, ElasticState& s) {
  for (const TissueThread& thread : threads) {
    const Vec3f x = along(thread, s.ahead);
    const float length = x.norm();
    if (!(length > 1e-12f)) continue;
    const Vec3f force = thread.stiffness * (1 - thread.length / length) * x;  // on a
    for (int k = 0; k < 3; ++k) {
      s.bondForce[k][thread.a] += force[k];
      s.bondForce[k][thread.b] -= force[k];
    }
  }
}

double threadEnergy(std::span<const TissueThread> threads, const ElasticState& s) {
  double sum = 0;
  for (const TissueThread& thread : threads) {
    const double stretch = double(along(thread, s.u).norm()) - thread.length;
    sum += 0.5 * thread.stiffness * stretch * stretch;
  }
  return sum;
}

}  // namespace resect
