// Positions in the operating room, shared by the scenario's defaults and the pictures.
//
// World: m, Y up, table top at y = 0, the patient's left at +X, the surgeon at +Z. The organ lies
// round the origin.
#pragma once

#include <numbers>

#include "geometry/pose.h"
#include "geometry/rotation.h"
#include "geometry/triangle_mesh.h"

namespace resect {

// The tool box's frame: its origin is the centre of the box's bottom.
inline Pose toolBoxPose() { return {Vec3(0.27, 0.0, 0.02), Eigen::Quaterniond::Identity()}; }

// The four walls of the tool box as one closed mesh in the box's frame, an obstacle for tissue.
// They measure 30 x 22 cm outside and are 25 mm high and 12 mm thick, inwards, since walls of a
// millimetre would hold back no cell. The mesh has no floor: the box stands on the table.
TriangleMesh toolBoxWalls();

// Rest pose of tool number i, from 0, in the tool box: the tools lie on their sides, one beside the
// other, with their handles towards the surgeon. The box has four places; further tools lie on the
// table beside it.
inline Pose toolBoxPlace(int i) {
  const Eigen::Quaterniond onItsSide = rotationAbout(Vec3::UnitZ(), std::numbers::pi / 2);
  constexpr double kPlaces[] = {-0.085, -0.01, 0.065, 0.104};  // x, m
  const double x = i < 4 ? kPlaces[i] : 0.19 + 0.05 * (i - 4);
  return {toolBoxPose() * Vec3(x, 0.008, -0.085), onItsSide};
}

// Rotation of a tool held over the organ for a cut: handle up and towards the surgeon, edge towards
// the surgeon.
inline Eigen::Quaterniond workingRotation() {
  const Vec3 handle = Vec3(0, 0.9, 0.45).normalized(), edge = Vec3(0, -0.45, 0.9).normalized();
  Mat3 axes;  // of the tool's frame: the edge faces -Y, the handle points to +Z
  axes << -edge.cross(handle), -edge, handle;
  return Eigen::Quaterniond(axes);
}

}  // namespace resect
