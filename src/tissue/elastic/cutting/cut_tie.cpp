// The tie of a sample of an edge to the tissue, in a substep: when it begins and ends, and how it
// moves on through the tissue.
#include <algorithm>
#include <cmath>

#include "tissue/elastic/cutting/cut_front.h"

namespace resect {
namespace {

constexpr double kHandTime = 0.03;     // s
constexpr double kLeastLean = 0.05;    // slicing makes cuts easier, but not beyond this
constexpr double kStandsStill = 1e-5;  // m/s: below it the hand has no direction
constexpr double kMostSlip = 0.25;     // spacings per substep
constexpr double kLookAhead = 1.2;     // spacings: a tie needs a bond so near ahead
constexpr std::size_t kBeside = 3;     // samples: so far an edge lags as a tied neighbour does
constexpr double kFound = 1;           // spacings: a place farther from the edge is not the edge's
constexpr double kMostJump = 1;        // spacings: farther an edge is not taken to have cut
constexpr double kOpen = 0.002;        // m: half of the gap of a cut that is open
constexpr double kCapsuleDepth = 0.002;  // m: over which the capsule's energy is spread

// The tied sample nearest to sample k, at most kBeside samples away; the number of samples if there
// is none.
std::size_t tiedNear(const CutFront& front, std::size_t k) {
  const std::size_t count = front.samples.size();
  for (std::size_t off = 1; off <= kBeside; ++off) {
    if (k >= off && front.samples[k - off].tied) return k - off;
    if (k + off < count && front.samples[k + off].tied) return k + off;
  }
  return count;
}

Vec3 withoutPart(const Vec3& v, const Vec3& unit) { return v - v.dot(unit) * unit; }

}  // namespace

// One sample in one substep.
struct CutFronts::Pull {
  const RestTissue& rest;
  Edge& edge;
  CutFront& front;
  std::size_t k;
  const Pose& pose;  // of the edge
  CutSample& sample = front.samples[k];
  Sample& now = edge.samples[k];
  double spacing = rest.state().spacing;
  Vec3 hand = pose * now.point;                    // where the hand has the sample, world, m
  Vec3 motion = Vec3::Zero();                      // of the hand at the sample, m/s
  Vec3 outwards = pose.rotation * now.outwards;    // the direction of the cut
  Vec3 normal = pose.rotation * edge.edge.normal;  // of the blade
  Vec3 inPlane = Vec3::Zero();                     // smoothed motion in the blade's plane, m/s
  bool sideways = false;  // an edge that moves sideways slips past tissue and cuts nothing

