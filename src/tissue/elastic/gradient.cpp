#include "tissue/elastic/gradient.h"

#include <algorithm>

namespace resect {

std::array<double, 4> edgeWeights() {
  std::array<double, 4> weights = bondWeights();
  for (const double edge = weights[2]; double& weight : weights) weight /= edge;
  return weights;
}

Mat3 inverseMomentAt(const ElasticState& s, std::int32_t i) {
  const auto& l = s.inverseMoment;
  Mat3 inverse;
  inverse << l[0][i], l[3][i], l[4][i], l[3][i], l[1][i], l[5][i], l[4][i], l[5][i], l[2][i];
  return inverse;
}

Mat3 gradientAt(const ElasticState& s, std::int32_t i) {
  const std::array<double, 4> weights = edgeWeights();
  const auto at = [&](std::int32_t j) { return Vec3(s.u[0][j], s.u[1][j], s.u[2][j]); };
  Mat3 sum = Mat3::Zero();
  for (int d = 0; d < kDirections; ++d)
    if (s.bonds[i] >> d & 1)
      sum += weights[neighbourKind(d)] * (at(i + s.box.step[d]) - at(i)) *
             offsetOf(d).cast<double>().transpose();
  return sum * inverseMomentAt(s, i);
}

ChunkGradients::ChunkGradients(const ElasticState& state, const ElasticKernel& kernel)
    : kernel_(kernel), view_(viewOf(const_cast<ElasticState&>(state))) {  // only read
  std::ranges::copy(edgeWeights(), weight_);
}

Mat3 ChunkGradients::at(std::int32_t cell) {
  const std::int32_t start = cell / kChunk * kChunk;
  if (start != start_) kernel_.placements(view_, weight_, start, 0xffff, found_);
  start_ = start;
  Mat3 h;
  for (int k = 0; k < 9; ++k) h(k / 3, k % 3) = double(found_[3 + k][cell - start]);
  return h;
}

Mat3 cofactors(const Mat3& f) {
  Mat3 c;
  c.row(0) = f.row(1).cross(f.row(2));
  c.row(1) = f.row(2).cross(f.row(0));
  c.row(2) = f.row(0).cross(f.row(1));
  return c;
}

}  // namespace resect
