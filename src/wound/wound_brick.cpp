#include "wound/wound_brick.h"

#include <algorithm>

#include "isosurface/brick_look.h"
#include "wound/brick_window.h"

namespace resect {
namespace {

constexpr std::array<std::uint64_t, 3> kNone{};

class BrickCutter {
 public:
  BrickCutter(const ColourField& field, const Wound& wound, const Vec3i& brick, float iso,
              BrickWound& out)
      : field_(field),
        wound_(wound),
        brick_(brick),
        window_(field, wound.severed, brick, iso),
        out_(out),
        edited_(field.cellsEdited(field.brickIndex(brick))),
        binder_(window_.grid, field.lattice(), field.refine(), wound.particles) {
    faceAt_.fill(-1);
  }

  void run(const BrickSigns& signs) {
    const auto edges = out_.edges, faces = out_.faces, skinFaces = out_.skinFaces;
    const auto cells = out_.cells;
    firstOfFace_.swap(out_.firstOfFace);
    make(signs);
    out_.looksFar = mixed_ || binder_.lookedFar();
    out_.renumbered = edges != out_.edges || faces != out_.faces || skinFaces != out_.skinFaces ||
                      (cells == 0) != (out_.cells == 0) || firstOfFace_ != out_.firstOfFace;
  }

 private:
  void make(const BrickSigns& signs) {
    out_.cells = 0;
    out_.edges = out_.faces = out_.skinFaces = kNone;
    out_.firstOfFace.clear();
    out_.vertices.clear();
    out_.triangles.clear();
    out_.bindings.clear();
    out_.anchors.clear();
    out_.unbalanced = 0;
    findCells();
    bindIsoVertices(signs);
    if (out_.cells == 0) return;
    faceLines_.reserve(4 * std::size_t(std::popcount(out_.cells)));
    addEdgeVertices();
    addFaceVertices();
    for (std::uint64_t rest = out_.cells; rest != 0; rest &= rest - 1)
      addCell(std::countr_zero(rest));
  }

  static Vec3i local(int node) { return {node & 3, node >> 2 & 3, node >> 4}; }
  static int index(const Vec3i& n) { return BrickWindow::index(n); }
  static Vec3i inWindow(const Vec3i& n) { return n + Vec3i::Constant(BrickWindow::kHalo); }
  const CutGrid& grid() const { return window_.grid; }

  void findCells() {
    for (std::uint64_t rest = severedCells(); rest != 0; rest &= rest - 1) {
      const int cell = std::countr_zero(rest);
      const Vec3i n = local(cell);
      mixed_ = mixed_ || !allInside(index(n));
      if (!isCutCell(grid(), index(n))) continue;
      out_.cells |= std::uint64_t(1) << cell;
      for (int a = 0; a < 3; ++a)
        if (cutsTissue(grid(), index(n), a)) out_.edges[std::size_t(a)] |= std::uint64_t(1) << cell;
    }
  }

  // The cells with a severed edge, inside tissue or not.
  std::uint64_t severedCells() const {
    std::uint64_t cells = 0;
    for (int axis = 0; axis < 3; ++axis) {
      std::array<std::uint64_t, 8> masks{};
      for (int d = 0; d < 8; ++d) {
        const Vec3i b = brick_ + Vec3i(d & 1, d >> 1 & 1, d >> 2);
        if ((b.array() < field_.brickDims().array()).all())
          masks[std::size_t(d)] = wound_.severed.mask(field_.brickIndex(b), axis);
      }
      masks = cornerMasks(masks);
      for (int corner = 0; corner < 8; ++corner)
        if (!(corner >> axis & 1)) cells |= masks[std::size_t(corner)];
    }
    return cells;
  }

  bool allInside(int i) const {
    for (int c = 0; c < 8; ++c)
      if (!grid().inside(i + (c & 1) + (c >> 1 & 1) * BrickWindow::kSide +
                         (c >> 2) * BrickWindow::kSide * BrickWindow::kSide))
        return false;
    return true;
  }

