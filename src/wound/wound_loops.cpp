#include "wound/wound_loops.h"

#include <algorithm>

namespace resect {
namespace {

using EdgeOfRing = std::array<std::array<std::uint8_t, 4>, 6>;

constexpr int edgeNumber(int axis, int corner) {
  return 4 * axis + (axis == 0   ? corner >> 1
                     : axis == 1 ? (corner & 1) | (corner >> 2) << 1
                                 : corner);
}

EdgeOfRing makeEdgeOfRing() {
  EdgeOfRing edges;
  for (int face = 0; face < 6; ++face)
    for (int r = 0; r < 4; ++r) {
      const RingEdge e = ringEdge(face / 2, r);
      const Vec3i corner = e.offset + face % 2 * Vec3i::Unit(face / 2);
      edges[std::size_t(face)][std::size_t(r)] =
          std::uint8_t(edgeNumber(e.axis, corner.x() | corner.y() << 1 | corner.z() << 2));
    }
  return edges;
}

}  // namespace

int cellEdgeOfRing(int face, int ring) {
  static const EdgeOfRing edges = makeEdgeOfRing();
  return edges[std::size_t(face)][std::size_t(ring)];
}

void CellLoops::set(const CutGrid& grid, int i, const std::array<const FaceLines*, 6>& lines) {
  node = grid.node(i);
  corner = node.cast<double>();
  faces = lines;
  loop.clear();
  loopEnds.clear();
  skins = 0;
  touched.fill(false);
  links_.fill({});
  int kind = 0;
  for (int c = 0; c < 8; ++c)
    kind |=
        int(grid.inside(i + (c & 1) + (c >> 1 & 1) * grid.stride(1) + (c >> 2) * grid.stride(2)))
        << c;
  table = &marchingCubesTable()[std::size_t(kind)];

  setNodes(grid);
  joinSkin();
  link();
  trace();
}

// Positions and anchors of the cell's edge points.
void CellLoops::setNodes(const CutGrid& grid) {
  for (int e = 0; e < 12; ++e) {
    const CellEdge& edge = kCellEdges[std::size_t(e)];
    const Vec3i lower(edge.from & 1, edge.from >> 1 & 1, edge.from >> 2);
    const CutEdge cut = cutEdge(grid, grid.index(node + lower), edge.axis);
    for (int k = 0; k < 3; ++k) {
      position_[std::size_t(3 * e + k)] = lower.cast<double>();
      position_[std::size_t(3 * e + k)][edge.axis] += k == kIsoNode ? cut.iso : cut.cut;
    }
    const Vec3i upper = lower + Vec3i::Unit(edge.axis);
    anchors_[std::size_t(3 * e + kLower)] = nearbyNode(lower);
    anchors_[std::size_t(3 * e + kUpper)] = nearbyNode(upper);
    if (cut.owner >= 0) {
      const NearbyNodes owner = nearbyNode(Vec3i(grid.node(cut.owner) - node));
      anchors_[std::size_t(3 * e + kIsoNode)] = owner;
      if (cut.kind == EdgeKind::Split)
        anchors_[std::size_t(3 * e + (cut.lowerInside ? kUpper : kLower))] = owner;
    }
  }
}

// The loops of the surface without cuts: triangles of the table that share a point belong to one
// loop.
void CellLoops::joinSkin() {
  skinOf.fill(-1);
  for (int t = 0; t < table->count; ++t) {
    int loop = -1;
    for (const int e : table->edges[std::size_t(t)])
      if (skinOf[std::size_t(e)] >= 0) {
        const int other = skinOf[std::size_t(e)];
        if (loop >= 0 && other != loop)
          std::ranges::replace(skinOf, other, loop);
        else
          loop = other;
      }
    if (loop < 0) loop = skins++;
    for (const int e : table->edges[std::size_t(t)]) skinOf[std::size_t(e)] = loop;
  }
}

// Links the lines of the faces in this cell's direction: seen from inside, solid tissue to the
// left. Lines of a lower face are seen from above, of an upper face from below.
void CellLoops::link() {
  for (int face = 0; face < 6; ++face) {
    const FaceLines& lines = *faces[std::size_t(face)];
    int bent = 0;
    for (int n = 0; n < lines.count; ++n) {
      const FaceLine& line = lines.line[std::size_t(n)];
      const auto node = [&](int code) { return 3 * cellEdgeOfRing(face, code / 3) + code % 3; };
      int from = node(line.end), to = node(line.start);
      if (face % 2 == 1) std::swap(from, to);
      Link& link = links_[std::size_t(from)];
      link.next = std::int8_t(to);
      link.anchors = face % 2 == 1 ? seenFromBelow(line.anchors, face / 2) : line.anchors;
      if (line.bent) {
        link.face = std::int8_t(face);
        link.line = std::int8_t(bent++);
      }
    }
  }
}

void CellLoops::trace() {
  std::array<bool, kCellNodes> done{};
  for (int first = 0; first < kCellNodes; ++first) {
    if (links_[std::size_t(first)].next < 0 || done[std::size_t(first)]) continue;
    const std::size_t begin = loop.size();
    bool skinOnly = true;
    int n = first;
    do {
      done[std::size_t(n)] = true;
      const Link& link = links_[std::size_t(n)];
      const bool iso = n % 3 == kIsoNode;
      loop.push_back({CellVertex(n), iso, anchors_[std::size_t(n)] | link.anchors});
      skinOnly = skinOnly && iso && link.face < 0;
      if (link.face >= 0) loop.push_back({faceVertex(link.face, link.line), false, link.anchors});
      n = link.next;
    } while (n != first);
    if (skinOnly) {
      loop.resize(begin);
      continue;
    }
    loopEnds.push_back(loop.size());
    for (std::size_t k = begin; k < loop.size(); ++k)
      if (loop[k].iso) touched[std::size_t(skinOf[loop[k].vertex / 3])] = true;
  }
}

}  // namespace resect
