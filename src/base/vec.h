// What are the vector types of Resect? Eigen's, under short names.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace resect {

using Vec3 = Eigen::Vector3d;   // positions and directions, m unless said otherwise
using Vec3f = Eigen::Vector3f;  // bulk storage for viewers
using Vec3i = Eigen::Vector3i;  // lattice, node and brick indices
using Mat3 = Eigen::Matrix3d;

}  // namespace resect
