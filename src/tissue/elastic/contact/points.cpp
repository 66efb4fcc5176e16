#include "tissue/elastic/contact/points.h"

#include <algorithm>
#include <cmath>

#include "tissue/elastic/boundary_cells.h"

namespace resect {
namespace {

constexpr int kAcross = 4;             // points along each side of a bare face
constexpr float kLeastWeight = 1e-2f;  // less is left out

}  // namespace

void ContactPoints::setSurface(const ElasticState& s, const Lattice& lattice,
                               std::span<const SurfacePatch> patches) {
  told_.clear();
  for (const SurfacePatch& patch : patches) {
    const std::int32_t i = s.box.fromLattice(patch.cell);
    const float area = patch.area.norm();
    if (!s.solid[i] || !(area > 0)) continue;
    const Vec3 centre = lattice.centre(lattice.cell(patch.cell));
    told_.push_back({i, {patch.place - centre.cast<float>(), patch.area / area, area}});
  }
  std::ranges::stable_sort(told_, {}, &Owned::cell);
  first_.assign(std::size_t(s.box.size), kOutside);
  for (std::int32_t i = 0; i < s.box.size; ++i)
    if (isParticle(s, i)) first_[std::size_t(i)] = kInside;
  for (std::size_t k = told_.size(); k-- > 0;) first_[std::size_t(told_[k].cell)] = int(k);
}

std::span<const ContactPoints::Owned> ContactPoints::patchesOf(std::int32_t i) const {
  const std::int32_t first = first_.empty() ? kOutside : first_[std::size_t(i)];
  if (first < 0) return {};
  auto last = std::size_t(first);
  while (last < told_.size() && told_[last].cell == i) ++last;
  return {told_.data() + first, told_.data() + last};
}

void ContactPoints::addFaces(const ElasticState& s, std::int32_t i, int across, bool lips,
                             std::vector<ContactPoint>& points) const {
  const auto side = float(s.spacing);
  const auto place = [&](int k) { return side * ((float(k) + 0.5f) / float(across) - 0.5f); };
  for (int axis = 0; axis < 3; ++axis)
    for (int sign = -1; sign <= 1; sign += 2) {
      const Vec3i towards = sign * Vec3i::Unit(axis);
      const int d = directionTo(towards);
      const std::int32_t other = i + s.box.step[d];
      if (s.bonds[i] >> d & 1 || (s.solid[other] && !lips)) continue;
      if (!first_.empty() && first_[std::size_t(other)] == kOutside)
        continue;  // the organ's surface
      for (int k = 0; k < across * across; ++k) {
        Vec3f offset = 0.5f * side * towards.cast<float>();
        offset[(axis + 1) % 3] = place(k % across);
        offset[(axis + 2) % 3] = place(k / across);
        points.push_back({offset, towards.cast<float>(), side * side / float(across * across)});
      }
    }
}

void ContactPoints::fine(const ElasticState& s, std::int32_t i, bool lips,
                         std::vector<ContactPoint>& points) const {
  for (const Owned& one : patchesOf(i)) points.push_back(one.point);
  if (s.bonds[i] != kAllBonds) addFaces(s, i, kAcross, lips, points);
}

void ContactPoints::coarse(const ElasticState& s, std::int32_t i,
                           std::vector<ContactPoint>& points) const {
  ContactPoint all{Vec3f::Zero(), Vec3f::Zero(), 0};
  for (const auto& [cell, point] : patchesOf(i)) {
    all.offset += point.area * point.offset;
    all.normal += point.area * point.normal;
    all.area += point.area;
  }
  if (const float area = all.normal.norm(); area > 0)
    points.push_back({all.offset / all.area, all.normal / area, area});
  if (s.bonds[i] != kAllBonds) addFaces(s, i, 1, false, points);
}

PointWeights weightsAt(const ElasticState& s, std::int32_t i, const Vec3f& offset) {
  float along[3][3];  // per axis: weights of the cell before, the cell itself, the cell after
  for (int a = 0; a < 3; ++a) {
    const float f = std::clamp(offset[a] / float(s.spacing), -0.5f, 0.5f);
    along[a][0] = 0.5f * (0.5f - f) * (0.5f - f);
    along[a][1] = 0.75f - f * f;
    along[a][2] = 0.5f * (0.5f + f) * (0.5f + f);
  }
  PointWeights at;
  at.cell[0] = i;
  at.weight[0] = along[0][1] * along[1][1] * along[2][1];
  at.count = 1;
  at.mean.setZero();
  float sum = at.weight[0];
  for (int d = 0; d < kDirections; ++d) {
    // A boundary cell holds little tissue: it would give way before the tissue behind it.
    if (!(s.bonds[i] >> d & 1) || s.owner[i + s.box.step[d]]) continue;
    const Vec3i o = offsetOf(d);
    const float weight = along[0][o.x() + 1] * along[1][o.y() + 1] * along[2][o.z() + 1];
    if (weight < kLeastWeight) continue;
    at.cell[std::size_t(at.count)] = i + s.box.step[d];
    at.weight[std::size_t(at.count++)] = weight;
    at.mean += weight * o.cast<float>();
    sum += weight;
  }
  for (int k = 0; k < at.count; ++k) at.weight[std::size_t(k)] /= sum;
  at.mean *= float(s.spacing) / sum;
  return at;
}

}  // namespace resect
