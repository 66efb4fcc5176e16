#include "tissue/elastic/cutting/cut_front.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "tissue/elastic/boundary_cells.h"
#include "tissue/elastic/chunk_bounds.h"
#include "tissue/elastic/gradient.h"

namespace resect {
namespace {

// Of a tie: rho s^2 l times this over dt^2 and over dt.
constexpr double kStiffness = 1, kDamping = 0.5;
constexpr double kEdgeReach = 1.5;  // spacings: how far from cells an edge is looked for
constexpr double kHalfStep = 0.525, kOutOfTissue = 2;  // steps
constexpr double kLongestBeyond = 1.5;                 // steps at rest

// Corners of a polyline at equal distances.
struct Along {
  Vec3 point, tangent;
};
Along alongEdge(std::span<const Vec3> points, double way) {
  Along at{points[0], Vec3::UnitX()};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec3 piece = points[i + 1] - points[i];
    const double length = piece.norm();
    if (!(length > 0)) continue;
    at.tangent = piece / length;
    at.point = points[i] + std::min(way, length) * at.tangent;
    if (way <= length) break;
    way -= length;
  }
  return at;
}

double lengthOf(std::span<const Vec3> points) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) length += (points[i + 1] - points[i]).norm();
  return length;
}

// The inverse of the deformation gradient. By that of a cell that is crushed nearly flat, a cut
// would reach far through the tissue at rest; such a cell counts as compressed to a third.
Mat3 toRestBy(const Mat3& f) {
  constexpr double kLeastVolume = 0.05, kLargest = 3.2;  // the latter: Frobenius norm
  if (!(f.determinant() > kLeastVolume)) return Mat3::Identity();
  const Mat3 inverse = f.inverse();
  return std::min(1.0, kLargest / inverse.norm()) * inverse;
}

}  // namespace

CutFronts::Edge& CutFronts::edgeOf(std::size_t number) {
  if (edges_.size() <= number) edges_.resize(number + 1);
  return edges_[number];
}

// Cells that the edge may come near in the frame.
void CutFronts::findCandidates(const RestTissue& rest, const CuttingEdge& edge) {
  const ElasticState& s = rest.state();
  const Lattice& lattice = rest.lattice();
  candidates_.clear();
  Aabb box;
  for (const Vec3& p : edge.points) box.grow(edge.from * p), box.grow(edge.to * p);
  box = box.padded(kEdgeReach * s.spacing);
  for (const TissueChunk& chunk : s.chunks) {
    if (!meets(chunkBounds(s, chunk, lattice.origin), box)) continue;
    for (std::int32_t i = chunk.start + chunk.first; i <= chunk.start + chunk.last; ++i) {
      if (!isParticle(s, i)) continue;
      const Vec3 x = lattice.centre(s.box.cell(i)) + Vec3(s.u[0][i], s.u[1][i], s.u[2][i]);
      if (box.contains(x)) candidates_.push_back({i, x});
    }
  }
}

void CutFronts::list(const RestTissue& rest, double duration, double dt,
                     std::span<const Obstacle> obstacles) {
  const ElasticState& s = rest.state();
  duration_ = duration;
  work_ = {};
  impulse_.assign(obstacles.size(), Vec3::Zero());
  stiffness_ = kStiffness * s.spacing * s.spacing / (dt * dt);
  damping_ = kDamping * s.spacing * s.spacing / dt;

  std::vector<CutFront> fronts;  // those with tissue near, in the order of the obstacles
  for (std::size_t b = 0; b < obstacles.size(); ++b)
    for (std::size_t e = 0; e < obstacles[b].edges.size(); ++e) {
      const CuttingEdge& edge = obstacles[b].edges[e];
      findCandidates(rest, edge);
      if (candidates_.empty()) continue;
      const double length = lengthOf(edge.points);
      const int count = std::max(1, int(std::ceil(length / (0.5 * s.spacing))));
      Edge& here = edgeOf(fronts.size());
      here.edge = edge;
      here.obstacle = b;
      here.step = length / count;
      here.samples.resize(std::size_t(count));
      const auto same = std::ranges::find_if(fronts_, [&](const CutFront& f) {
        return f.tool == obstacles[b].tool && f.edge == std::int32_t(e);
      });
      CutFront& front = fronts.emplace_back();
      if (same != fronts_.end()) front = std::move(*same);
      front.tool = obstacles[b].tool;
      front.edge = std::int32_t(e);
      front.samples.resize(std::size_t(count));
      for (std::size_t k = 0; k < front.samples.size(); ++k) {
        const Along at = alongEdge(edge.points, (double(k) + 0.5) * here.step);
        CutSample& sample = front.samples[k];
        Sample now;
        now.point = at.point;
        now.tangent = at.tangent;
        now.outwards = at.tangent.cross(edge.normal);
        const Vec3 from = edge.from * at.point;
        const bool there =
            sample.known && (sample.tied || sample.cutting || rest.inside(sample.place));
        if (!there)
          locate(rest, from, kEdgeReach * s.spacing + (edge.to * at.point - from).norm(), sample,
                 now);
        if (sample.known) rest.findCells(sample.place, now.cells);
        if (now.cells.nearest < 0) sample.known = sample.tied = false;
        sample.cutting = sample.cutting && there && sample.known;
        now.swept = now.inside = sample.cutting;
        if (sample.known) {
          const Mat3 f = now.cells.gradient + Mat3::Identity();
          now.toRest = toRestBy(f);
        }
        now.cellsAt = sample.place;
        now.askedAt = now.lengthAt = Vec3::Constant(1e9);
        now.start = sample.place;
        here.samples[k] = std::move(now);
      }
    }
  fronts_ = std::move(fronts);
  kept_ = fronts_;
}

