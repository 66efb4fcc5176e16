#include "wound/wound_cells.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace resect {
namespace {

constexpr double kFarSlide = 0.35;  // most that the skin's apex is moved from its first position
constexpr double kLeastArea = 0.2;  // twice the area, of a lip that may correct the volume
constexpr double kWildSlide = 2;    // the same in degenerate cells, to keep their volume
constexpr double kFarthestSlide = 0.6;  // from the middle of its loop, second attempt

// Work on one cell while it is capped.
class Cap {
 public:
  Cap(const CutGrid& grid, CellLoops& cell, CellSurface& out)
      : grid_(grid), cell_(cell), out_(out) {}

  void run() {
    for (int l = 0; l < cell_.skins; ++l)
      if (cell_.touched[std::size_t(l)])
        placeSkinApex(l);
      else
        drawTable(l);
    placeInnerApex();
    for (std::size_t loop = 0; loop < cell_.loopEnds.size(); ++loop) drawLoop(loop);
    out_.unbalanced = missing_ != 0;
  }

 private:
  Vec3 position(CellVertex v) const {
    return v < kFirstCellVertex
               ? cell_.position(v)
               : Vec3(out_.points[std::size_t(v - kFirstCellVertex)].position - cell_.corner);
  }

  void drawTableTriangle(int t) {
    const auto& e = cell_.table->edges[std::size_t(t)];
    out_.triangles.push_back({{CellVertex(3 * e[0] + kIsoNode), CellVertex(3 * e[1] + kIsoNode),
                               CellVertex(3 * e[2] + kIsoNode)},
                              true});
  }
  void drawTable(int l) {
    for (int t = 0; t < cell_.table->count; ++t)
      if (cell_.skinOf[cell_.table->edges[std::size_t(t)][0]] == l) drawTableTriangle(t);
  }

  // Volume and area of the table's triangles of a skin loop, and the middle of its points.
  struct SkinMeasure {
    double volume = 0;  // six times
    Vec3 twiceArea = Vec3::Zero();
    Vec3 middle = Vec3::Zero();
    // Six times the volume of the fan round y is y . twiceArea. Returns the displacement of y along
    // d that gives the right volume.
    Vec3 slide(const Vec3& y, const Vec3& d) const {
      return d * ((volume - y.dot(twiceArea)) / std::max(d.dot(twiceArea), 1e-300));
    }
  };
  SkinMeasure measureSkin(int l) const {
    SkinMeasure m;
    for (int t = 0; t < cell_.table->count; ++t) {
      const auto& e = cell_.table->edges[std::size_t(t)];
      if (cell_.skinOf[e[0]] != l || peeledTriangle_[std::size_t(t)]) continue;
      const Vec3 a = position(CellVertex(3 * e[0] + kIsoNode)),
                 b = position(CellVertex(3 * e[1] + kIsoNode)),
                 c = position(CellVertex(3 * e[2] + kIsoNode));
      m.volume += a.dot(b.cross(c));
      m.twiceArea += (b - a).cross(c - a);
    }
    int nodes = 0;
    for (int e = 0; e < 12; ++e)
      if (cell_.skinOf[std::size_t(e)] == l && !peeled_[std::size_t(e)]) {
        m.middle += position(CellVertex(3 * e + kIsoNode));
        ++nodes;
      }
    m.middle /= nodes;
    return m;
  }

