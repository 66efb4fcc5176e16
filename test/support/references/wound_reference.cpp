#include "support/references/wound_reference.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "geometry/measures.h"
#include "geometry/topology.h"
#include "wound/wound_cells.h"

namespace resect::test {
namespace {

std::vector<int> nodesOf(const CutGrid& grid, const Vec3i& place, NearbyNodes nearby) {
  std::vector<int> nodes;
  visitNearby(nearby, [&](const Vec3i& d) { nodes.push_back(grid.index(place + d)); });
  return nodes;
}

class Mesher {
 public:
  Mesher(const CutGrid& grid, const HoldsRule& holds) : grid_(grid), holds_(holds) {}

  WoundMesh run() {
    for (int z = 0; z + 1 < grid_.dims.z(); ++z)
      for (int y = 0; y + 1 < grid_.dims.y(); ++y)
        for (int x = 0; x + 1 < grid_.dims.x(); ++x) cell({x, y, z});
    return std::move(out_);
  }

 private:
  const FaceLines& face(const Vec3i& n, int axis) {
    const int i = grid_.index(n);
    const auto [at, fresh] = faces_.try_emplace({i, axis});
    if (fresh)
      at->second = holds_ ? faceLines(grid_, i, axis, [&] { return holds_(i, axis); })
                          : faceLines(grid_, i, axis);
    return at->second;
  }
  int point(const std::array<int, 4>& name, const Vec3& p, std::vector<int> anchors) {
    const auto [at, fresh] = names_.try_emplace(name, int(out_.mesh.points.size()));
    if (fresh) {
      out_.mesh.points.push_back(p);
      out_.anchors.push_back(std::move(anchors));
      out_.tip.push_back(0);
      out_.sheet.push_back(0);
    }
    return at->second;
  }
  int nodePoint(const Vec3i& cell, int node) {
    const CellEdge& e = kCellEdges[std::size_t(node / 3)];
    const Vec3i n = cell + Vec3i(e.from & 1, e.from >> 1 & 1, e.from >> 2);
    const CutEdge cut = cutEdge(grid_, grid_.index(n), e.axis);
    Vec3 p = n.cast<double>();
    p[e.axis] += node % 3 == kIsoNode ? cut.iso : cut.cut;
    const int lower = grid_.index(n), upper = grid_.index(Vec3i(n + Vec3i::Unit(e.axis)));
    int owner = node % 3 == kIsoNode ? cut.owner : node % 3 == kLower ? lower : upper;
    if (node % 3 != kIsoNode && cut.kind == EdgeKind::Split &&
        (node % 3 == kUpper) == cut.lowerInside)
      owner = cut.owner;
    const int made = point({lower, e.axis, node % 3, 0}, p, {owner});
    out_.sheet[std::size_t(made)] = node % 3 != kIsoNode;
    return made;
  }
  int facePoint(const Vec3i& cell, int code) {
    const int f = code / 8, number = code % 8, axis = f / 2;
    const Vec3i n = cell + f % 2 * Vec3i::Unit(axis);
    const FaceLines& lines = face(n, axis);
    int bent = 0;
    for (int l = 0; l < lines.count; ++l) {
      const FaceLine& line = lines.line[std::size_t(l)];
      if (!line.bent || bent++ != number) continue;
      const int made =
          point({grid_.index(n), axis, 3, number}, lines.point, nodesOf(grid_, n, line.anchors));
      out_.tip[std::size_t(made)] = lines.kind == FacePoint::Tip;
      return made;
    }
    return -1;
  }
  void cell(const Vec3i& n) {
    const int i = grid_.index(n);
    if (!isCutCell(grid_, i)) {
      int kind = 0;
      for (int c = 0; c < 8; ++c)
        kind |= int(grid_.inside(grid_.index(n + Vec3i(c & 1, c >> 1 & 1, c >> 2)))) << c;
      const CellTriangles& drawn = marchingCubesTable()[std::size_t(kind)];
      for (int t = 0; t < drawn.count; ++t) {
        Triangle triangle;
        for (std::size_t v = 0; v < 3; ++v)
          triangle[v] = nodePoint(n, 3 * drawn.edges[std::size_t(t)][v] + kIsoNode);
        out_.mesh.triangles.push_back(triangle);
        out_.onLip.push_back(0);
      }
      return;
    }
    ++out_.cutCells;
    std::array<FaceLines, 6> lines;
    std::array<const FaceLines*, 6> faces;
    for (int f = 0; f < 6; ++f) {
      lines[std::size_t(f)] = face(n + f % 2 * Vec3i::Unit(f / 2), f / 2);
      faces[std::size_t(f)] = &lines[std::size_t(f)];
    }
    capCell(grid_, i, faces, surface_);
    out_.unbalanced += surface_.unbalanced;
    for (const CellTriangle& t : surface_.triangles) {
      Triangle triangle;
      for (std::size_t v = 0; v < 3; ++v) {
        const int code = t.corners[v];
        if (code < kFirstFaceVertex) {
          triangle[v] = nodePoint(n, code);
        } else if (code < kFirstCellVertex) {
          triangle[v] = facePoint(n, code - kFirstFaceVertex);
        } else {
          const CellPoint& p = surface_.points[std::size_t(code - kFirstCellVertex)];
          triangle[v] =
              point({i, 3, 0, code - kFirstCellVertex}, p.position, nodesOf(grid_, n, p.anchors));
        }
      }
      out_.mesh.triangles.push_back(triangle);
      out_.onLip.push_back(!t.skin);
    }
  }

