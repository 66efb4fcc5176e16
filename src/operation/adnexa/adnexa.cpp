#include "operation/adnexa/adnexa.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/normals.h"
#include "tissue/stencil.h"

namespace resect {
namespace {

// An anchor is carried by so many particles, the nearest ones. The weight of a particle falls with
// the square of its distance, and would be 0 at kWide times that of the farthest.
constexpr std::size_t kHolders = 12;
constexpr double kWide = 1.3;
// An edge that has become longer than this was torn or cut.
constexpr float kStretches = 2.2f, kAlways = 1e-3f;  // times at rest, plus m

// Beside tissue that was removed the fold of the ligament slopes down, over so many anchors. Beside
// a cut it shrinks a little.
constexpr int kSlopes = 5;
constexpr double kBesideCut = 0.6;  // share of the height

// The bonds along the straight line between two cells.
std::vector<TissueBond> bondsBetween(const Lattice& lattice, std::int64_t from, std::int64_t to) {
  std::vector<TissueBond> bonds;
  const Vec3i start = lattice.cell(from), way = lattice.cell(to) - start;
  const int steps = way.cwiseAbs().maxCoeff();
  Vec3i before = start;
  for (int i = 1; i <= steps; ++i) {
    const Vec3i cell =
        start + (way.cast<double>() * i / steps).array().round().matrix().cast<int>();
    bonds.push_back({lattice.index(before), directionTo(cell - before)});
    before = cell;
  }
  return bonds;
}

// Whether both cells of a bond are tissue, with no bond between them.
bool severed(const OperatedOrgan& operated, const TissueBond& bond) {
  const Lattice& lattice = operated.organ.rest.lattice;
  const std::int64_t other = lattice.index(lattice.cell(bond.cell) + offsetOf(bond.direction));
  return operated.organ.alive[std::size_t(bond.cell)] && operated.organ.alive[std::size_t(other)] &&
         !(operated.tissue->bonds(bond.cell) >> bond.direction & 1);
}

}  // namespace

// Per anchor: how much of the fold's height is left, 0 to 1.
std::vector<double> Adnexa::heights() const {
  std::vector<double> left(motions_.size(), 1);
  const auto rows = std::ptrdiff_t(motions_.size()) - 1;  // the last anchor is the gallbladder's
  const auto lower = [&](std::ptrdiff_t anchor, double height) {
    double& now = left[std::size_t(anchor)];
    now = std::min(now, height);
  };
  for (std::ptrdiff_t i = 0; i < rows; ++i) {
    const Motion& motion = motions_[std::size_t(i)];
    if (motion.cut)
      for (const std::ptrdiff_t beside : {i - 1, i}) lower(beside, kBesideCut);
    if (motion.held) continue;
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, i - kSlopes);
         k <= std::min(rows - 1, i + kSlopes); ++k)
      lower(k, std::sqrt(double(std::abs(k - i)) / (kSlopes + 1)));
  }
  return left;
}

void Adnexa::begin(const OperatedOrgan& operated) {
  const Organ& organ = operated.organ;
  begun_ = true;
  const std::optional<Pose> place = builtinLiverPose(organ.rest);
  if (!place) return;
  place_ = *place;
  shapes_ = liverAdnexa();
  for (Vec3& p : shapes_.mesh.points) rest_.emplace_back((p = place_ * p).cast<float>());
  for (const Vec3& n : pointNormals(shapes_.mesh)) normals_.emplace_back(n.cast<float>());
  const Lattice& lattice = organ.rest.lattice;
  for (Vec3& at : shapes_.anchors) {
    at = place_ * at;
    std::vector<std::pair<double, std::int64_t>> near;  // squared distance, cell
    for (std::int64_t i = 0; i < std::int64_t(organ.rest.inside.size()); ++i)
      if (organ.rest.inside[std::size_t(i)])
        near.emplace_back((lattice.centre(lattice.cell(i)) - at).squaredNorm(), i);
    const std::size_t count = std::min(kHolders, near.size());
    std::partial_sort(near.begin(), near.begin() + std::ptrdiff_t(count), near.end());
    Holder& holder = holders_.emplace_back();
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) {
      holder.particles.push_back(near[k].second);
      holder.weights.push_back(1 - near[k].first / (kWide * near[count - 1].first));
      sum += holder.weights.back();
    }
    for (double& weight : holder.weights) weight /= sum;
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3i cell = lattice.cell(holder.particles[k]);
      TissueBond& bond = holder.bonds.emplace_back();
      for (std::size_t j = 0; j < k && bond.cell < 0; ++j)
        if (const Vec3i step = cell - lattice.cell(holder.particles[j]);
            step.cwiseAbs().maxCoeff() == 1)
          bond = {holder.particles[j], directionTo(step)};
    }
    // The last anchor is not of the ligament.
    if (holders_.size() > 1 && holders_.size() < shapes_.anchors.size())
      holder.before =
          bondsBetween(lattice, holders_[holders_.size() - 2].particles[0], holder.particles[0]);
  }
}

