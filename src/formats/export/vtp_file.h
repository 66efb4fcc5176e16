// Writes surfaces for ParaView: .vtp files (VTK XML PolyData), and .pvd files, which list .vtp
// files with their times.
//
// Source: Kitware, "VTK XML Formats"; ParaView's guide for .pvd. Numbers are appended to the XML in
// binary: little-endian, not compressed.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// All arrays but `triangles` have one element per point.
struct VtpSurface {
  std::vector<Vec3f> points, normals;  // points in m, unit normals
  // From 0 on the organ's original surface to 1 on a cut surface (isosurface/brick_look.h).
  std::vector<float> cutShare;
  std::vector<std::int32_t> organ;  // number of the organ, from 0
  std::vector<Triangle> triangles;
};

// time: s; written as the field TimeValue. Writes atomically (io/output/atomic_file.h).
void writeVtp(const std::filesystem::path& path, const VtpSurface& surface, double time);

struct PvdEntry {
  double time = 0;   // s
  std::string file;  // name of a .vtp file in the folder of the .pvd file
};
void writePvd(const std::filesystem::path& path, std::span<const PvdEntry> entries);

}  // namespace resect
