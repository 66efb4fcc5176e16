// The vector types of Resect: Eigen's under short names, and one for inner loops.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace resect {

using Vec3 = Eigen::Vector3d;   // positions and directions, m unless said otherwise
using Vec3f = Eigen::Vector3f;  // bulk storage for viewers
using Vec3i = Eigen::Vector3i;  // coordinates of cells, nodes and bricks
using Mat3 = Eigen::Matrix3d;

// Three numbers and an unused fourth in one vector register.
typedef float Column __attribute__((vector_size(16)));
inline Column column(const Vec3f& v) { return Column{v.x(), v.y(), v.z(), 0}; }

}  // namespace resect
