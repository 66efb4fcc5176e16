// The closed loops in which the surface meets the border of a cell.
//
// The lines on the cell's six faces lead from edge point to edge point; each point is the end of
// one line and the start of another, so they always form closed loops.
#pragma once

#include <vector>

#include "isosurface/marching_cubes_table.h"
#include "wound/wound_faces.h"

namespace resect {

// A vertex of a cell: one of its 36 edge points (3 * cell edge + EdgeNode), a face point (of face 2
// * axis + side, with the line's number among the bent ones), or one of the cell's own points.
using CellVertex = std::uint8_t;
constexpr int kCellNodes = 36;
constexpr int kFirstFaceVertex = kCellNodes, kFirstCellVertex = kFirstFaceVertex + 6 * 8;
constexpr CellVertex faceVertex(int face, int number) {
  return CellVertex(kFirstFaceVertex + 8 * face + number);
}

// The cell edge that is ring edge `ring` of a face.
int cellEdgeOfRing(int face, int ring);

// Reused for one cell after another; keeps its memory.
struct CellLoops {
  // One corner of a loop: an edge point, or the vertex at a face's point.
  struct Vertex {
    CellVertex vertex;
    bool iso;
    NearbyNodes anchors;  // including those of the line that starts here
  };

  // faces: the lines of the faces of the cell at node i, by number.
  void set(const CutGrid& grid, int i, const std::array<const FaceLines*, 6>& faces);

  Vec3i node;
  Vec3 corner;  // the same as a position in the window
  std::array<const FaceLines*, 6> faces;
  const CellTriangles* table;  // triangles of the uncut cell

  std::vector<Vertex> loop;           // all loops that were cut, concatenated
  std::vector<std::size_t> loopEnds;  // in `loop`
  std::array<int, 12> skinOf;         // per edge with an iso point: its uncut loop
  int skins;                          // numbers given to uncut loops; some may be unused
  std::array<bool, 4> touched;        // per uncut loop: whether it was cut
  std::vector<CellVertex> rest;       // work space for capping

  // Position of an edge point or face point, relative to the cell.
  Vec3 position(CellVertex v) const {
    return v < kFirstFaceVertex
               ? position_[v]
               : Vec3(faces[std::size_t((v - kFirstFaceVertex) / 8)]->point - corner);
  }

  // visit(edge, next edge, whether a cut crosses it) for the lines of the organ's surface in the
  // cell.
  template <typename Visit>
  void visitSkinLines(Visit visit) const {
    for (int face = 0; face < 6; ++face) {
      const FaceLines& lines = *faces[std::size_t(face)];
      int end = -1, start = -1;  // of a line that is crossed
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

  // visit(position) for each point where the cut meets skin loop l, once for each face.
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
    std::int8_t face = -1, line = -1;  // of the bent line that leads there
    NearbyNodes anchors = 0;
  };
  void setNodes(const CutGrid& grid);
  void joinSkin();
  void link();
  void trace();

  std::array<Vec3, kCellNodes> position_;  // in the cell
  std::array<NearbyNodes, kCellNodes> anchors_;
  std::array<Link, kCellNodes> links_;
};

}  // namespace resect
