#include "tissue/elastic/fibres.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace resect {
namespace {

Vec3f along(const Fibre& fibre, const std::array<FloatArray, 3>& u) {
  Vec3f x = fibre.rest;
  for (int k = 0; k < 3; ++k) x[k] += u[k][fibre.b] - u[k][fibre.a];
  return x;
}

// slack: up to this length, m, there is no force.
void pull(const Fibre& fibre, ElasticState& s, float slack) {
  const Vec3f x = along(fibre, s.ahead);
  const float length = x.norm();
  if (!(length > std::max(slack, 1e-12f))) return;
  const Vec3f force = fibre.stiffness * (1 - fibre.length / length) * x;  // on a
  for (int k = 0; k < 3; ++k) {
    s.bondForce[k][fibre.a] += force[k];
    s.bondForce[k][fibre.b] -= force[k];
  }
}

}  // namespace

std::vector<Fibre> findFibres(const ElasticState& s, std::span<const Fibre> before) {
  const auto earlier = [](const Fibre& x, const Fibre& y) {
    return std::pair(x.a, x.b) < std::pair(y.a, y.b);
  };
  std::vector<Fibre> fibres;
  for (const TissueChunk& chunk : s.chunks) {
    if (!chunk.uneven) continue;
    for (std::int32_t i = chunk.start; i < chunk.start + kChunk; ++i) {
      if (!s.solid[i] || s.kappa[i] > 0) continue;
      for (int d = kFirstForward; d < kDirections; ++d) {
        const std::int32_t j = i + s.box.step[d];
        if (!(s.bonds[i] >> d & 1) || s.kappa[j] > 0) continue;
        const double young =
            0.5 * (s.materials[s.material[i]].young + s.materials[s.material[j]].young);
        Fibre fibre{i, j, kFibreShare[neighbourKind(d)] * float(young * s.spacing),
                    (s.spacing * offsetOf(d).cast<double>()).cast<float>(), 0};
        fibre.length = along(fibre, s.u).norm();
        const auto known = std::lower_bound(before.begin(), before.end(), fibre, earlier);
        if (known != before.end() && known->a == i && known->b == j) fibre = *known;
        fibres.push_back(fibre);
      }
    }
  }
  return fibres;
}

void pullFibres(std::span<const Fibre> fibres, ElasticState& s) {
  for (const Fibre& fibre : fibres) pull(fibre, s, 0);
}

void pullCords(std::span<const Cord> cords, ElasticState& s) {
  for (const Cord& cord : cords) pull(cord, s, cord.length);
}

double fibreEnergy(std::span<const Fibre> fibres, const ElasticState& s) {
  double sum = 0;
  for (const Fibre& fibre : fibres) {
    const double stretch = double(along(fibre, s.u).norm()) - fibre.length;
    sum += 0.5 * fibre.stiffness * stretch * stretch;
  }
  return sum;
}

double cordEnergy(std::span<const Cord> cords, const ElasticState& s) {
  double sum = 0;
  for (const Cord& cord : cords) {
    const double stretch = std::max(0.0, double(along(cord, s.u).norm()) - cord.length);
    sum += 0.5 * cord.stiffness * stretch * stretch;
  }
  return sum;
}

}  // namespace resect
