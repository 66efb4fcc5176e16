// The lines in which the surface of a cut organ meets a face of the grid.
//
// The lines depend on the face alone, so both of its cells get the same ones; therefore the surface
// is closed. Along the face's border solid parts ("runs") alternate with gaps: a cut edge is a gap
// of no width, the outside is another. Every end of a run is joined by one line to one start of a
// run, so each edge point is the end of one line and the start of another. Where three or more gaps
// meet, where a cut ends in the face, and where a cut meets the organ's surface ("skin"), the lines
// pass through one point of the face, each with a vertex of its own there.
#pragma once

#include "wound/wound_edges.h"

namespace resect {

// Kind of a face's own point.
enum class FacePoint : std::uint8_t {
  None,
  Tip,       // the cut ends here
  Junction,  // three or four pieces meet
  Skin       // the cut meets the skin
};

struct FaceLine {
  // Edge points as 3 * ring edge + EdgeNode; solid tissue lies to the left, seen from above the
  // face.
  std::uint8_t end = 0, start = 0;
  bool bent = false;      // passes through the face's point, with a vertex of its own
  NearbyNodes anchors{};  // nodes of the piece of tissue of the line's vertex
};

struct FaceLines {
  static constexpr int kMost = 5;
  std::array<FaceLine, kMost> line;
  int count = 0;
  FacePoint kind = FacePoint::None;
  Vec3 point = Vec3::Zero();  // in the window
  int points() const {        // vertices of the face
    int n = 0;
    for (int i = 0; i < count; ++i) n += line[std::size_t(i)].bent;
    return n;
  }
};

// Ring edge i of a face leads from corner i to corner i + 1; corners go round as seen from above:
// 0, +u, +u +v, +v. Its lower node, as an offset, and its axis.
struct RingEdge {
  Vec3i offset;
  int axis;
};
inline RingEdge ringEdge(int axis, int i) {
  const int u = nextAxis(axis), v = lastAxis(axis);
  if (i == 1) return {Vec3i::Unit(u), v};
  if (i == 2) return {Vec3i::Unit(v), u};
  return {Vec3i::Zero(), i == 0 ? u : v};
}

// Whether the organ's surface continues through the face at node i although edges of the face are
// cut. False if the blade crosses it, or if its two ends belong to pieces that are not connected
// within the face's two cells and one node beyond.
bool skinHolds(const CutGrid& grid, int i, int axis);

// The lines of the face at node i. holds(): skinHolds() or, in tests, anything: any answer gives a
// closed surface. Called only if it matters.
template <typename Holds>
FaceLines faceLines(const CutGrid& grid, int i, int axis, const Holds& holds);
FaceLines faceLines(const CutGrid& grid, int i, int axis);

namespace wound {

// A gap in the ring: from the end of a run to the start of the next.
struct Gap {
  std::uint8_t end = 0, start = 0;
  bool outside = false;   // not a cut edge
  NearbyNodes anchors{};  // of the run that follows
};
struct Ring {
  std::array<CutEdge, 4> edge;
  std::array<Gap, FaceLines::kMost> gap;
  int gaps = 0, cuts = 0, outside = 0;  // all; cut edges; arcs outside
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
