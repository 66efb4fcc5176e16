// The closed loops in which the surface of a cut organ meets the border of a cell of the grid.
//
// Edge points are the points of the surface on the cell's edges (wound/wound_edges.h). The lines on
// the cell's six faces (wound/wound_faces.h) lead from edge point to edge point. An edge point that
// is the end of one line is always the start of another line, so the lines form closed loops.
#pragma once

#include <vector>

#include "isosurface/marching_cubes_table.h"
#include "wound/wound_faces.h"

namespace resect {

// Number of a vertex of a cell. There are three kinds of vertices:
// - one of the cell's 36 edge points: 3 * (number of the cell edge) + EdgeNode;
// - a vertex at a face's point (FaceLines::point), where lines bend: faceVertex(face, number). The
//   face is 2 * axis + side; `number` counts the bent lines of that face;
// - one of the cell's own points: from kFirstCellVertex on.
using CellVertex = std::uint8_t;
constexpr int kCellNodes = 36;
constexpr int kFirstFaceVertex = kCellNodes, kFirstCellVertex = kFirstFaceVertex + 6 * 8;
constexpr CellVertex faceVertex(int face, int number) {
  return CellVertex(kFirstFaceVertex + 8 * face + number);
}

// The number of the cell edge that is ring edge `ring` of a face (RingEdge in wound_faces.h).
int cellEdgeOfRing(int face, int ring);

// The loops of one cell. One object is used for one cell after another, so that its memory is
// reused.
struct CellLoops {
  // One corner of a loop: an edge point, or a vertex at a face's point.
  struct Vertex {
    CellVertex vertex;
    bool iso;             // whether it is an edge point at the iso level
    NearbyNodes anchors;  // anchors of the corner and of the line that begins at the corner
  };

  // Finds the loops of the cell with lowest node i. faces: the lines of the cell's faces; a face
  // has the number 2 * axis + side.
  void set(const CutGrid& grid, int i, const std::array<const FaceLines*, 6>& faces);

  Vec3i node;   // the cell's lowest node
  Vec3 corner;  // position of that node, in the coordinates of the CutGrid's nodes
  std::array<const FaceLines*, 6> faces;
  const CellTriangles* table;  // triangles that the cell would have without cuts

  std::vector<Vertex> loop;           // all loops that a cut changed, concatenated
  std::vector<std::size_t> loopEnds;  // per loop: index in `loop` after its last corner
  // A skin loop is a loop that the cell would have without cuts, on the organ's surface.
  std::array<int, 12> skinOf;    // per cell edge: its skin loop; -1: no iso point
  int skins;                     // the numbers in skinOf are below this; some may be unused
  std::array<bool, 4> touched;   // per skin loop: whether a cut changed it
  std::vector<CellVertex> rest;  // work space for capping

  // Position of an edge point, or of a vertex at a face's point, relative to `corner`.
  Vec3 position(CellVertex v) const {
    return v < kFirstFaceVertex
               ? position_[v]
               : Vec3(faces[std::size_t((v - kFirstFaceVertex) / 8)]->point - corner);
  }

  // Visits the lines that the surface would have on the cell's faces if there were no cuts. Calls
  // visit(edge, next, crossed) for each line. The line leads from cell edge `edge` to cell edge
  // `next`. crossed: whether a cut crosses the line.
  template <typename Visit>
  void visitSkinLines(Visit visit) const {
    for (int face = 0; face < 6; ++face) {
      const FaceLines& lines = *faces[std::size_t(face)];
      int end = -1, start = -1;  // end points of a line that a cut crosses
      const auto give = [&](int from, int to, bool crossed) {
        if (face % 2 == 1) std::swap(from, to);
        visit(cellEdgeOfRing(face, from / 3), cellEdgeOfRing(face, to / 3), crossed);
      };
      for (int n = 0; n < lines.count; ++n) {
        const FaceLine& line = lines.line[std::size_t(n)];
        if (line.end % 3 == kIsoNode && line.start % 3 == kIsoNode)
          give(line.end, line.start, false);
        else if (line.end % 3 == kIsoNode)
          end = line.end;
        else if (line.start % 3 == kIsoNode)
          start = line.start;
      }
      if (end >= 0) give(end, start, true);
    }
  }

  // Calls visit(position) for each face of the cell in which a cut meets skin loop l. position: the
  // point where cut and loop meet, relative to `corner`.
  template <typename Visit>
  void visitSkinPoints(int l, Visit visit) const {
    for (int face = 0; face < 6; ++face) {
      const FaceLines& lines = *faces[std::size_t(face)];
      if (lines.kind != FacePoint::Skin) continue;
      for (int n = 0; n < lines.count; ++n) {
        const int end = lines.line[std::size_t(n)].end;
        if (end % 3 != kIsoNode || skinOf[std::size_t(cellEdgeOfRing(face, end / 3))] != l)
          continue;
        visit(position(faceVertex(face, 0)));
        break;
      }
    }
  }

 private:
  struct Link {
    std::int8_t next = -1;
    std::int8_t face = -1, line = -1;  // if bent: its face, its number among bent lines
    NearbyNodes anchors = 0;
  };
  void setNodes(const CutGrid& grid);
  void joinSkin();
  void link();
  void trace();

  std::array<Vec3, kCellNodes> position_;  // relative to `corner`
  std::array<NearbyNodes, kCellNodes> anchors_;
  std::array<Link, kCellNodes> links_;
};

}  // namespace resect
