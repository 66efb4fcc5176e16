// Writes a binary glTF 2.0 file (.glb) with meshes and animated nodes.
//
// Source: Khronos, "glTF 2.0 Specification". Each array is written to the disk immediately, into a
// temporary file beside the target. Only the JSON description stays in memory. So a long animation
// takes little memory. While finish() runs, the temporary file and the target together take twice
// the file's size on the disk.
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

// Converts a screen colour (sRGB, IEC 61966-2-1) to linear RGB, which glTF requires.
Vec3f linearColour(const Vec3f& screen);

using Rgba8 = std::array<std::uint8_t, 4>;

// In the structs below, each int stands for an array, a material, a mesh or a node. It is the
// number that a function of GlbFile returned when this object was added; -1: none.
struct GlbMaterial {
  std::string name;
  // Linear RGB, 0 to 1. Viewers multiply it by the colour of each point.
  Vec3f colour = Vec3f::Ones();
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
  bool shown = true;  // false: the node's scale is 0, which hides the node
  int mesh = -1;
  std::vector<int> children = {};
};

class GlbFile {
 public:
  // Throws Error if `path` cannot be written.
  explicit GlbFile(const std::filesystem::path& path);
  ~GlbFile();
  GlbFile(const GlbFile&) = delete;
  GlbFile& operator=(const GlbFile&) = delete;

  // Each of these functions adds an array and returns the array's number. The array must not be
  // empty. The functions throw Error if the disk is full, or if the file would exceed 4 GB.
  // addTriangles(): `points` is the number of points of the mesh. addVectors(): the vectors are
  // translations, m, or scales.
  int addPoints(std::span<const Vec3f> points);    // m
  int addNormals(std::span<const Vec3f> normals);  // unit
  int addColours(std::span<const Rgba8> colours);  // linear RGB, alpha
  int addTriangles(std::span<const Triangle> triangles, std::size_t points);
  int addTimes(std::span<const float> times);  // s, ascending, from 0
  int addVectors(std::span<const Vec3f> vectors);
  int addRotations(std::span<const Eigen::Quaterniond> rotations);

  int addMaterial(const GlbMaterial& material);
  int addMesh(const GlbMesh& mesh);
  int addNode(const GlbNode& node);  // the node's children must have been added before
  void addToScene(int node);

  // Motion::Shown is a change of the node's scale, which is (1, 1, 1) or (0, 0, 0). Such a scale
  // holds until the next time of the array.
  enum class Motion { Translation, Rotation, Shown };
  // Adds the motion of a node to the file's only animation. times, values: the numbers of two
  // arrays, as the functions above return them.
  void animate(int node, Motion motion, int times, int values);

  // Writes the file, atomically (io/output/atomic_file.h), and returns its size in bytes. To be
  // called once, after everything was added.
  std::uint64_t finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace resect
