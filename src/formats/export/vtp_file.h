// Writes surfaces for ParaView: .vtp (VTK XML PolyData) files, and the .pvd file that gives each
// its time.
//
// Source: Kitware, "VTK XML Formats"; ParaView's guide for .pvd. Numbers are appended to the XML as
// they lie in memory: little-endian, not compressed.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace resect {

// One element per point in each of the arrays but `triangles`.
struct VtpSurface {
  std::vector<Vec3f> points, normals;  // m; unit
  std::vector<float> cutShare;         // 0 capsule to 1 cut
  std::vector<std::int32_t> organ;     // its number
  std::vector<Triangle> triangles;
};

// time: s, as the field TimeValue. Atomic, as all outputs (io/atomic_file.h).
void writeVtp(const std::filesystem::path& path, const VtpSurface& surface, double time);

struct PvdEntry {
  double time = 0;   // s
  std::string file;  // a name in the folder of the .pvd
};
void writePvd(const std::filesystem::path& path, std::span<const PvdEntry> entries);

}  // namespace resect