  // Places the apex of skin loop l: where the blade meets the surface, then moved so that its fan
  // has the volume of the table's triangles.
  void placeSkinApex(int l) {
    SkinMeasure m = measureSkin(l);
    Vec3 apex = Vec3::Zero();
    int skinPoints = 0;
    cell_.visitSkinPoints(l, [&](const Vec3& p) {
      apex += p;
      ++skinPoints;
    });
    apex /= skinPoints;
    skinPoints_ += skinPoints;
    if (skinPoints == 1) {  // the incision ends in this cell: as far along the surface as the blade
      Vec3 along = tips() > 0 ? Vec3(tipMiddle() - apex) : Vec3(m.middle - apex);
      const Vec3 normal = m.twiceArea.normalized();
      along -= normal * normal.dot(along);
      const double most = (m.middle - apex).norm();
      if (along.norm() > most) along *= most / along.norm();
      apex += along;
      needsSkinApex_ = true;
    }
    const Vec3 across = bladeNormal();  // stay in the blade's plane if possible
    Vec3 direction = m.twiceArea - across * across.dot(m.twiceArea);
    if (direction.dot(m.twiceArea) < 0.25 * m.twiceArea.squaredNorm()) direction = m.twiceArea;
    Vec3 moved = m.slide(apex, direction);
    const auto far = [&](double most) { return !(moved.norm() <= most); };
    if (far(kFarSlide)) {
      apex = m.middle;
      moved = m.slide(apex, m.twiceArea);
    }
    if (far(kFarthestSlide) && peel(l)) {
      m = measureSkin(l);
      apex = m.middle;
      moved = m.slide(apex, m.twiceArea);
    }
    if (far(kWildSlide)) {
      moved = moved.norm() < 1e300 ? Vec3(moved * (kWildSlide / moved.norm())) : Vec3::Zero();
      unevenLips_ = true;
      missing_ += m.volume - (apex + moved).dot(m.twiceArea);
    }
    skinApex_[std::size_t(l)] = apex + moved;
  }

  // Cuts off those corners of skin loop l that no cut touches, by triangles of the table: the
  // remaining loop is shorter and flatter. Returns whether there was any.
  bool peel(int l) {
    std::array<std::int8_t, 12> next;
    std::array<bool, 12> cut{};  // whether a cut crosses the line to the next
    next.fill(-1);
    cell_.visitSkinLines([&](int from, int to, bool crossed) {
      next[std::size_t(from)] = std::int8_t(to);
      cut[std::size_t(from)] = crossed;
    });
    bool any = false;
    for (int t = 0; t < cell_.table->count; ++t) {
      const auto& edges = cell_.table->edges[std::size_t(t)];
      if (cell_.skinOf[edges[0]] != l || peeledTriangle_[std::size_t(t)]) continue;
      for (std::size_t v = 0; v < 3; ++v) {
        const std::size_t a = edges[v], b = edges[(v + 1) % 3], c = edges[(v + 2) % 3];
        if (next[a] != int(b) || next[b] != int(c) || next[c] == int(a) || cut[a] || cut[b])
          continue;
        peeled_[b] = peeledTriangle_[std::size_t(t)] = any = true;
        next[a] = std::int8_t(c);
        drawTableTriangle(t);
        t = -1;  // others may have become removable
        break;
      }
    }
    return any;
  }

  template <typename Visit>
  void visitFaces(Visit visit) const {
    for (int face = 0; face < 6; ++face)
      if (const FacePoint kind = cell_.faces[std::size_t(face)]->kind; kind != FacePoint::None)
        visit(kind, position(faceVertex(face, 0)));
  }
  int tips() const {
    int n = 0;
    visitFaces([&](FacePoint kind, const Vec3&) { n += kind == FacePoint::Tip; });
    return n;
  }
  Vec3 tipMiddle() const {
    Vec3 sum = Vec3::Zero();
    visitFaces([&](FacePoint kind, const Vec3& p) {
      if (kind == FacePoint::Tip) sum += p;
    });
    return sum / tips();
  }

