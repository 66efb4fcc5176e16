// The lines in which the surface of a cut organ meets a face of the grid.
//
// The lines depend on the face alone, so the two cells beside the face have the same lines. This is
// why the surface is closed.
//
// The face's border is followed in the order of its corners. Stretches in tissue ("runs") alternate
// with gaps. A gap is a cut in an edge, which has no width, or a stretch outside the tissue. As a
// rule, a line leads from the end of a run back to the start of the same run, and so separates the
// run from the rest of the face. There is one exception: the organ's surface ("skin") may continue
// through a face that is cut (skinHolds()). Then a line leads across each gap outside the tissue,
// from the end of the run before the gap to the start of the run after the gap. For the other
// lines, these two runs then count as one run. The end of each run belongs to exactly one line, and
// so does the start of each run.
//
// In three cases lines bend at one point of the face: where three or four cuts meet, where a cut
// ends in the face, and where a cut meets the skin. Each of these lines has its own vertex at this
// point.
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
  // The line leads from the edge point `end` to the edge point `start`. The number of an edge point
  // is 3 * (number of its ring edge, see RingEdge) + EdgeNode. Seen by a viewer towards whom the
  // face's axis points, tissue lies to the left of the line.
  std::uint8_t end = 0, start = 0;
  bool bent = false;      // whether the line has a vertex at FaceLines::point
  NearbyNodes anchors{};  // of the line's vertex (wound/vertex_binding.h), around the face's node
};

struct FaceLines {
  static constexpr int kMost = 5;  // greatest number of lines of a face
  std::array<FaceLine, kMost> line;
  int count = 0;  // number of entries of `line` in use
  FacePoint kind = FacePoint::None;
  Vec3 point = Vec3::Zero();  // where lines bend, in the coordinates of the CutGrid's nodes
  int points() const {        // number of vertices at `point`
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
  int axis;      // axis along which the edge runs
};
// axis: the face's axis.
inline RingEdge ringEdge(int axis, int i) {
  const int u = nextAxis(axis), v = lastAxis(axis);
  if (i == 1) return {Vec3i::Unit(u), v};
  if (i == 2) return {Vec3i::Unit(v), u};
  return {Vec3i::Zero(), i == 0 ? u : v};
}

// Whether the organ's surface continues through the face at node i although edges of the face are
// cut. In three cases the surface does not continue, but ends at the cut:
// - A blade's trace crosses the line in which the surface meets the face.
// - An edge of the face is severed outside the tissue or just inside its surface (CutEdge::open).
//   Then the blade crosses the line in which the surface meets the face.
// - The two ends of the line in which the surface meets the face belong to two nodes
//   (CutEdge::owner). Within a small box, whole grid edges in tissue do not connect these nodes.
//   The box consists of the two cells beside the face, enlarged by one node on every side.
bool skinHolds(const CutGrid& grid, int i, int axis);

// The lines of the face at node i. holds() must return the result of skinHolds(). holds() is called
// only if the lines depend on this result. In tests, holds() may return either value, since the
// surface is closed with both values.
template <typename Holds>
FaceLines faceLines(const CutGrid& grid, int i, int axis, const Holds& holds);
FaceLines faceLines(const CutGrid& grid, int i, int axis);

// A point on a face's border.
struct RingPoint {
  int edge = -1;     // number of the ring edge; -1: there is no point
  double share = 0;  // fraction of the edge, from its lower node
};
// A shallow cut parts the skin in a face, but ends above the first edge in tissue, so the face's
// lines cannot show it. Returns where the blade's trace in the face at node i, continued straight
// into the tissue, meets the next edge. There is no such point if no trace crosses the skin in this
// face, or if an edge of the face is cut in tissue already.
RingPoint belowShallowCut(const CutGrid& grid, int i, int axis);

namespace wound {

// The face's border is called its ring. A gap in the ring leads from the edge point `end`, where a
// run ends, to the edge point `start`, where the next run starts.
struct Gap {
  std::uint8_t end = 0, start = 0;
  bool outside = false;   // true: outside the tissue; false: a cut edge
  NearbyNodes anchors{};  // nodes of the run after the gap, relative to the face's node
};
struct Ring {
  std::array<CutEdge, 4> edge;
  std::array<Gap, FaceLines::kMost> gap;
  // gaps: number of all gaps. cuts: number of gaps at cut edges. outside: number of gaps outside
  // the tissue.
  int gaps = 0, cuts = 0, outside = 0;
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
