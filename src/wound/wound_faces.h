// The lines in which the surface of a cut organ meets a face of the grid.
//
// The lines depend on the face alone, so the two cells beside it have the same lines. This is why
// the surface is closed.
//
// The face's border is followed in the order of its corners. Solid stretches ("runs") alternate
// with gaps. A gap is a cut edge, which has no width, or a stretch outside the tissue. A line leads
// from the end of a run back to the start of the same run and so cuts it off. There is one
// exception. If the organ's surface ("skin") continues through a face that is cut (skinHolds()), a
// line leads across each gap outside the tissue, from the end of the run before the gap to the
// start of the run after it. For the other lines these two runs then count as one. The end of each
// run belongs to one line, and so does its start.
//
// In three cases lines bend at one point of the face: where three or four cuts meet, where a cut
// ends in the face, and where a cut meets the skin. Each of these lines has a vertex of its own
// there.
#pragma once

#include "wound/wound_edges.h"

namespace resect {

// Kind of the point at which a face's lines bend.
enum class FacePoint : std::uint8_t {
  None,      // no line bends
  Tip,       // the cut ends here
  Junction,  // three or four cuts meet
  Skin       // the cut meets the skin
};

struct FaceLine {
  // The line leads from the edge point `end` to the edge point `start`. Each is given as 3 * number
  // of the ring edge (see RingEdge) + EdgeNode. Tissue lies to the left of the line for a viewer at
  // whom the face's axis points.
  std::uint8_t end = 0, start = 0;
  bool bent = false;      // whether the line has a vertex at the face's point
  NearbyNodes anchors{};  // of that vertex (wound/vertex_binding.h), relative to the face's node
};

struct FaceLines {
  static constexpr int kMost = 5;  // number of lines of a face
  std::array<FaceLine, kMost> line;
  int count = 0;  // number of entries of `line` in use
  FacePoint kind = FacePoint::None;
  Vec3 point = Vec3::Zero();  // where lines bend, in the coordinates of the CutGrid's nodes
  int points() const {        // number of vertices at the face's point
    int n = 0;
    for (int i = 0; i < count; ++i) n += line[std::size_t(i)].bent;
    return n;
  }
};

// Ring edge i, from 0 to 3, is the edge of a face's border from corner i to the next corner. The
// corners 0 to 3, as offsets from the face's node, are 0, u, u + v and v. u and v are the unit
// vectors along nextAxis() and lastAxis().
struct RingEdge {
  Vec3i offset;  // from the face's node to the lower node of the edge
  int axis;      // along which the edge runs
};
// axis: that of the face.
inline RingEdge ringEdge(int axis, int i) {
  const int u = nextAxis(axis), v = lastAxis(axis);
  if (i == 1) return {Vec3i::Unit(u), v};
  if (i == 2) return {Vec3i::Unit(v), u};
  return {Vec3i::Zero(), i == 0 ? u : v};
}

// Whether the organ's surface continues through the face at node i although edges of the face are
// cut. It ends at the cut in two cases:
// - An edge of the face is severed outside the tissue or just inside its surface (CutEdge::open).
//   Then the blade crosses the line of the surface in the face.
// - The nodes that own the two ends of that line (CutEdge::owner) are not joined by whole grid
//   edges in tissue within a small box: the two cells beside the face, widened by one node on every
//   side.
bool skinHolds(const CutGrid& grid, int i, int axis);

// The lines of the face at node i. holds() must return the result of skinHolds(). Tests may let it
// return either value, since the surface is closed with both. It is called only if the lines depend
// on its result.
template <typename Holds>
FaceLines faceLines(const CutGrid& grid, int i, int axis, const Holds& holds);
FaceLines faceLines(const CutGrid& grid, int i, int axis);

namespace wound {

// The ring is the face's border. A gap in it leads from the edge point `end`, where a run ends, to
// the edge point `start`, where the next run starts.
struct Gap {
  std::uint8_t end = 0, start = 0;
  bool outside = false;   // true: outside the tissue; false: a cut edge
  NearbyNodes anchors{};  // nodes of the run after the gap, relative to the face's node
};
struct Ring {
  std::array<CutEdge, 4> edge;
  std::array<Gap, FaceLines::kMost> gap;
  int gaps = 0, cuts = 0, outside = 0;  // all gaps; those at cut edges; those outside the tissue
};
Ring ringOf(const CutGrid& grid, int i, int axis);
FaceLines linesOf(const CutGrid& grid, int i, int axis, const Ring& ring, bool skinHolds);

}  // namespace wound

template <typename Holds>
FaceLines faceLines(const CutGrid& grid, int i, int axis, const Holds& holds) {
  const wound::Ring ring = wound::ringOf(grid, i, axis);
  return wound::linesOf(grid, i, axis, ring, ring.cuts > 0 && ring.outside > 0 && holds());
}

}  // namespace resect