  // Unit normal of the blade in the cell, of either sign; zero if unknown.
  Vec3 bladeNormal() const {
    Vec3 sum = Vec3::Zero();
    if (grid_.wound)
      for (int e = 0; e < 12; ++e) {
        const CellEdge& edge = kCellEdges[std::size_t(e)];
        const Vec3i lower = cell_.node + Vec3i(edge.from & 1, edge.from >> 1 & 1, edge.from >> 2);
        if (grid_.whole(grid_.index(lower), edge.axis)) continue;
        const Vec3 n = grid_.wound->normal(grid_.first + lower, edge.axis).cast<double>();
        sum += n.dot(sum) < 0 ? Vec3(-n) : n;
      }
    const double length = sum.norm();
    return length > 0 ? Vec3(sum / length) : Vec3::Zero();
  }

  void placeInnerApex() {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    const auto add = [&](const Vec3& p) {
      sum += p;
      ++count;
    };
    visitFaces([&](FacePoint kind, const Vec3& p) {
      inner_ = inner_ || kind != FacePoint::Skin;
      any_ = true;
      if (kind != FacePoint::Skin) add(p);
    });
    if (inner_ && needsSkinApex_)
      for (int l = 0; l < cell_.skins; ++l)
        if (cell_.touched[std::size_t(l)]) add(skinApex_[std::size_t(l)]);
    if (count == 0) {
      std::array<bool, 12> seen{};
      for (const CellLoops::Vertex& v : cell_.loop)
        if (v.vertex < kFirstFaceVertex && !v.iso && !seen[v.vertex / 3]) {
          seen[v.vertex / 3] = true;
          add(position(v.vertex));
        }
      visitFaces([&](FacePoint kind, const Vec3& p) {
        if (kind == FacePoint::Skin) add(p);
      });
    }
    innerApex_ = sum / std::max(count, 1);
  }

  CellVertex addPoint(const Vec3& p, NearbyNodes anchors, bool skin) {
    out_.points.push_back({p + cell_.corner, anchors, skin});
    return CellVertex(kFirstCellVertex + out_.points.size() - 1);
  }

  // Caps loop number `which`: first its skin parts, each replaced by its apex; then the rest.
  void drawLoop(std::size_t which) {
    const std::size_t begin = which == 0 ? 0 : cell_.loopEnds[which - 1],
                      end = cell_.loopEnds[which];
    const std::size_t size = end - begin;
    const auto at = [&](std::size_t k) -> const CellLoops::Vertex& {
      return cell_.loop[begin + k % size];
    };
    std::size_t first = 0;  // not within a skin part
    while (first < size && at(first).iso) ++first;
    rest_.clear();
    NearbyNodes all = 0;
    int stretches = 0;
    std::size_t lastApex = 0;
    for (std::size_t k = first; k < first + size; ++k) {
      all |= at(k).anchors;
      if (!at(k).iso) {
        rest_.push_back(at(k).vertex);
        continue;
      }
      const bool opens = !at(k + size - 1).iso;
      if (opens) {
        NearbyNodes anchors = 0;
        for (std::size_t j = k; at(j).iso; ++j) anchors |= at(j).anchors;
        const int l = cell_.skinOf[at(k).vertex / 3];
        lastApex = rest_.size();
        rest_.push_back(addPoint(skinApex_[std::size_t(l)], anchors, true));
        ++stretches;
        out_.triangles.push_back({{rest_.back(), at(k + size - 1).vertex, at(k).vertex}, true});
      }
      if (at(k).iso && peeled_[at(k).vertex / 3]) continue;
      std::size_t next = k + 1;
      while (at(next).iso && peeled_[at(next).vertex / 3]) ++next;
      out_.triangles.push_back({{rest_[lastApex], at(k).vertex, at(next).vertex}, true});
    }
    // A plain cut through the cell needs no apex: its two lips are the same polygon.
    if (plainSheet()) {
      const auto least = std::min_element(rest_.begin(), rest_.end(),
                                          [](CellVertex a, CellVertex b) { return a / 3 < b / 3; });
      fan(std::size_t(least - rest_.begin()), rest_.size() - 1);
    } else if (stretches == 1 && onlySkinApex()) {
      fan(lastApex, rest_.size() - 1);
    } else {
      const CellVertex x = addPoint(innerApex_ + makeUp(), all, false);
      for (std::size_t k = 0; k < rest_.size(); ++k)
        out_.triangles.push_back({{x, rest_[k], rest_[(k + 1) % rest_.size()]}, false});
    }
  }