  // The lines of each face are computed once for the brick. Nodes 0 to 4.
  const FaceLines& face(const Vec3i& n, int axis) {
    std::int16_t& at = faceAt_[std::size_t(((n.z() * 5 + n.y()) * 5 + n.x()) * 3 + axis)];
    if (at < 0) {
      at = std::int16_t(faceLines_.size());
      faceLines_.push_back(faceLines(grid(), index(n), axis));
    }
    return faceLines_[std::size_t(at)];
  }

  void addEdgeVertices() {
    for (int axis = 0; axis < 3; ++axis)
      for (std::uint64_t rest = out_.edges[std::size_t(axis)]; rest != 0; rest &= rest - 1) {
        const Vec3i n = local(std::countr_zero(rest));
        const CutEdge e = cutEdge(grid(), index(n), axis);
        Vec3 p = inWindow(n).cast<double>();
        p[axis] += e.cut;
        const Vec3f up = normalOf(n, axis);
        for (const int side : {kLower, kUpper}) {
          NearbyNodes anchors =
              nearbyNode(side == kLower ? Vec3i::Zero() : Vec3i(Vec3i::Unit(axis)));
          if (e.kind == EdgeKind::Split && (side == kUpper) == e.lowerInside)
            anchors = nearbyNode(Vec3i(grid().node(e.owner) - inWindow(n)));
          const Vec3f normal = side == kLower ? up : Vec3f(-up);
          add(p, normal, 1, n, anchors, recess(normal));
        }
      }
  }

  void addFaceVertices() {
    for (int axis = 0; axis < 3; ++axis)
      for (std::uint64_t rest = out_.cells; rest != 0; rest &= rest - 1) {
        const int cell = std::countr_zero(rest);
        const Vec3i n = local(cell);
        const FaceLines lines = face(n, axis);
        if (lines.kind == FacePoint::None) continue;
        const std::uint64_t bit = std::uint64_t(1) << cell;
        out_.faces[std::size_t(axis)] |= bit;
        out_.firstOfFace.push_back(std::int16_t(out_.vertices.size()));
        const bool skin = lines.kind == FacePoint::Skin;
        if (skin) out_.skinFaces[std::size_t(axis)] |= bit;
        for (int l = 0; l < lines.count; ++l) {
          const FaceLine& line = lines.line[std::size_t(l)];
          if (!line.bent) continue;
          LipNormal lip{outwards(n, axis, line.end)};
          const Vec3f other = outwards(n, axis, line.start);
          lip.front = lip.normal.dot(other) <= -0.5f;
          if (!lip.front) lip.normal += other;
          addBoth(lines.point, lip, skin, n, line.anchors);
        }
      }
  }

  void addCell(int cell) {
    const Vec3i n = local(cell);
    std::array<const FaceLines*, 6> faces;
    for (int f = 0; f < 6; ++f) face(n + f % 2 * Vec3i::Unit(f / 2), f / 2);
    for (int f = 0; f < 6; ++f)
      faces[std::size_t(f)] = &face(n + f % 2 * Vec3i::Unit(f / 2), f / 2);
    capCell(grid(), index(n), faces, surface_);
    out_.unbalanced += surface_.unbalanced;
    std::array<std::int16_t, 64> first;
    for (std::size_t k = 0; k < surface_.points.size(); ++k) {
      const CellPoint& p = surface_.points[k];
      first[k] = std::int16_t(out_.vertices.size());
      addBoth(p.position, lipNormal(n, int(k)), p.skin, n, p.anchors);
    }
    for (const CellTriangle& t : surface_.triangles) {
      BrickWound::Triangle drawn{std::uint8_t(cell), !t.skin, {}};
      for (std::size_t c = 0; c < 3; ++c) {
        drawn.corners[c] = t.corners[c];
        if (t.corners[c] < kFirstCellVertex) continue;
        const std::size_t k = t.corners[c] - kFirstCellVertex;
        const bool twin = surface_.points[k].skin && !t.skin;
        drawn.corners[c] = std::int16_t(kFirstCellVertex + first[k] + twin);
      }
      out_.triangles.push_back(drawn);
    }
  }

