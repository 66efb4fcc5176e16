#include "tissue/elastic/contact/cut_faces.h"

#include <algorithm>
#include <cmath>

namespace resect {
namespace {

Vec3 vectorAt(const std::array<FloatArray, 3>& field, std::int32_t i) {
  return {field[0][i], field[1][i], field[2][i]};
}

}  // namespace

void CutFaces::keepApart(const ElasticState& s, std::int32_t cell, int direction) {
  const std::int32_t other = cell + s.box.step[direction];
  const Vec3 rest = s.spacing * offsetOf(direction).cast<double>();
  const double now = (rest + vectorAt(s.u, other) - vectorAt(s.u, cell)).norm();
  cut_.push_back({cell, other, float(std::min(now, 0.9 * rest.norm())), rest.cast<float>()});
}

void CutFaces::forgetCell(std::int32_t cell) {
  std::erase_if(cut_, [&](const CutPair& pair) { return pair.a == cell || pair.b == cell; });
}

void CutFaces::push(ElasticState& s, double lookAhead) const {
  constexpr float kShare = 0.2f;  // of the missing distance, per substep
  for (const CutPair& pair : cut_) {
    const auto [a, b] = std::pair(pair.a, pair.b);
    Vec3f along = pair.rest, speed;
    for (int k = 0; k < 3; ++k) {
      along[k] += s.u[k][b] - s.u[k][a];
      speed[k] = s.v[k][b] - s.v[k][a];
    }
    const float length2 = along.squaredNorm();
    if (length2 >= pair.distance * pair.distance || length2 < 1e-20f) continue;
    const float length = std::sqrt(length2);
    along /= length;
    const float into = std::max(0.0f, -speed.dot(along));
    const float way = kShare * (pair.distance - length);
    const float sum = s.inverseMass[a] + s.inverseMass[b];
    for (const auto& [cell, sign] : {std::pair(a, -1.0f), std::pair(b, 1.0f)}) {
      const float share = sign * s.inverseMass[cell] / sum;
      for (int k = 0; k < 3; ++k) {
        if (s.held[cell] >> k & 1) continue;
        s.u[k][cell] += share * way * along[k];
        s.v[k][cell] += share * into * along[k];
        s.ahead[k][cell] = s.u[k][cell] + float(lookAhead) * s.v[k][cell];
      }
    }
  }
}

bool CutFaces::fit(std::int32_t cells) const {
  return std::ranges::all_of(cut_, [&](const CutPair& pair) {
    return std::min(pair.a, pair.b) >= 0 && std::max(pair.a, pair.b) < cells;
  });
}

}  // namespace resect
