#include "tissue/elastic/contact/contact.h"

#include <algorithm>
#include <cmath>

#include "geometry/rotation.h"
#include "tissue/elastic/contact/dent.h"
#include "tissue/elastic/gradient.h"

namespace resect {
namespace {

// Compliance of dents that the lattice does not resolve, in spacings over E / (1 - nu^2).
constexpr double kFineDents = 0.6;
constexpr double kMargin = 0.25;       // WayOut::margin for instruments, spacings
constexpr double kTwiceAsStiff = 0.6;  // depth at which a point's spring is, spacings
constexpr double kDeepest = 1;         // spacings; deeper the spring's force does not grow
constexpr double kFarthest = 4;        // spacings: the way out of an obstacle, at most
// WayOut::leastSlope; the walls of the tray are thin, and tissue must not stay in them.
constexpr double kEdgeOn = 0.2, kNeverEdgeOn = -1;
// Cosine of the angle between a point's own normal and the mean one: above kAlike the own normal is
// used, below kApart the mean.
constexpr double kAlike = 0.99, kApart = 0.94;
constexpr double kDamping = 0.4;  // of a point, as a share of the impedance of tissue
// Spacings: how much nearer than by its speed tissue may come in a frame.
constexpr double kCentreReach = 0.3, kPointReach = 0.5 + 2 * kMargin;
// Spacings per substep: limits the speed of cells when a tool jumps.
constexpr double kMostPush = 0.25;
// Blades and hooks: distance that they keep from the centres of cells, in spacings.
constexpr double kEnteringStandOff = 0.1;
// Other instruments: how deep, in spacings, centres of cells may be inside. Were they pushed out of
// a narrow tip at once, then by its flank, and the tip would slip into the tissue.
constexpr double kPressingDepth = 1;

Vec3 at(const std::array<FloatArray, 3>& field, std::int32_t i) {
  return {field[0][i], field[1][i], field[2][i]};
}

Vec3 vector(const Column& c) { return {c[0], c[1], c[2]}; }

// Stiffness and damping of a point of unit area: Pa/m, Pa s/m.
struct Spring {
  double stiffness, damping;
};
// The table and the tray are flat over many cells: there are no dents that the lattice does not
// resolve.
Spring springOf(const TissueMaterial& m, double spacing, bool dents) {
  const double pressed = m.lame() + 2 * m.shear();        // modulus of tissue that cannot give way
  const double dented = 2 * m.shear() / (1 - m.poisson);  // E / (1 - nu^2)
  return {1 / (0.5 * spacing / pressed + (dents ? kFineDents * spacing / dented : 0)),
          kDamping * m.density * m.waveSpeed()};
}

// How deep a point is in a half space that may end along x and z, and the shortest way out.
// turn: axes of the half space. fromOrigin: the point relative to its origin.
struct Depth {
  double depth;
  Vec3 outwards;
};
Depth depthBelow(const Obstacle& o, const Mat3& turn, const Vec3& fromOrigin) {
  Depth found{-fromOrigin.dot(turn.col(1)), turn.col(1)};
  for (const auto& [axis, half] : {std::pair(0, o.halfWidth), std::pair(2, o.halfDepth)}) {
    const double along = fromOrigin.dot(turn.col(axis));
    if (half - std::abs(along) >= found.depth) continue;
    found = {half - std::abs(along), along < 0 ? Vec3(-turn.col(axis)) : Vec3(turn.col(axis))};
  }
  return found;
}

}  // namespace

void TissueContacts::list(const ElasticState& s, const ElasticKernel& kernel, const Vec3& origin,
                          double duration, std::span<const Obstacle> obstacles,
                          std::span<const std::int32_t> gripper) {
  bodyCount_ = obstacles.size();
  if (bodies_.size() < bodyCount_) bodies_.resize(bodyCount_);
  impulse_.assign(bodyCount_, Vec3::Zero());
  for (std::size_t b = 0; b < bodyCount_; ++b) {
    Body& body = bodies_[b];
    const Obstacle& o = body.obstacle = obstacles[b];
    body.candidates.clear();
    body.cells.clear();
    body.points.clear();
    body.shares.clear();
    body.velocity = (o.to.position - o.from.position) / duration;
    body.spin = rotationVector(o.to.rotation * o.from.rotation.conjugate()) / duration;
  }
  listCells(s, origin, duration, gripper);
  slot_.resize(std::size_t(s.box.size), -1);
  mean_.clear(s);
  for (std::size_t b = 0; b < bodyCount_; ++b) {
    Body& body = bodies_[b];
    for (const std::int32_t cell : body.candidates) {
      const Vec3 x = origin + s.spacing * s.box.cell(cell).cast<double>() + at(s.u, cell);
      const double way = at(s.v, cell).norm() * duration;
      if (!reaches(body, x, way + kCentreReach * s.spacing)) continue;
      body.cells[std::size_t(slotOf(s, cell, origin, body))].near = true;
    }
    if (!body.obstacle.enters) listPoints(s, kernel, origin, duration, body);
    for (const Cell& cell : body.cells) slot_[std::size_t(cell.cell)] = -1;
  }
}

// Whether the obstacle can touch a point that moves by at most `way` in the frame.
bool TissueContacts::reaches(const Body& body, const Vec3& place, double way) const {
  const Obstacle& o = body.obstacle;
  if (!o.shape)
    return (place - o.from.position).dot(body.up[0]) < way ||
           (place - o.to.position).dot(body.up[1]) < way;
  const Vec3 inside = body.back * place;
  return (*o.shape)(inside).distance < way + (place - o.from * inside).norm();
}

// The cell's index in body.cells; it is appended if it is not there.
std::int32_t TissueContacts::slotOf(const ElasticState& s, std::int32_t cell, const Vec3& origin,
                                    Body& body) {
  std::int32_t& slot = slot_[std::size_t(cell)];
  if (slot < 0) {
    slot = std::int32_t(body.cells.size());
    body.cells.push_back({cell, false, origin + s.spacing * s.box.cell(cell).cast<double>()});
  }
  return slot;
}

void TissueContacts::listPoints(const ElasticState& s, const ElasticKernel& kernel,
                                const Vec3& origin, double duration, Body& body) {
  // What the table and the tray touch is as wide as many cells. Its own normal will do.
  const bool instrument = body.obstacle.tool >= 0;
  ChunkGradients gradients(s, kernel), around(s, kernel);
  for (const std::int32_t cell : body.candidates) {
    found_.clear();
    if (body.obstacle.shape)
      points_.fine(s, cell, true, found_);
    else
      points_.coarse(s, cell, found_);
    // A coarse test first, as if the tissue round the cell were not deformed.
    const Vec3 x = origin + s.spacing * s.box.cell(cell).cast<double>() + at(s.u, cell);
    const double way = at(s.v, cell).norm() * duration + kPointReach * s.spacing;
    std::erase_if(found_, [&](const ContactPoint& point) {
      return !reaches(body, x + point.offset.cast<double>(), way + s.spacing);
    });
    if (found_.empty()) continue;
    const Mat3 cof = cofactors(Mat3::Identity() + gradients.at(cell));
    AreaBySide sides;
    if (instrument) sides = mean_.around(s, points_, around, cell);
    for (const ContactPoint& point : found_) {
      Vec3 normal = (cof * point.normal.cast<double>()).normalized();
      if (instrument) {
        const Vec3 mean = meanNormal(sides, point.normal);
        const double share = std::clamp((kAlike - mean.dot(normal)) / (kAlike - kApart), 0.0, 1.0);
        normal = (share * mean + (1 - share) * normal).normalized();
      }
      listPoint(s, cell, point, cof, normal, origin, way, body);
    }
  }
}

// Lists a point, unless the obstacle is farther away than `way`.
void TissueContacts::listPoint(const ElasticState& s, std::int32_t cell, const ContactPoint& point,
                               const Mat3& cof, const Vec3& normal, const Vec3& origin, double way,
                               Body& body) {
  const PointWeights weights = weightsAt(s, cell, point.offset);
  // What lies between the mean of the cells and the surface turns as a normal does.
  const Vec3 above = (point.offset - weights.mean).cast<double>();
  Vec3 turned = cof * above;
  if (const double length = turned.norm(); length > 0) turned *= above.norm() / length;
  const Vec3 rest = origin + s.spacing * s.box.cell(cell).cast<double>();
  const Vec3 base = rest + weights.mean.cast<double>() + turned;
  Vec3 moved = Vec3::Zero();
  for (int n = 0; n < weights.count; ++n)
    moved += double(weights.weight[std::size_t(n)]) * at(s.u, weights.cell[std::size_t(n)]);
  const double width = std::sqrt(point.area);
  if (!reaches(body, base + moved, body.obstacle.shape ? way + 0.5 * width : way)) return;
  const Spring spring = springOf(s.materials[s.material[cell]], s.spacing, body.obstacle.tool >= 0);
  body.points.push_back({base.cast<float>(), (-normal).cast<float>(), float(width),
                         float(spring.stiffness * point.area), float(spring.damping * point.area),
                         std::int32_t(body.shares.size()), weights.count});
  for (int n = 0; n < weights.count; ++n)
    body.shares.push_back(
        {slotOf(s, weights.cell[std::size_t(n)], origin, body), weights.weight[std::size_t(n)]});
}

// How deep a point is in the obstacle; in world coordinates. fromOrigin: the point's position
// relative to that of the obstacle.
Dent TissueContacts::dentOf(const Body& body, const Point& point, const Stance& stance,
                            double spacing, const Vec3& fromOrigin) {
  const Obstacle& o = body.obstacle;
  WayOut limits{kDeepest * spacing, kFarthest * spacing, kNeverEdgeOn};
  if (o.tool >= 0) limits.leastSlope = kEdgeOn, limits.margin = kMargin * spacing;
  if (!o.shape) {
    const auto [depth, outwards] = depthBelow(o, stance.turn, fromOrigin);
    return {std::min(limits.deepest, depth), outwards, 1};
  }
  Dent dent = dentIn(*o.shape, stance.turn.transpose() * fromOrigin,
                     stance.turn.transpose() * point.inwards.cast<double>(), point.width, limits);
  dent.outwards = stance.turn * dent.outwards;
  return dent;
}

// Finds the impulses that the body's points give to its cells in a substep.
void TissueContacts::pressPoints(const ElasticState& s, const Body& body, const Stance& stance,
                                 double dt) {
  const double soft = kTwiceAsStiff * s.spacing;
  for (const Point& point : body.points) {
    const std::span<const Share> shares(body.shares.data() + point.first, std::size_t(point.count));
    Column moved{};
    for (const auto& [cell, weight] : shares)
      moved += (weight - Column{}) * moved_[std::size_t(cell)];
    const Vec3 fromOrigin = point.base.cast<double>() + vector(moved) - stance.pose.position;
    const Dent dent = dentOf(body, point, stance, s.spacing, fromOrigin);
    if (dent.depth <= 0) continue;
    const Vec3 velocity = body.velocity + body.spin.cross(fromOrigin);
    Vec3 speed = Vec3::Zero();
    for (const auto& [cell, weight] : shares)
      speed += double(weight) * at(s.v, body.cells[std::size_t(cell)].cell);
    const double into = -(speed - velocity).dot(dent.outwards);
    const double stiffer = 1 + dent.depth * dent.depth / (soft * soft);
    const double impulse =
        dt * dent.share * (point.stiffness * stiffer * dent.depth + point.damping * into);
    if (!(impulse > 0)) continue;
    Column given = column((impulse * dent.outwards).cast<float>());
    given[3] = 1;  // marks the cells that something is given to
    for (const auto& [cell, weight] : shares)
      given_[std::size_t(cell)] += (weight - Column{}) * given;
  }
}

// Moves a cell whose centre is inside the obstacle out of it: changes `way`, m, and `change` of
// velocity, m/s, both of this substep.
void TissueContacts::pushCentre(const ElasticState& s, const Body& body, const Stance& stance,
                                std::size_t k, Vec3f& way, Vec3f& change) const {
  const Obstacle& o = body.obstacle;
  const std::int32_t i = body.cells[k].cell;
  const Vec3 fromOrigin =
      body.cells[k].rest + at(s.u, i) + way.cast<double>() - stance.pose.position;
  double depth = (o.enters ? kEnteringStandOff : o.tool < 0 ? 0 : -kPressingDepth) * s.spacing;
  Vec3 outwards;
  if (o.shape) {
    const auto sample = (*o.shape)(stance.turn.transpose() * fromOrigin);
    depth -= sample.distance;
    outwards = stance.turn * sample.outwards;
  } else {
    const Depth below = depthBelow(o, stance.turn, fromOrigin);
    depth += below.depth;
    outwards = below.outwards;
  }
  if (depth <= 0) return;
  const Vec3 velocity = at(s.v, i) + change.cast<double>() - body.velocity;
  const double into = -(velocity - body.spin.cross(fromOrigin)).dot(outwards);
  if (into > 0) change += (into * outwards).cast<float>();
  way += (std::min(depth, kMostPush * s.spacing) * outwards).cast<float>();
}

// Applies to a cell what points have given to it, moves its centre out of the obstacle, and takes
// friction. Returns the momentum that the cell gains, kg m/s.
Vec3 TissueContacts::pushCell(ElasticState& s, const Body& body, const Stance& stance,
                              std::size_t k, float dt, float lookAhead) const {
  const auto& [i, near, rest] = body.cells[k];
  Vec3f change = s.inverseMass[i] * Vec3f(given_[k][0], given_[k][1], given_[k][2]);
  Vec3f way = dt * change;
  if (near) pushCentre(s, body, stance, k, way, change);
  if (way == Vec3f::Zero()) return Vec3::Zero();
  if (const float normal2 = change.squaredNorm(); normal2 > 0) {
    const Vec3f u(s.u[0][i], s.u[1][i], s.u[2][i]), v(s.v[0][i], s.v[1][i], s.v[2][i]);
    const Vec3f place = (rest - stance.pose.position).cast<float>() + u;
    const Vec3f relative =
        v + change - body.velocity.cast<float>() - body.spin.cast<float>().cross(place);
    const Vec3f along = relative - relative.dot(change) / normal2 * change;
    const float speed2 = along.squaredNorm();
    const auto most2 = float(body.obstacle.friction * body.obstacle.friction) * normal2;
    // The cell has already moved with the velocity that friction takes. This way is taken back too:
    // otherwise a cell that sticks would creep.
    const Vec3f dragged = (speed2 <= most2 ? -1.0f : -std::sqrt(most2 / speed2)) * along;
    change += dragged;
    way += dt * dragged;
  }
  for (int a = 0; a < 3; ++a) {
    if (s.held[i] >> a & 1) continue;
    s.u[a][i] += way[a];
    s.v[a][i] += change[a];
    s.ahead[a][i] = s.u[a][i] + lookAhead * s.v[a][i];
  }
  return change.cast<double>() / double(s.inverseMass[i]);
}

void TissueContacts::push(ElasticState& s, double share, double dt, double lookAhead) {
  for (std::size_t b = 0; b < bodyCount_; ++b) {
    const Body& body = bodies_[b];
    if (body.cells.empty()) continue;
    const Pose pose = interpolate(body.obstacle.from, body.obstacle.to, share);
    const Stance stance{pose, pose.rotation.toRotationMatrix()};
    given_.assign(body.cells.size(), Column{});
    if (!body.points.empty()) {
      moved_.clear();
      for (const auto& [cell, near, rest] : body.cells)
        moved_.push_back(Column{s.u[0][cell], s.u[1][cell], s.u[2][cell], 0});
      pressPoints(s, body, stance, dt);
    }
    for (std::size_t k = 0; k < body.cells.size(); ++k)
      if (body.cells[k].near || given_[k][3] > 0)
        impulse_[b] -= pushCell(s, body, stance, k, float(dt), float(lookAhead));
  }
}

const Obstacle* TissueContacts::obstacleOf(std::int32_t tool) const {
  for (std::size_t b = 0; b < bodyCount_; ++b)
    if (bodies_[b].obstacle.tool == tool) return &bodies_[b].obstacle;
  return nullptr;
}

void TissueContacts::pressedBy(const ElasticState& s, std::int32_t tool,
                               std::vector<PressedPoint>& points) const {
  const double soft = kTwiceAsStiff * s.spacing;
  for (std::size_t b = 0; b < bodyCount_; ++b) {
    const Body& body = bodies_[b];
    if (body.obstacle.tool != tool) continue;
    const Stance stance{body.obstacle.to, body.obstacle.to.rotation.toRotationMatrix()};
    for (const Point& point : body.points) {
      Vec3 place = point.base.cast<double>();
      for (std::int32_t k = point.first; k < point.first + point.count; ++k) {
        const auto& [cell, weight] = body.shares[std::size_t(k)];
        place += double(weight) * at(s.u, body.cells[std::size_t(cell)].cell);
      }
      const Dent dent = dentOf(body, point, stance, s.spacing, place - stance.pose.position);
      if (dent.depth <= 0 || !(dent.share > 0)) continue;
      const double depth2 = dent.depth * dent.depth / (soft * soft);
      const double spring = dent.share * point.stiffness;
      const std::int32_t own =
          body.cells[std::size_t(body.shares[std::size_t(point.first)].cell)].cell;
      points.push_back({place, dent.outwards, dent.share * point.width * point.width,
                        spring * (1 + depth2) * dent.depth, spring * (1 + 3 * depth2),
                        dent.share * point.damping, &s.materials[s.material[own]]});
    }
  }
}

void TissueContacts::forgetImpulses() {
  for (Vec3& impulse : impulse_) impulse.setZero();
}

}  // namespace resect