  // The blade's normal at a cut edge, upwards, in rest space.
  Vec3f normalOf(const Vec3i& n, int axis) const {
    const Vec3f slope = wound_.severed.normal(grid().first + inWindow(n), axis);
    return slope.cwiseQuotient(field_.lattice().spacing.cast<float>()).normalized();
  }

  // Normal out of the tissue at an edge point of a face's ring, if it lies at a cut.
  Vec3f outwards(const Vec3i& n, int axis, int node) const {
    if (node % 3 == kIsoNode) return Vec3f::Zero();
    const RingEdge e = ringEdge(axis, node / 3);
    const Vec3f up = normalOf(n + e.offset, e.axis);
    return node % 3 == kLower ? up : Vec3f(-up);
  }
  Vec3f outwards(const Vec3i& cell, int node) const {
    if (node % 3 == kIsoNode) return Vec3f::Zero();
    const CellEdge& e = kCellEdges[std::size_t(node / 3)];
    const Vec3f up = normalOf(cell + Vec3i(e.from & 1, e.from >> 1 & 1, e.from >> 2), e.axis);
    return node % 3 == kLower ? up : Vec3f(-up);
  }

  // The normal of a vertex as part of a lip, of any length. front: the vertex lies where the two
  // lips meet, and the normal is that of one of them.
  struct LipNormal {
    Vec3f normal = Vec3f::Zero();
    bool front = false;
  };

  // Normal at a cell's own point: the mean over the lips' points that it is connected with.
  LipNormal lipNormal(const Vec3i& cell, int point) const {
    Vec3f sum = Vec3f::Zero(), any = Vec3f::Zero();
    for (const CellTriangle& t : surface_.triangles) {
      if (t.skin ||
          std::ranges::find(t.corners, CellVertex(kFirstCellVertex + point)) == t.corners.end())
        continue;
      for (const CellVertex v : t.corners)
        if (v < kFirstFaceVertex) {
          any = outwards(cell, v);
          sum += any;
        }
    }
    const bool front = !(sum.norm() > 0.1f);
    return {front ? any : sum, front};
  }

  // How far a lip's vertex is moved into its tissue (Wound::kerf). normal: unit.
  Vec3f recess(const Vec3f& normal) const { return -0.5f * wound_.kerf * normal; }

  // Adds a vertex on the organ's surface with a twin on the lip, or one on the lip alone.
  void addBoth(const Vec3& p, const LipNormal& lip, bool onSkin, const Vec3i& n,
               NearbyNodes anchors) {
    const float length = lip.normal.norm();
    const Vec3f normal = length > 0 ? Vec3f(lip.normal / length) : Vec3f(0, 1, 0);
    const Vec3f move = length > 0 && !lip.front ? recess(normal) : Vec3f(0, 0, 0);
    if (onSkin) addOnSkin(p, n, anchors, move);
    add(p, normal, 1, n, anchors, move);
    out_.vertices.back().twin = onSkin;
  }

  // p: in node spacings. move: added to the vertex's position, m.
  void add(const Vec3& p, const Vec3f& normal, float cut, const Vec3i& n, NearbyNodes anchors,
           const Vec3f& move) {
    const Vec3 where = p + grid().first.cast<double>();
    out_.vertices.push_back({field_.nodePosition(where).cast<float>() + move, normal, cut});
    bind(p, n, anchors);
  }

  void bind(const Vec3& p, const Vec3i& n, NearbyNodes anchors) {
    out_.bindings.push_back(binder_.bind(p, inWindow(n), anchors));
    Vec3i anchor = n;
    visitNearby(anchors & -anchors, [&](const Vec3i& offset) { anchor += offset; });
    out_.anchors.push_back(
        {std::int8_t(anchor.x()), std::int8_t(anchor.y()), std::int8_t(anchor.z())});
  }

