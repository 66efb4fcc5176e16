// Which cells can come near an obstacle in a frame.
#include "geometry/moved_box.h"
#include "tissue/elastic/boundary_cells.h"
#include "tissue/elastic/chunk_bounds.h"
#include "tissue/elastic/contact/contact.h"

namespace resect {
namespace {

constexpr double kReach = 1.5;      // spacings: of a cell's points from its centre, and some more
constexpr double kNoPoint = 2.5;    // spacings: so far from a cell no point of it can be near
constexpr double kDiagonal = 1.75;  // of a cube, at most

}  // namespace

void TissueContacts::listCells(const ElasticState& s, const Vec3& origin, double duration,
                               std::span<const std::int32_t> gripper) {
  const auto at = [](const std::array<FloatArray, 3>& field, std::int32_t i) {
    return Vec3(field[0][i], field[1][i], field[2][i]);
  };
  for (std::size_t b = 0; b < bodyCount_; ++b) {
    Body& body = bodies_[b];
    const Obstacle& o = body.obstacle;
    body.up[0] = o.from.rotation * Vec3::UnitY();
    body.up[1] = o.to.rotation * Vec3::UnitY();
    body.back = o.to.inverse();
    if (!o.shape) continue;
    // Cells within reach of the obstacle at any time of the frame.
    Aabb box = o.shape->box();
    const Aabb still = box;
    for (int corner = 0; corner < 8; ++corner)
      box.grow(body.back * (o.from * still.corner(corner)));
    body.box = box.padded(kReach * s.spacing);
    body.world = movedBox(body.box, o.to);
  }
  // Whether a box, whose cells move by at most `way` in the frame, can touch a half space.
  const auto nearHalfSpace = [&](const Body& body, const Aabb& box, double way) {
    const double most = kReach * s.spacing + way;
    const auto reaches = [&](const Vec3& up, const Vec3& place) {
      const Vec3 lowest = (up.array() > 0).select(box.min, box.max);
      return (lowest - place).dot(up) < most;
    };
    return reaches(body.up[0], body.obstacle.from.position) ||
           reaches(body.up[1], body.obstacle.to.position);
  };
  for (const TissueChunk& chunk : s.chunks) {
    const Aabb bounds = chunkBounds(s, chunk, origin);
    const double mostWay = chunkSpeed(s, chunk) * duration;
    bool near = false;
    for (std::size_t b = 0; b < bodyCount_ && !near; ++b) {
      const Obstacle& o = bodies_[b].obstacle;
      near = o.shape ? meets(bodies_[b].world.padded(kDiagonal * mostWay), bounds)
                     : o.halfSpace && nearHalfSpace(bodies_[b], bounds, mostWay);
    }
    if (!near) continue;
    const Vec3i row = s.box.cell(chunk.start);
    for (int k = chunk.first; k <= chunk.last; ++k) {
      const std::int32_t i = chunk.start + k;
      if (!isParticle(s, i)) continue;
      const Vec3 rest = origin + s.spacing * (row + Vec3i(k, 0, 0)).cast<double>();
      const Vec3 x = rest + at(s.u, i);
      const double way = at(s.v, i).norm() * duration;
      for (std::size_t b = 0; b < bodyCount_; ++b) {
        Body& body = bodies_[b];
        const Obstacle& o = body.obstacle;
        if (!o.shape) {
          if (o.halfSpace && nearHalfSpace(body, {x, x}, way)) body.candidates.push_back(i);
          continue;
        }
        if (o.tool >= 0 && !gripper.empty() && gripper[i] == o.tool) continue;
        if (!body.world.padded(kDiagonal * way).contains(x)) continue;
        const Vec3 inside = body.back * x;
        if (!body.box.padded(way).contains(inside)) continue;
        // The box of the operative field's body is also round all that it does not touch.
        if (o.tool < 0 && (*o.shape)(inside).distance > way + kNoPoint * s.spacing) continue;
        body.candidates.push_back(i);
      }
    }
  }
}

}  // namespace resect