  const CutGrid& grid_;
  const HoldsRule& holds_;
  WoundMesh out_;
  std::map<std::pair<int, int>, FaceLines> faces_;
  std::map<std::array<int, 4>, int> names_;
  CellSurface surface_;
};

}  // namespace

GridOrgan::GridOrgan(const Vec3i& size) : dims(size) {
  value.assign(std::size_t(dims.prod()), 0.f);
  for (auto& along : severed) along.assign(value.size(), kWhole);
}

CutGrid GridOrgan::view(const SeveredEdges* wound) const {
  return {Vec3i::Zero(),
          dims,
          iso,
          value.data(),
          {severed[0].data(), severed[1].data(), severed[2].data()},
          wound};
}

void GridOrgan::fill(const std::function<double(const Vec3i&)>& at) {
  for (int i = 0; i < dims.prod(); ++i) {
    const Vec3i n = view().node(i);
    const bool border = (n.array() < 2).any() || (n.array() > dims.array() - 3).any();
    value[std::size_t(i)] = border ? 0.f : float(std::clamp(at(n), 0.0, 100.0));
  }
}

void GridOrgan::take(const SeveredEdges& wound) {
  for (int i = 0; i < dims.prod(); ++i)
    for (int a = 0; a < 3; ++a)
      severed[std::size_t(a)][std::size_t(i)] = wound.at(view().node(i), a);
}

WoundMesh woundMesh(const CutGrid& grid, const HoldsRule& holds) {
  return Mesher(grid, holds).run();
}

TriangleMesh tableMesh(const CutGrid& grid) {
  const std::vector<float> whole(std::size_t(grid.dims.prod()), kWhole);
  CutGrid uncut = grid;
  uncut.severed = {whole.data(), whole.data(), whole.data()};
  return woundMesh(uncut).mesh;
}

std::string wrongWith(const TriangleMesh& mesh) {
  std::vector<std::pair<std::int32_t, std::int32_t>> edges, opposite;
  std::vector<std::vector<std::pair<std::int32_t, std::int32_t>>> links(mesh.points.size());
  for (const Triangle& t : mesh.triangles)
    for (std::size_t v = 0; v < 3; ++v) {
      edges.emplace_back(t[v], t[(v + 1) % 3]);
      opposite.emplace_back(t[(v + 1) % 3], t[v]);
      links[std::size_t(t[v])].emplace_back(t[(v + 1) % 3], t[(v + 2) % 3]);
      if (t[v] == t[(v + 1) % 3]) return "a triangle uses a point twice";
    }
  std::sort(edges.begin(), edges.end());
  std::sort(opposite.begin(), opposite.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
    return "a directed edge occurs twice";
  if (edges != opposite) return "an edge has no opposite";
  for (auto& link : links) {  // each point follows one other, so the link is rings: is it one?
    if (link.empty()) continue;
    std::sort(link.begin(), link.end());
    std::size_t steps = 0;
    std::int32_t p = link[0].first;
    do {
      const auto at = std::lower_bound(link.begin(), link.end(), std::pair(p, std::int32_t(0)));
      p = at->second;
      ++steps;
    } while (p != link[0].first);
    if (steps != link.size()) return "the triangles round a point form more than one ring";
  }
  for (const Vec3& p : mesh.points)
    if (!p.allFinite()) return "a point is not a number";
  return {};
}

std::vector<int> tissuePieces(const CutGrid& grid, int* count) {
  std::vector<int> piece(std::size_t(grid.dims.prod()), -1), stack;
  int pieces = 0;
  for (int first = 0; first < grid.dims.prod(); ++first) {
    if (!grid.inside(first) || piece[std::size_t(first)] >= 0) continue;
    piece[std::size_t(first)] = pieces;
    stack.push_back(first);
    while (!stack.empty()) {
      const int i = stack.back();
      stack.pop_back();
      const Vec3i n = grid.node(i);
      const auto visit = [&](int j) {
        if (!grid.inside(j) || piece[std::size_t(j)] >= 0) return;
        piece[std::size_t(j)] = pieces;
        stack.push_back(j);
      };
      for (int a = 0; a < 3; ++a) {
        if (n[a] + 1 < grid.dims[a] && grid.whole(i, a)) visit(i + grid.stride(a));
        if (n[a] > 0 && grid.whole(i - grid.stride(a), a)) visit(i - grid.stride(a));
      }
    }
    ++pieces;
  }
  if (count) *count = pieces;
  return piece;
}

namespace {

// Per component of the surface: the least and greatest piece of tissue that its points go with.
std::vector<std::pair<int, int>> piecesOfComponents(const WoundMesh& surface, const CutGrid& grid,
                                                    const std::vector<std::int32_t>& component,
                                                    int count) {
  const std::vector<int> piece = tissuePieces(grid);
  std::vector<std::pair<int, int>> range(std::size_t(count), {1 << 30, -1});
  for (std::size_t p = 0; p < component.size(); ++p) {
    if (component[p] < 0) continue;
    auto& [least, most] = range[std::size_t(component[p])];
    for (const int node : surface.anchors[p]) {
      least = std::min(least, piece[std::size_t(node)]);
      most = std::max(most, piece[std::size_t(node)]);
    }
  }
  return range;
}

}  // namespace

int bridges(const WoundMesh& surface, const CutGrid& grid) {
  int count = 0, bad = 0;
  const auto component = pointComponents(surface.mesh, &count);
  for (const auto& [least, most] : piecesOfComponents(surface, grid, component, count))
    bad += least != most || least < 0;
  return bad;
}

std::vector<double> pieceVolumes(const WoundMesh& surface, const CutGrid& grid, double least) {
  int count = 0;
  const auto component = pointComponents(surface.mesh, &count);
  const auto pieces = piecesOfComponents(surface, grid, component, count);
  std::map<int, double> sum;
  for (const Triangle& t : surface.mesh.triangles) {
    const auto& p = surface.mesh.points;
    TriangleMesh one{{p[std::size_t(t[0])], p[std::size_t(t[1])], p[std::size_t(t[2])]},
                     {{0, 1, 2}}};
    sum[pieces[std::size_t(component[std::size_t(t[0])])].first] += volume(one);
  }
  std::vector<double> volumes;
  for (const auto& [piece, v] : sum)
    if (v >= least) volumes.push_back(v);
  std::sort(volumes.begin(), volumes.end());
  return volumes;
}

}  // namespace resect::test
