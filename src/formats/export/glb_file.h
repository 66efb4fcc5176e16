// Writes a binary glTF 2.0 file (.glb) with meshes and animated nodes.
//
// Source: Khronos, "glTF 2.0 Specification". Data go to the disk as they are added, into a file
// without a lasting name beside the target; only the description stays in memory. So a long
// animation takes little memory, and for a while twice its size on the disk.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/pose.h"
#include "geometry/triangle_mesh.h"

namespace resect {

// A screen's colour (sRGB, IEC 61966-2-1) as light, which glTF wants.
Vec3f linearColour(const Vec3f& screen);

using Rgba8 = std::array<std::uint8_t, 4>;

// Numbers of what was added before, as the functions of GlbFile return them; -1: none.
struct GlbMaterial {
  std::string name;
  Vec3f colour = Vec3f::Ones();  // linear, 0 to 1; each point's colour is a factor of it
  float metallic = 0, roughness = 1;
};
struct GlbMesh {
  std::string name;
  int points = -1, triangles = -1;
  int normals = -1;  // -1: viewers shade each triangle flat
  int colours = -1, material = -1;
};
struct GlbNode {
  std::string name;
  Pose pose;
  bool shown = true;  // false: scale 0, by which the specification hides a node
  int mesh = -1;
  std::vector<int> children = {};
};

class GlbFile {
 public:
  // Throws Error if nothing can be written there.
  explicit GlbFile(const std::filesystem::path& path);
  ~GlbFile();
  GlbFile(const GlbFile&) = delete;
  GlbFile& operator=(const GlbFile&) = delete;

  // Data. Each throws Error on a full disk, and if the file would exceed 4 GB. None may be empty.
  int addPoints(std::span<const Vec3f> points);    // m
  int addNormals(std::span<const Vec3f> normals);  // unit
  int addColours(std::span<const Rgba8> colours);  // linear
  int addTriangles(std::span<const Triangle> triangles, std::size_t points);
  int addTimes(std::span<const float> times);  // s, ascending, from 0
  int addVectors(std::span<const Vec3f> vectors);
  int addRotations(std::span<const Eigen::Quaterniond> rotations);

  int addMaterial(const GlbMaterial& material);
  int addMesh(const GlbMesh& mesh);
  int addNode(const GlbNode& node);  // children first
  void addToScene(int node);

  // Motion of a node in the file's one animation; times and values as from above.
  enum class Motion { Translation, Rotation, Shown };  // Shown: scale, held from time to time
  void animate(int node, Motion motion, int times, int values);

  // Writes the file, atomically (io/atomic_file.h), and returns its size in bytes. Once only.
  std::uint64_t finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace resect
