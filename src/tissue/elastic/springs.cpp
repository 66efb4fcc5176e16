#include "tissue/elastic/springs.h"

namespace resect {

void TissueSprings::pull(ElasticState& s, const Vec3& origin, std::span<const Obstacle> obstacles,
                         const BreathMotion& held, double share, double frame, double dt) {
  const Vec3 carried = held.displacement(share), carriedSpeed = held.velocity(share);
  for (const TissueSpring& spring : springs_) {
    const std::int32_t i = spring.cell;
    const Vec3 x =
        origin + s.spacing * s.box.cell(i).cast<double>() + Vec3(s.u[0][i], s.u[1][i], s.u[2][i]);
    const Vec3 v(s.v[0][i], s.v[1][i], s.v[2][i]);
    Vec3 force = Vec3::Zero();
    if (spring.tool < 0) {
      force =
          spring.stiffness * (spring.anchor + carried - x) - spring.damping * (v - carriedSpeed);
    } else {
      for (std::size_t b = 0; b < obstacles.size(); ++b) {
        const Obstacle& tool = obstacles[b];
        if (tool.tool != spring.tool) continue;
        const Vec3 anchor = interpolate(tool.from, tool.to, share) * spring.anchor;
        const Vec3 speed = (tool.to * spring.anchor - tool.from * spring.anchor) / frame;
        force = spring.stiffness * (anchor - x) + spring.damping * (speed - v);
        impulse_[b] -= dt * force;
      }
    }
    for (int a = 0; a < 3; ++a) s.load[a][i] += float(force[a]);
  }
}

}  // namespace resect