  // Finds the cells round the tie anew when it has moved.
  void follow() {
    if ((sample.place - now.cellsAt).norm() < spacing / 16) return;
    rest.findCells(sample.place, now.cells);
    now.cellsAt = sample.place;
  }
  bool lost() const { return now.cells.nearest < 0; }  // no tissue is near
  Vec3 offset() const { return hand - sample.place - rest.displacement(sample.place, now.cells); }
  void measureLength();
  void measureToughness();
  void look();
};

// How much edge in tissue the sample stands for.
void CutFronts::Pull::measureLength() {
  const Vec3& place = sample.place;
  constexpr int kParts = 4;
  now.length = 0;
  for (int side = -1; side <= 1; side += 2) {
    const std::size_t other = k + std::size_t(side);  // beyond the last one where there is none
    Vec3 way = side * edge.step * (now.toRest * (edge.edge.to.rotation * now.tangent));
    if (other < front.samples.size() && front.samples[other].known) {
      const Vec3 to = front.samples[other].place - place;
      if (to.norm() < kStretchedSteps * edge.step) way = to;
    }
    for (int part = 0; part < kParts; ++part)
      if (rest.inside(place + (part + 0.5) / (2 * kParts) * way))
        now.length += way.norm() / (2 * kParts);
  }
}

void CutFronts::Pull::measureToughness() {
  const ElasticState& state = rest.state();
  const TissueMaterial& m = state.materials[state.material[now.cells.nearest]];
  const double depth = rest.depth(sample.place);
  now.toughness = m.cutEnergy;
  if (depth > 0 && depth < kCapsuleDepth) now.toughness += m.capsuleCutEnergy / kCapsuleDepth;
  now.toughness *= edge.edge.bluntness;
}

// What the tissue at the tie is, and whether there is any ahead; anew when the tie has moved.
void CutFronts::Pull::look() {
  const Vec3& place = sample.place;
  if ((place - now.lengthAt).norm() > spacing / 32) {
    now.lengthAt = place;
    measureLength();
    measureToughness();
  }
  if (!(now.length > 0)) {
    now.ahead = false;
  } else if ((place - now.askedAt).norm() > spacing / 8) {
    now.askedAt = place;
    const Vec3 along = (now.toRest * (edge.edge.to.rotation * now.tangent)).normalized();
    const Vec3 ahead = (now.toRest * (edge.edge.to.rotation * now.outwards)).normalized();
    now.ahead = rest.tissueAhead(place, along, kLookAhead * spacing * ahead);
  }
}

// Takes a sample that nothing holds along with the edge. Returns whether tissue holds it from now
// on.
bool CutFronts::tie(Pull& pull) {
  CutSample& sample = pull.sample;
  Sample& now = pull.now;
  const bool wasInside = now.inside;
  const Vec3 before = sample.place;
  // Beside a sample that lags, the edge lags as it does.
  const std::size_t other = tiedNear(pull.front, pull.k);
  bool found = true;
  if (other < pull.front.samples.size()) {
    const Sample& beside = pull.edge.samples[other];
    sample.place =
        pull.front.samples[other].place + beside.toRest * (pull.hand - pull.pose * beside.point);
    pull.follow();
  } else {
    for (int step = 0; step < 2 && !pull.lost(); ++step) {
      sample.place += now.toRest * pull.offset();
      pull.follow();
    }
    // In crushed or torn tissue the place may be elsewhere; there the edge cuts nothing.
    found = !pull.lost() && pull.offset().norm() < kFound * pull.spacing;
  }
  if (!found || pull.lost()) {
    sample.known = now.swept = now.inside = false;
    return false;
  }
  if ((sample.place - before).norm() > kMostJump * pull.spacing) now.swept = false;
  pull.look();
  // Where nothing holds the edge, it cuts what it passes, unless it moves back or sideways.
  const bool back = pull.inPlane.dot(pull.outwards) < -0.5 * pull.inPlane.norm();
  const bool open = pull.rest.apart(sample.place, now.cells) > kOpen;
  const bool begins = pull.edge.edge.begins;
  // In an open cut no other one begins. (Skin that is about to be cut may be apart, too.)
  const bool idle = open && !now.ahead && !now.swept;
  if (!wasInside || pull.sideways || back || idle || !begins) now.swept = false;
  if (!now.swept) now.start = sample.place;
  now.swept = now.inside = now.length > 0;
  sample.tied = now.ahead && !now.spent && !open && !pull.sideways && begins;
  return sample.tied;
}

void CutFronts::letGo(Pull& pull) {
  pull.sample.tied = false;
  pull.now.spent = true;
}

// Pulls the tissue with the tie. What would pull harder than the cut takes moves the tie on.
void CutFronts::pullTie(Pull& pull) {
  CutSample& sample = pull.sample;
  Sample& now = pull.now;
  if (!now.swept) now.start = sample.place, now.swept = true;
  now.inside = true;
  pull.look();
  const ElasticState& state = pull.rest.state();
  const double density = state.materials[state.material[now.cells.nearest]].density;
  const double stiffness = stiffness_ * density * pull.edge.step,
               damping = damping_ * density * pull.edge.step;
  const Vec3 slow = pull.motion - pull.rest.velocity(now.cells);
  Vec3 way = pull.offset();
  const Vec3 across = way.dot(pull.normal) * pull.normal;
  way -= across;
  Vec3 force = stiffness * way + damping * withoutPart(slow, pull.normal);
  if (force.dot(pull.outwards) <= 0 && way.dot(pull.outwards) <= 0) return letGo(pull);
  const double full = now.toughness * now.length, most = full * sample.lean;
  if (force.dot(pull.outwards) <= 0) force.setZero();
  if (force.norm() > most) {
    force *= most / force.norm();
    Vec3 slip = way - force / stiffness;
    if (slip.dot(force.norm() > 0 ? force : way) > 0) {
      slip = now.toRest * slip;
      if (slip.norm() > kMostSlip * pull.spacing) slip *= kMostSlip * pull.spacing / slip.norm();
      sample.place += slip;
      if (pull.sideways) now.start += slip;
      const Vec3 forth = now.toRest * pull.outwards;
      const double area =
          pull.sideways ? 0 : now.length * std::max(0.0, slip.dot(forth) / forth.norm());
      work_.area += area;
      work_.cut += now.toughness * area;
      pull.follow();
      way = withoutPart(pull.offset(), pull.normal);
    }
  }
  // The flat of the blade holds the tissue too; what is pushed too hard slips past it uncut.
  Vec3 flat = stiffness * across + damping * slow.dot(pull.normal) * pull.normal;
  if (flat.norm() > full) {
    flat *= full / flat.norm();
    const Vec3 slip = now.toRest * (across - flat / stiffness);
    if (across.dot(flat) > 0 && slip.norm() < pull.spacing) sample.place += slip, now.start += slip;
    pull.follow();
  }
  pull.look();
  if (!now.ahead) return letGo(pull);
  now.force = force + flat;
  now.motion = pull.motion;
  work_.held += 0.5 * stiffness * way.squaredNorm();
}

void CutFronts::pullSamples(const RestTissue& rest, Edge& edge, CutFront& front, const Pose& pose,
                            double dt) {
  for (std::size_t k = 0; k < edge.samples.size(); ++k) {
    edge.samples[k].force.setZero();
    CutSample& sample = front.samples[k];
    if (!sample.known) continue;
    Pull pull{rest, edge, front, k, pose};
    const Vec3& point = pull.now.point;
    pull.motion = (edge.edge.to * point - edge.edge.from * point) / duration_;
    sample.motion += std::min(1.0, dt / kHandTime) * (pull.motion - sample.motion);
    pull.inPlane = withoutPart(sample.motion, pull.normal);
    const double forth = pull.inPlane.dot(pull.outwards);
    if (pull.inPlane.norm() > kStandsStill && forth > 0)
      sample.lean = std::max(kLeastLean, forth / pull.inPlane.norm());
    pull.sideways = std::abs(sample.motion.dot(pull.normal)) > pull.inPlane.norm();
    if (sample.tied || tie(pull)) pullTie(pull);
    sample.cutting = pull.now.swept;
  }
}

}  // namespace resect
