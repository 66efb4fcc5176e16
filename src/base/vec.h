// The vector types of Resect: types of Eigen under short names, and one type for inner loops.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace resect {

using Vec3 = Eigen::Vector3d;   // positions and directions; in m unless stated otherwise
using Vec3f = Eigen::Vector3f;  // the same in single precision, for large arrays
using Vec3i = Eigen::Vector3i;  // coordinates of cells, nodes and bricks
using Mat3 = Eigen::Matrix3d;

// Three numbers in one vector register. The fourth lane of the register is unused.
typedef float Column __attribute__((vector_size(16)));
inline Column column(const Vec3f& v) { return Column{v.x(), v.y(), v.z(), 0}; }

}  // namespace resect