  // The displacement of one lip's apex that makes up for volume which the skin's apexes could not.
  // Occurs with random cuts only.
  Vec3 makeUp() {
    Vec3 twiceArea = Vec3::Zero();
    if (missing_ == 0) return twiceArea;
    for (std::size_t k = 0; k < rest_.size(); ++k)
      twiceArea += position(rest_[k]).cross(position(rest_[(k + 1) % rest_.size()]));
    if (twiceArea.norm() < kLeastArea) return Vec3::Zero();
    return twiceArea * (std::exchange(missing_, 0) / twiceArea.squaredNorm());
  }

  // Caps the rest with a fan round its own vertex `centre`.
  void fan(std::size_t centre, std::size_t sides) {
    for (std::size_t k = 1; k < sides; ++k)
      out_.triangles.push_back({{rest_[centre], rest_[(centre + k) % rest_.size()],
                                 rest_[(centre + k + 1) % rest_.size()]},
                                false});
  }

  // Whether there are two loops of cut points only, whose fan has no inner side in a face of the
  // cell.
  bool plainSheet() const {
    if (any_ || cell_.loopEnds.size() != 2 || cell_.loopEnds[0] * 2 != cell_.loopEnds[1])
      return false;
    std::array<std::uint8_t, 12> uses{};
    for (std::size_t k = 0; k < cell_.loop.size(); ++k) {
      if (cell_.loop[k].iso) return false;
      if (k < cell_.loopEnds[0] && uses[cell_.loop[k].vertex / 3]++ > 0) return false;
    }
    return true;
  }

  // Whether there is one skin loop, no inner point, at least two points where the cut meets the
  // surface, and each loop has one skin part: then the skin's apex serves the lips too.
  bool onlySkinApex() const {
    int loops = 0;
    for (int l = 0; l < cell_.skins; ++l) loops += cell_.touched[std::size_t(l)];
    if (loops != 1 || inner_ || skinPoints_ < 2 || unevenLips_) return false;
    std::size_t begin = 0;
    for (const std::size_t end : cell_.loopEnds) {
      int stretches = 0;
      for (std::size_t k = begin; k < end; ++k)
        stretches += cell_.loop[k].iso && !cell_.loop[k == begin ? end - 1 : k - 1].iso;
      if (stretches != 1) return false;
      begin = end;
    }
    return true;
  }

  const CutGrid& grid_;
  CellLoops& cell_;
  CellSurface& out_;
  std::array<bool, 12> peeled_{};  // per edge: cut off from its loop by a triangle of the table
  std::array<bool, 5> peeledTriangle_{};
  std::array<Vec3, 4> skinApex_;
  int skinPoints_ = 0;
  bool needsSkinApex_ = false, inner_ = false, any_ = false, unevenLips_ = false;
  Vec3 innerApex_ = Vec3::Zero();
  double missing_ = 0;  // six times the volume that the skin's apexes could not make up for
  std::vector<CellVertex>& rest_ = cell_.rest;
};

}  // namespace

bool isCutCell(const CutGrid& grid, int i) {
  for (const CellEdge& e : kCellEdges)
    if (cutsTissue(
            grid,
            i + (e.from & 1) + (e.from >> 1 & 1) * grid.stride(1) + (e.from >> 2) * grid.stride(2),
            e.axis))
      return true;
  return false;
}

void capCell(const CutGrid& grid, int i, const std::array<const FaceLines*, 6>& faces,
             CellSurface& out) {
  out.points.clear();
  out.triangles.clear();
  out.unbalanced = 0;
  out.loops.set(grid, i, faces);
  Cap(grid, out.loops, out).run();
}

}  // namespace resect
