// Which closed loops does the surface make on the border of a cell?
//
// The lines on the cell's six faces lead from node to node; each node is the end of one and the
// start of another, so they close, whatever was cut.
#pragma once

#include <vector>

#include "isosurface/marching_cubes_table.h"
#include "wound/wound_faces.h"

namespace resect {

// A vertex as seen from a cell: one of 36 nodes (3 * cell edge + EdgeNode), of the face points (of
// face 2 * axis + side, the line's number among the bent ones), or of the cell's own points.
using CellVertex = std::uint8_t;
constexpr int kCellNodes = 36;
constexpr int kFirstFaceVertex = kCellNodes, kFirstCellVertex = kFirstFaceVertex + 6 * 8;
constexpr CellVertex faceVertex(int face, int number) {
  return CellVertex(kFirstFaceVertex + 8 * face + number);
}

// The cell edge that is ring edge `ring` of a face.
int cellEdgeOfRing(int face, int ring);

// Set for one cell after another; keeps its memory.
struct CellLoops {
  // One corner of a loop: a node, or the vertex at a face's point.
  struct Vertex {
    CellVertex vertex;
    bool iso;
    NearbyNodes anchors;  // also of the line that leads on from here
  };

  // faces: the lines of the faces of the cell at node i, by number.
  void set(const CutGrid& grid, int i, const std::array<const FaceLines*, 6>& faces);

  Vec3i node;
  Vec3 corner;  // the same: where the cell begins in the window
  std::array<const FaceLines*, 6> faces;
  const CellTriangles* table;  // what would be drawn, had nothing been cut

  std::vector<Vertex> loop;           // all loops that were cut, one after another
  std::vector<std::size_t> loopEnds;  // in loop
  std::array<int, 12> skinOf;         // per edge with an iso node: its uncut loop
  int skins;                          // numbers given to uncut loops; some may be unused
  std::array<bool, 4> touched;        // per uncut loop: was it cut?
  std::vector<CellVertex> rest;       // room for the capping

  // Of a node or a face point; in the cell.
  Vec3 position(CellVertex v) const {
    return v < kFirstFaceVertex
               ? position_[v]
               : Vec3(faces[std::size_t((v - kFirstFaceVertex) / 8)]->point - corner);
  }

  // visit(edge, next edge, is it crossed?) for the skin's lines in the cell, whatever was cut.
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

  // visit(place) for each point where the blade meets skin loop l, each face's once.
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