std::vector<Adnexa::Motion> Adnexa::motionsIn(const OperatedOrgan& operated) const {
  constexpr double kLeast = 0.7;  // share of the tissue that has to be left
  const Lattice& lattice = operated.organ.rest.lattice;
  std::vector<Motion> motions;
  for (const Holder& holder : holders_) {
    Motion& motion = motions.emplace_back();
    double sum = 0, left = 0;
    std::vector<bool> beyond(holder.particles.size());  // beyond a cut
    for (std::size_t k = 0; k < holder.particles.size(); ++k) {
      const std::int64_t i = holder.particles[k];
      if (!operated.organ.alive[std::size_t(i)]) continue;
      left += holder.weights[k];
      if (const TissueBond& bond = holder.bonds[k]; bond.cell >= 0) {
        const auto from = std::ranges::find(holder.particles, bond.cell);
        beyond[k] = beyond[std::size_t(from - holder.particles.begin())] || severed(operated, bond);
      }
      if (beyond[k]) continue;
      const Vec3 centre = lattice.centre(lattice.cell(i));
      const Mat3 f = operated.tissue->deformation(i);
      motion.map += holder.weights[k] * f;
      motion.offset += holder.weights[k] * (centre + operated.tissue->displacement(i) - f * centre);
      sum += holder.weights[k];
    }
    motion.held = left >= kLeast && sum > 0;
    if (motion.held) motion.map /= sum, motion.offset /= sum;
    motion.cut = std::ranges::any_of(
        holder.before, [&](const TissueBond& bond) { return severed(operated, bond); });
  }
  return motions;
}

std::shared_ptr<const SurfaceCopy> Adnexa::follow(const Simulation& simulation) {
  if (simulation.organs().size() != 1) return nullptr;
  const OperatedOrgan& operated = simulation.organs()[0];
  if (!begun_) begin(operated);
  if (shapes_.mesh.points.empty()) return nullptr;
  std::vector<Motion> motions = motionsIn(operated);
  if (last_ && motions == motions_) return last_;
  motions_ = std::move(motions);

  auto now = std::make_shared<SurfaceCopy>();
  now->rest = rest_;
  now->cut = shapes_.look;
  const std::vector<double> left = heights();
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const auto number = std::size_t(shapes_.anchor[i]);
    const Motion& motion = motions_[number];
    const Mat3& m = motion.map;
    Vec3 p = shapes_.mesh.points[i];
    if (int(shapes_.look[i]) == int(AdnexaLook::Ligament))
      p = shapes_.anchors[number] + left[number] * (p - shapes_.anchors[number]);
    now->points.emplace_back((m * p + motion.offset).cast<float>());
    // Normals turn by the cofactors of the map, which are its inverse transpose times its volume.
    Mat3 cofactors;
    cofactors << m.col(1).cross(m.col(2)), m.col(2).cross(m.col(0)), m.col(0).cross(m.col(1));
    const Vec3 normal = cofactors * normals_[i].cast<double>();
    now->normals.emplace_back(normal.normalized().cast<float>());
  }
  for (const Triangle& t : shapes_.mesh.triangles) {
    const auto [first, last] =
        std::minmax({shapes_.anchor[std::size_t(t[0])], shapes_.anchor[std::size_t(t[1])],
                     shapes_.anchor[std::size_t(t[2])]});
    bool whole = first == last || !motions_[std::size_t(last)].cut;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = std::size_t(t[k]), b = std::size_t(t[(k + 1) % 3]);
      const float most = kStretches * (rest_[a] - rest_[b]).norm() + kAlways;
      whole = whole && motions_[std::size_t(shapes_.anchor[a])].held &&
              (now->points[a] - now->points[b]).norm() < most;
    }
    now->triangles.push_back(whole ? t : Triangle{0, 0, 0});
  }
  last_ = std::move(now);
  return last_;
}

}  // namespace resect
