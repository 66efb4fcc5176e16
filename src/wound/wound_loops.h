// The closed loops in which the surface meets the border of a cell.
//
// The lines on the cell's six faces lead from edge point to edge point. Each point is the end of
// one line and the start of another, so the lines always form closed loops.
#pragma once

#include <vector>

#include "isosurface/marching_cubes_table.h"
#include "wound/wound_faces.h"

namespace resect {

// Number of a vertex of a cell. It stands for one of the cell's 36 edge points (3 * cell edge +
// EdgeNode), for a vertex at a face's point (faceVertex(): face 2 * axis + side, then the line's
// number among the bent ones), or for one of the cell's own points.
using CellVertex = std::uint8_t;
constexpr int kCellNodes = 36;
constexpr int kFirstFaceVertex = kCellNodes, kFirstCellVertex = kFirstFaceVertex + 6 * 8;
constexpr CellVertex faceVertex(int face, int number) {
  return CellVertex(kFirstFaceVertex + 8 * face + number);
}

// The number of the cell edge that is ring edge `ring` of a face.
int cellEdgeOfRing(int face, int ring);

// The loops of one cell. The object is reused for one cell after another, so that it keeps its
// memory.
struct CellLoops {
  // One corner of a loop: an edge point, or the vertex at a face's point.
  struct Vertex {
    CellVertex vertex;
    bool iso;             // an edge point at the iso level
    NearbyNodes anchors;  // with those of the line that leads from here
  };

  // Finds the loops of the cell at node i. faces: the lines of its faces, by number (2 * axis +
  // side).
  void set(const CutGrid& grid, int i, const std::array<const FaceLines*, 6>& faces);

  Vec3i node;   // the cell's lowest node
  Vec3 corner;  // the same, as a position in the window
  std::array<const FaceLines*, 6> faces;
  const CellTriangles* table;  // triangles of the uncut cell

  std::vector<Vertex> loop;           // all loops that were cut, concatenated
  std::vector<std::size_t> loopEnds;  // where each loop ends in `loop`
  // A skin loop is a loop of the surface of the uncut cell.
  std::array<int, 12> skinOf;    // per edge with an iso point: number of its skin loop
  int skins;                     // all these numbers are below; some may be unused
  std::array<bool, 4> touched;   // per skin loop: whether it was cut
  std::vector<CellVertex> rest;  // work space for capping

  // Position of an edge point or face point, relative to the cell.
  Vec3 position(CellVertex v) const {
    return v < kFirstFaceVertex
               ? position_[v]
               : Vec3(faces[std::size_t((v - kFirstFaceVertex) / 8)]->point - corner);
  }

  // Calls visit(edge, next edge, crossed) for each line of the uncut surface on the cell's faces.
  // The line leads from the cell edge `edge` to the next one. crossed: whether a cut crosses the
  // line.
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

  // Calls visit(position) for each face of the cell in which the cut meets skin loop l.
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
    std::int8_t face = -1, line = -1;  // of the line that leads there, if it is bent
    NearbyNodes anchors = 0;
  };
  void setNodes(const CutGrid& grid);
  void joinSkin();
  void link();
  void trace();

  std::array<Vec3, kCellNodes> position_;  // relative to the cell
  std::array<NearbyNodes, kCellNodes> anchors_;
  std::array<Link, kCellNodes> links_;
};

}  // namespace resect
