// Reference mesher for the surface of a cut organ. All cells of a whole grid, one after the other,
// vertices looked up by name; and obvious tests of what such a surface must be.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/random.h"
#include "geometry/triangle_mesh.h"
#include "wound/cut_grid.h"

namespace resect::test {

// A whole grid with values and severed edges of its own. Keep two empty nodes round the tissue.
struct GridOrgan {
  Vec3i dims = Vec3i::Zero();
  std::vector<float> value;
  std::array<std::vector<float>, 3> severed;
  float iso = 50;

  explicit GridOrgan(const Vec3i& dims);
  CutGrid view(const SeveredEdges* wound = nullptr) const;
  // Values by value(node) in [0, 100]; the outermost two layers of nodes are emptied.
  void fill(const std::function<double(const Vec3i&)>& value);
  // Takes the severed edges from there.
  void take(const SeveredEdges& wound);
};

// Does the skin hold in the face at (node, axis)? Another rule than the real one.
using HoldsRule = std::function<bool(int node, int axis)>;

struct WoundMesh {
  TriangleMesh mesh;                      // node spacings
  std::vector<std::vector<int>> anchors;  // per point: the nodes that it goes with
  std::vector<std::uint8_t> onLip;        // per triangle
  std::vector<std::uint8_t> tip;          // per point: at the end of a cut within a face
  std::vector<std::uint8_t> sheet;        // per point: node of a cut edge
  int cutCells = 0, unbalanced = 0;
};
WoundMesh woundMesh(const CutGrid& grid, const HoldsRule& holds = {});
// The table's surface, as if nothing were cut.
TriangleMesh tableMesh(const CutGrid& grid);

// What is wrong with it; empty when each directed edge occurs once with its opposite once, and the
// triangles round every point form one ring.
std::string wrongWith(const TriangleMesh& mesh);

// Per node: which piece of tissue, connected over whole edges between inside nodes, or -1.
std::vector<int> tissuePieces(const CutGrid& grid, int* count = nullptr);
// Components of the surface that hold points anchored in more than one piece of tissue.
int bridges(const WoundMesh& surface, const CutGrid& grid);
// Volumes of the pieces of tissue, h^3: the components of the surface added up by the piece that
// they are anchored in, ascending; pieces below `least` are left out.
std::vector<double> pieceVolumes(const WoundMesh& surface, const CutGrid& grid, double least = 0);

}  // namespace resect::test
