// Positions of the objects in the operating room. The scenario's defaults and the pictures use
// them.
//
// World coordinates, m, Y up: the table's top is at y = 0, the patient's left is towards +X, the
// surgeon towards +Z. The organ lies round the origin.
#pragma once

#include <numbers>

#include "geometry/aabb.h"
#include "geometry/pose.h"
#include "geometry/rotation.h"
#include "geometry/triangle_mesh.h"

namespace resect {

// Pose of the tool box. The origin of the box's frame is the centre of its bottom.
inline Pose toolBoxPose() { return {Vec3(0.27, 0.0, 0.02), Eigen::Quaterniond::Identity()}; }

// The place of the operative field, a model of the opened abdomen (data/room/field.iv, field_*.ply)
// that lies round the organs. The field is drawn at this place, and is an obstacle for tissue
// there.
struct FieldPlace {
  Vec3 position = Vec3::Zero();  // of the field's origin, world, m
  double scale = 1;              // 0.6 to 1.6: size of the field, relative to its files
};
FieldPlace fieldPlace(const Aabb& organs);  // organs: box round all organs, world, m

// The operating table as it is drawn (data/room/table.iv), and the floor on which it stands.
inline constexpr double kTableHalfWidth = 0.45, kTableHalfDepth = 0.30, kFloor = -0.9;  // m

// The four walls of the tool box as one closed mesh in the box's frame, an obstacle for tissue.
// Their outside measures 30 x 22 cm; they are 25 mm high and 12 mm thick. (Tissue could pass
// through walls that are only 1 mm thick.) The mesh has no floor, since the box stands on the
// table.
TriangleMesh toolBoxWalls();

// Pose of the tray (data/room/tray.iv), for tools 4 to 11. The organ lies between the tray and the
// tool box. The tray's rim is low and is no obstacle for tissue. The origin of the tray's frame is
// the centre of its bottom.
inline constexpr int kToolBoxPlaces = 4;
inline Pose trayPose() { return {Vec3(-0.3375, 0.0, -0.08), Eigen::Quaterniond::Identity()}; }

// Pose in which tool number i (counted from 0) lies when it is not in hand. The tools lie on their
// sides, one beside the other, with their handles towards the surgeon. Tools 0 to 3 lie in the tool
// box; further tools lie in the tray, four in a row.
inline Pose toolBoxPlace(int i) {
  const Eigen::Quaterniond onItsSide = rotationAbout(Vec3::UnitZ(), std::numbers::pi / 2);
  constexpr double kPlaces[] = {-0.085, -0.01, 0.065, 0.104};  // x, m
  if (i < kToolBoxPlaces) return {toolBoxPose() * Vec3(kPlaces[i], 0.008, -0.085), onItsSide};
  const int row = (i - kToolBoxPlaces) / 4, column = (i - kToolBoxPlaces) % 4;
  return {Vec3(-0.27 - 0.045 * column, 0.008, -0.065 - 0.21 * row), onItsSide};
}

// Rotation of a tool that is held over the organ for a cut. The handle points up and towards the
// surgeon; the cutting edge faces down and towards the surgeon.
inline Eigen::Quaterniond workingRotation() {
  const Vec3 handle = Vec3(0, 0.9, 0.45).normalized(), edge = Vec3(0, -0.45, 0.9).normalized();
  // The columns are the axes x, y and z of the tool's frame. In this frame the edge faces -y and
  // the handle points to +z.
  Mat3 axes;
  axes << -edge.cross(handle), -edge, handle;
  return Eigen::Quaterniond(axes);
}

}  // namespace resect
