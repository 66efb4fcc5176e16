#include "tissue/elastic/contact.h"

#include <algorithm>
#include <cmath>

#include "geometry/moved_box.h"
#include "geometry/rotation.h"
#include "tissue/elastic/chunk_bounds.h"

namespace resect {
namespace {

constexpr double kMostPush =
    0.25;  // spacings per substep: limits the speed of cells when a tool jumps

Vec3 at(const std::array<FloatArray, 3>& field, std::int32_t i) {
  return {field[0][i], field[1][i], field[2][i]};
}

// Moves a cell out of an obstacle; returns the momentum that it loses, kg m/s. `depth` > 0.
Vec3 pushOut(ElasticState& s, std::int32_t i, double depth, const Vec3& outwards,
             const Vec3& bodyVelocity, double friction, double dt, double lookAhead) {
  const Vec3 relative = at(s.v, i) - bodyVelocity;
  const double into = -relative.dot(outwards);
  Vec3 change = Vec3::Zero(), dragged = Vec3::Zero();
  if (into > 0) {
    const Vec3 along = relative + into * outwards;
    const double speed = along.norm();
    if (speed > 0) dragged = -std::min(1.0, friction * into / speed) * along;
    change = into * outwards + dragged;
  }
  // The cell has already moved with the velocity that friction takes. This way is taken back too:
  // otherwise a cell that sticks would creep.
  const Vec3 way = std::min(depth, kMostPush * s.spacing) * outwards + dt * dragged;
  for (int a = 0; a < 3; ++a) {
    if (s.held[i] >> a & 1) continue;
    s.u[a][i] += float(way[a]);
    s.v[a][i] += float(change[a]);
    s.ahead[a][i] = s.u[a][i] + float(lookAhead) * s.v[a][i];
  }
  return change / double(s.inverseMass[i]);
}

}  // namespace

void TissueContacts::list(const ElasticState& s, const Vec3& origin, double duration,
                          std::span<const Obstacle> obstacles,
                          std::span<const std::int32_t> gripper) {
  bodyCount_ = obstacles.size();
  if (bodies_.size() < bodyCount_) bodies_.resize(bodyCount_);
  impulse_.assign(bodyCount_, Vec3::Zero());
  for (std::size_t b = 0; b < bodyCount_; ++b) {
    Body& body = bodies_[b];
    const Obstacle& o = body.obstacle = obstacles[b];
    body.cells.clear();
    body.velocity = (o.to.position - o.from.position) / duration;
    body.spin = rotationVector(o.to.rotation * o.from.rotation.conjugate()) / duration;
    body.up[0] = o.from.rotation * Vec3::UnitY();
    body.up[1] = o.to.rotation * Vec3::UnitY();
    if (!o.shape) continue;
    // Cells within reach of the obstacle at any time of the frame.
    Aabb box = o.shape->box();
    const Aabb still = box;
    const Pose back = o.to.inverse();
    for (int corner = 0; corner < 8; ++corner) box.grow(back * (o.from * still.corner(corner)));
    box = box.padded(o.standOff + s.spacing);
    body.back = back;
    body.box = box;
    body.world = movedBox(box, o.to);
  }
  constexpr double kDiagonal = 1.75;  // of a cube, at most
  // Whether a box, whose cells move by at most `way` in the frame, can touch a half space.
  const auto nearHalfSpace = [&](std::size_t b, const Aabb& box, double way) {
    const Obstacle& o = bodies_[b].obstacle;
    const double most = o.standOff + s.spacing + way;
    const auto reaches = [&](const Vec3& up, const Vec3& origin) {
      const Vec3 lowest = (up.array() > 0).select(box.min, box.max);
      return (lowest - origin).dot(up) < most;
    };
    return reaches(bodies_[b].up[0], o.from.position) || reaches(bodies_[b].up[1], o.to.position);
  };
  for (const TissueChunk& chunk : s.chunks) {
    const Aabb bounds = chunkBounds(s, chunk, origin);
    const double mostWay = chunkSpeed(s, chunk) * duration;
    bool near = false;
    for (std::size_t b = 0; b < bodyCount_ && !near; ++b) {
      const Obstacle& o = bodies_[b].obstacle;
      near = o.shape ? meets(bodies_[b].world.padded(kDiagonal * mostWay), bounds)
                     : o.halfSpace && nearHalfSpace(b, bounds, mostWay);
    }
    if (!near) continue;
    const Vec3i row = s.box.cell(chunk.start);
    for (int k = chunk.first; k <= chunk.last; ++k) {
      const std::int32_t i = chunk.start + k;
      if (!s.solid[i]) continue;
      const Vec3 rest = origin + s.spacing * (row + Vec3i(k, 0, 0)).cast<double>();
      const Vec3 x = rest + at(s.u, i);
      const double way = at(s.v, i).norm() * duration;
      for (std::size_t b = 0; b < bodyCount_; ++b) {
        const Obstacle& o = bodies_[b].obstacle;
        if (!o.shape) {
          if (o.halfSpace && nearHalfSpace(b, {x, x}, way)) bodies_[b].cells.push_back({i, rest});
          continue;
        }
        if (o.tool >= 0 && !gripper.empty() && gripper[i] == o.tool) continue;
        if (!bodies_[b].world.padded(kDiagonal * way).contains(x)) continue;
        if (bodies_[b].box.padded(way).contains(bodies_[b].back * x))
          bodies_[b].cells.push_back({i, rest});
      }
    }
  }
}

void TissueContacts::push(ElasticState& s, double share, double dt, double lookAhead) {
  pushCutFaces(s, lookAhead);
  for (std::size_t b = 0; b < bodyCount_; ++b) {
    Body& body = bodies_[b];
    if (body.cells.empty()) continue;
    const Obstacle& o = body.obstacle;
    const Pose pose = interpolate(o.from, o.to, share);
    const Mat3 turn = pose.rotation.toRotationMatrix();
    for (const auto& [i, rest] : body.cells) {
      const Vec3 fromOrigin = rest + at(s.u, i) - pose.position;
      double depth = o.standOff;
      Vec3 outwards = turn.col(1);  // of a half space
      if (o.shape) {
        const auto sample = (*o.shape)(turn.transpose() * fromOrigin);
        depth -= sample.distance;
        outwards = turn * sample.outwards;
      } else {
        depth -= fromOrigin.dot(outwards);
      }
      if (depth <= 0) continue;
      impulse_[b] -= pushOut(s, i, depth, outwards, body.velocity + body.spin.cross(fromOrigin),
                             o.friction, dt, lookAhead);
    }
  }
}

void TissueContacts::keepApart(const ElasticState& s, std::int32_t cell, int direction) {
  const std::int32_t other = cell + s.box.step[direction];
  const Vec3 rest = s.spacing * offsetOf(direction).cast<double>();
  const double now = (rest + at(s.u, other) - at(s.u, cell)).norm();
  cut_.push_back({cell, other, float(std::min(now, 0.9 * rest.norm())), rest.cast<float>()});
}

void TissueContacts::forgetCell(std::int32_t cell) {
  std::erase_if(cut_, [&](const CutPair& pair) { return pair.a == cell || pair.b == cell; });
}

void TissueContacts::pushCutFaces(ElasticState& s, double lookAhead) {
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

bool TissueContacts::fit(std::int32_t cells) const {
  return std::ranges::all_of(cut_, [&](const CutPair& pair) {
    return std::min(pair.a, pair.b) >= 0 && std::max(pair.a, pair.b) < cells;
  });
}

void TissueContacts::forgetImpulses() {
  for (Vec3& impulse : impulse_) impulse.setZero();
}

}  // namespace resect