  // Difference of the field along an axis at a node of the window, as in isosurface/brick_look.h.
  float growth(int i, int axis) const {
    constexpr int kStep[3] = {1, BrickWindow::kSide, BrickWindow::kSide * BrickWindow::kSide};
    constexpr float kWeight[3] = {1, 2, 1};
    const int along = kStep[axis], u = kStep[(axis + 1) % 3], v = kStep[(axis + 2) % 3];
    float sum = 0;
    for (int du = -1; du <= 1; ++du)
      for (int dv = -1; dv <= 1; ++dv) {
        const int beside = i + du * u + dv * v;
        sum += kWeight[du + 1] * kWeight[dv + 1] *
               (window_.value[std::size_t(beside + along)] -
                window_.value[std::size_t(beside - along)]);
      }
    return sum;
  }

  // Normal and cut share as on the surface round it: from the field's gradient and its original
  // value.
  void addOnSkin(const Vec3& p, const Vec3i& n, NearbyNodes anchors, const Vec3f& move) {
    Vec3f slope = Vec3f::Zero();
    float before = 0;
    bool changed = false;
    const Vec3i low = inWindow(n);
    const Vec3 place = p - low.cast<double>();
    for (int c = 0; c < 8; ++c) {
      const Vec3i corner(c & 1, c >> 1 & 1, c >> 2), at = low + corner;
      double weight = 1;
      for (int a = 0; a < 3; ++a) weight *= corner[a] ? place[a] : 1 - place[a];
      const int i = grid().index(at);
      slope += float(weight) * Vec3f(growth(i, 0), growth(i, 1), growth(i, 2));
      const Vec3i node = grid().first + at;
      if (edited_ && (node.array() < field_.nodeDims().array()).all()) {
        const float original = field_.originalNode(node);
        changed = changed || original != window_.value[std::size_t(i)];
        before += float(weight) * original;
      }
    }
    slope = slope.cwiseQuotient(field_.lattice().spacing.cast<float>());
    const float length = slope.norm();
    constexpr float kBare = 0.02f;  // from this share on, former tissue is seen and not skin
    const float cut = changed ? cutShare(before, grid().iso) : 0.f;
    add(p, length > 0 ? Vec3f(slope / -length) : Vec3f(0, 1, 0), cut < kBare ? kRimShare : cut, n,
        anchors, move);
  }

  void bindIsoVertices(const BrickSigns& signs) {
    for (int axis = 0; axis < 3; ++axis)
      for (std::uint64_t rest = signs.crossing[std::size_t(axis)]; rest != 0; rest &= rest - 1) {
        const Vec3i n = local(std::countr_zero(rest));
        const CutEdge e = cutEdge(grid(), index(n), axis);
        Vec3 p = inWindow(n).cast<double>();
        p[axis] += e.iso;
        const NearbyNodes anchors = nearbyNode(Vec3i(grid().node(e.owner) - inWindow(n)));
        bind(p, n, anchors);
      }
  }

  const ColourField& field_;
  const Wound& wound_;
  Vec3i brick_;
  BrickWindow window_;
  BrickWound& out_;
  bool edited_;
  VertexBinder binder_;
  std::array<std::int16_t, 375> faceAt_;
  std::vector<FaceLines> faceLines_;
  CellSurface surface_;
  std::vector<std::int16_t> firstOfFace_;  // of the previous result
  bool mixed_ = false;                     // some cell with a severed edge is not entirely inside
};

}  // namespace

void makeBrickWound(const ColourField& field, const Wound& wound, const Vec3i& brick,
                    const BrickSigns& signs, float iso, BrickWound& out) {
  BrickCutter(field, wound, brick, iso, out).run(signs);
}

}  // namespace resect