// The point of the tissue where the edge is: by the cell that is nearest now.
void CutFronts::locate(const RestTissue& rest, const Vec3& point, double reach, CutSample& sample,
                       Sample& now) const {
  const Candidate* nearest = nullptr;
  double least = reach * reach;
  for (const Candidate& c : candidates_)
    if (const double distance2 = (c.place - point).squaredNorm(); distance2 < least) {
      least = distance2;
      nearest = &c;
    }
  sample.known = nearest != nullptr;
  if (!nearest) return;
  const Mat3 f = gradientAt(rest.state(), nearest->cell) + Mat3::Identity();
  now.toRest = toRestBy(f);
  sample.place = rest.lattice().centre(rest.state().box.cell(nearest->cell)) +
                 now.toRest * (point - nearest->place);
}

void CutFronts::push(const RestTissue& rest, ElasticState& s, double share, double dt,
                     double lookAhead) {
  work_.held = 0;
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    Edge& edge = edges_[f];
    const Pose pose = interpolate(edge.edge.from, edge.edge.to, share);
    pullSamples(rest, edge, fronts_[f], pose, dt);
    for (const Sample& sample : edge.samples) {
      if (sample.force == Vec3::Zero()) continue;
      impulse_[edge.obstacle] -= dt * sample.force;
      work_.given += dt * sample.force.dot(sample.motion);
      for (std::size_t c = 0; c < sample.cells.cells.size(); ++c) {
        const std::int32_t i = sample.cells.cells[c];
        const Vec3 change = dt * sample.cells.weights[c] * double(s.inverseMass[i]) * sample.force;
        for (int a = 0; a < 3; ++a) {
          if (s.held[i] >> a & 1) continue;
          s.v[a][i] += float(change[a]);
          s.u[a][i] += float(dt * change[a]);
          s.ahead[a][i] = s.u[a][i] + float(lookAhead) * s.v[a][i];
        }
      }
    }
    for (const Sample& sample : edge.samples)
      if (sample.force != Vec3::Zero())
        work_.taken += dt * sample.force.dot(rest.velocity(sample.cells));
  }
}

void CutFronts::appendCuts(std::vector<TissueCut>& cuts) const {
  std::vector<Vec3> before, after;
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    const Edge& edge = edges_[f];
    const std::vector<CutSample>& samples = fronts_[f].samples;
    const auto joined = [&](std::size_t k) {  // whether sample k sweeps on with sample k + 1
      if (k + 1 >= samples.size() || !edge.samples[k].swept || !edge.samples[k + 1].swept)
        return false;
      const double most = kStretchedSteps * edge.step;
      return (edge.samples[k + 1].start - edge.samples[k].start).norm() < most &&
             (samples[k + 1].place - samples[k].place).norm() < most;
    };
    TissueCut cut;
    cut.tool = fronts_[f].tool;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const Sample& now = edge.samples[k];
      if (!now.swept) continue;
      Vec3 along = edge.step * (now.toRest * (edge.edge.to.rotation * now.tangent));
      along *= std::min(1.0, kLongestBeyond * edge.step / along.norm());
      // Beyond the last sample: half a step, and where the edge leaves the tissue, out of it.
      const auto beyond = [&](std::size_t other) {
        const bool leaves = other < samples.size() && !(edge.samples[other].length > 0);
        return Vec3((leaves ? kOutOfTissue : kHalfStep) * along);
      };
      if (k == 0 || !joined(k - 1))
        before = {now.start - beyond(k - 1)}, after = {samples[k].place - beyond(k - 1)};
      before.push_back(now.start), after.push_back(samples[k].place);
      if (joined(k)) continue;
      before.push_back(now.start + beyond(k + 1)),
          after.push_back(samples[k].place + beyond(k + 1));
      if (edge.edge.reversed) std::ranges::reverse(before), std::ranges::reverse(after);
      append(cut.blade, ruledBlade(before, after));
    }
    if (!cut.blade.empty()) cuts.push_back(std::move(cut));
  }
}

void CutFronts::startAgain(const RestTissue& rest) {
  fronts_ = kept_;
  work_ = {};
  std::ranges::fill(impulse_, Vec3::Zero());
  for (std::size_t f = 0; f < fronts_.size(); ++f)
    for (std::size_t k = 0; k < fronts_[f].samples.size(); ++k) {
      Sample& now = edges_[f].samples[k];
      now.swept = now.inside = fronts_[f].samples[k].cutting;
      now.spent = false;
      now.start = now.cellsAt = fronts_[f].samples[k].place;
      now.cells.nearest = -1;
      if (fronts_[f].samples[k].known) rest.findCells(now.start, now.cells);
      now.askedAt = now.lengthAt = Vec3::Constant(1e9);
    }
}

bool CutFronts::fit() const {
  return std::ranges::all_of(fronts_, [](const CutFront& front) {
    return std::ranges::all_of(front.samples, [](const CutSample& sample) {
      return sample.place.allFinite() && sample.motion.allFinite() && std::isfinite(sample.lean);
    });
  });
}

}  // namespace resect
