#include "operation/blood/vessel_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/elementary.h"

namespace resect {
namespace {

constexpr double kClipped = 1.3e-3, kShrivelled = 1.6e-3;  // m: a pinch reaches so far to each side
constexpr double kFlat = 0.78;  // a clip takes this share of a vessel's thickness

struct Ring {
  Vec3 centre, rest;  // world and rest space, m
  Vec3 u, v, restU, restV;
  double alongU = 0, alongV = 0;  // radii, m
  float look = 0;
};

double smooth(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

int sidesOf(const VesselWall& wall) { return wall.outside > 0.8e-3 ? 12 : 8; }

std::array<double, 2> around(int side, int sides) {
  const double angle = 2 * std::numbers::pi * (side + 0.5) / sides;
  return {math::cos(angle), math::sin(angle)};
}

// Makes a mesh ring by ring. Its normals are the means over the triangles that share a vertex, so a
// ring that is added twice is a sharp edge.
struct WallMaker {
  SurfaceCopy& mesh;
  int sides;
  std::size_t firstPoint, firstTriangle;

  std::int32_t add(const Ring& ring) {
    const auto first = std::int32_t(mesh.points.size());
    for (int i = 0; i < sides; ++i) {
      const auto [x, y] = around(i, sides);
      push(ring.centre + ring.alongU * x * ring.u + ring.alongV * y * ring.v,
           ring.rest + ring.alongU * x * ring.restU + ring.alongV * y * ring.restV, ring.look);
    }
    return first;
  }
  void push(const Vec3& place, const Vec3& rest, float look) {
    mesh.points.push_back(place.cast<float>());
    mesh.rest.push_back(rest.cast<float>());
    mesh.cut.push_back(look);
  }
  // The band between two rings, from `low` to `high` along the vessel, seen from outside.
  void join(std::int32_t low, std::int32_t high) {
    for (int i = 0; i < sides; ++i) {
      const int next = (i + 1) % sides;
      mesh.triangles.push_back({low + i, low + next, high + i});
      mesh.triangles.push_back({low + next, high + next, high + i});
    }
  }
  // Closes a ring with a point. up: whether the point lies beyond the ring along the vessel.
  void close(std::int32_t ring, const Vec3& place, const Vec3& rest, float look, bool up) {
    const auto pole = std::int32_t(mesh.points.size());
    push(place, rest, look);
    for (int i = 0; i < sides; ++i) {
      const int next = (i + 1) % sides;
      mesh.triangles.push_back({pole, ring + (up ? i : next), ring + (up ? next : i)});
    }
  }
  void finish() {
    mesh.normals.resize(mesh.points.size(), Vec3f::Zero());
    for (std::size_t t = firstTriangle; t < mesh.triangles.size(); ++t) {
      const Triangle& corners = mesh.triangles[t];
      const auto at = [&](int c) -> const Vec3f& {
        return mesh.points[std::size_t(corners[std::size_t(c)])];
      };
      const Vec3f area = (at(1) - at(0)).cross(at(2) - at(0));
      for (const std::int32_t v : corners) mesh.normals[std::size_t(v)] += area;
    }
    for (std::size_t v = firstPoint; v < mesh.points.size(); ++v)
      mesh.normals[v] = mesh.normals[v].stableNormalized();
  }
};

// The ring at a fraction of the segment's length.
Ring ringAt(const VesselWall& wall, double share) {
  const double length = std::max((wall.rest.b - wall.rest.a).norm(), 1e-6), x = share * length;
  Ring ring;
  const Vec3 restAlong = wall.rest.direction(share), along = wall.present.direction(share);
  std::tie(ring.restU, ring.restV) = across(restAlong, restAlong.unitOrthogonal());
  std::tie(ring.u, ring.v) = across(along, ring.restU);
  // Thicker and thinner, to and fro, by waves of a few millimetres that begin and end at the
  // joints.
  const double phase = 977 * wall.rest.a.x() + 1213 * wall.rest.a.y() + 1409 * wall.rest.a.z();
  const double free = smooth(0, 1, 4 * share * (1 - share)), r = wall.outside;
  const double waves = 0.07 * math::sin(1900 * x + phase) + 0.05 * math::sin(3700 * x + 2 * phase);
  const double joint = std::min(2.5 * r, 0.45 * length), taper = std::min(9 * r, 0.7 * length);
  double radius =
      r + (wall.outsideA - r) * (1 - smooth(0, joint, x)) +
      (wall.outsideB - r) * (1 - smooth(0, wall.outsideB < 0.5 * r ? taper : joint, length - x));
  radius *= 1 + free * waves;
  double alongU = 1, alongV = 1, look = 0;
  for (const VesselPinch& pinch : wall.pinches) {
    const double off = (share - pinch.share) * length / (pinch.byHeat ? kShrivelled : kClipped);
    const double q = math::exp(-off * off);
    alongU *= pinch.byHeat ? 1 - 0.40 * q : 1 + 0.40 * q;
    alongV *= pinch.byHeat ? 1 - 0.40 * q : 1 - kFlat * q;
    if (pinch.byHeat) look = std::max(look, std::min(1.0, 1.4 * q));
  }
  const double reach = 1.0e-3 + 1.5 * r;  // of what happens at an end
  for (const bool first : {true, false}) {
    const WallEnd end = first ? wall.atFrom : wall.atTo;
    const double off = std::abs(share - (first ? wall.from : wall.to)) * length;
    const double near = 1 - smooth(0, reach, off);
    if (end == WallEnd::Sealed) {
      alongU *= 1 - 0.42 * near, alongV *= 1 - 0.55 * near;
      look = std::max(look, std::min(1.0, 1.5 * near));
    } else if (end == WallEnd::Open) {  // a thin wall falls in
      alongV *= 1 - (wall.kind == VesselKind::HepaticVein ? 0.45 : 0.12) * near;
    }
  }
  const double sway = 0.10 * r * free;
  const double swayU = sway * math::sin(1300 * x + phase),
               swayV = sway * math::cos(1700 * x - phase);
  ring.centre = wall.present.at(share) + swayU * ring.u + swayV * ring.v;
  ring.rest = wall.rest.at(share) + swayU * ring.restU + swayV * ring.restV;
  ring.alongU = alongU * radius, ring.alongV = alongV * radius;
  ring.look = float(look);
  return ring;
}

// The same ring, moved along the vessel and made smaller.
Ring moved(Ring ring, const Vec3& by, const Vec3& restBy, double size, float look) {
  ring.centre += by, ring.rest += restBy;
  ring.alongU *= size, ring.alongV *= size;
  ring.look = look;
  return ring;
}

// The places of the rings: evenly, and closer where the wall is pinched or ends.
std::vector<double> sharesOf(const VesselWall& wall) {
  const double length = std::max((wall.rest.b - wall.rest.a).norm(), 1e-6);
  const double step = std::max(1.1e-3, 0.9 * wall.outside);
  const int count = std::clamp(int(std::ceil((wall.to - wall.from) * length / step)), 2, 24);
  std::vector<double> shares;
  for (int i = 0; i <= count; ++i)
    shares.push_back(wall.from + (wall.to - wall.from) * double(i) / count);
  const auto add = [&](double share) {
    if (share > wall.from && share < wall.to) shares.push_back(share);
  };
  for (const VesselPinch& pinch : wall.pinches)
    for (const double off : {-1.6e-3, -0.8e-3, 0.0, 0.8e-3, 1.6e-3})
      add(pinch.share + off / length);
  if (wall.atFrom != WallEnd::Covered) add(wall.from + 0.7 * wall.outside / length);
  if (wall.atTo != WallEnd::Covered) add(wall.to - 0.7 * wall.outside / length);
  std::ranges::sort(shares);
  const auto close = [&](double a, double b) { return (b - a) * length < 0.15e-3; };
  shares.erase(std::ranges::unique(shares, close).begin(), shares.end());
  shares.back() = wall.to;
  return shares;
}

// Ends the mesh at a ring. out: the direction in which the wall ends there, +1 or -1 along the way.
void addEnd(WallMaker& maker, const VesselWall& wall, std::int32_t last, const Ring& ring,
            WallEnd end, double out) {
  const double share = out > 0 ? wall.to : wall.from;
  const Vec3 way = out * wall.present.direction(share), restWay = out * wall.rest.direction(share);
  const float kind = kLookOfKind * float(wall.kind);
  const double deep = std::min(ring.alongU, ring.alongV);
  const auto band = [&](std::int32_t from, std::int32_t to) {
    out > 0 ? maker.join(from, to) : maker.join(to, from);
  };
  const auto at = [&](double off, double size, float look) {
    return moved(ring, off * way, off * restWay, size, look);
  };
  if (end != WallEnd::Open) {  // half a ball
    for (const auto& [off, size] : {std::array{0.5, 0.84}, std::array{0.80, 0.45}}) {
      const std::int32_t next = maker.add(at(off * deep, size, ring.look));
      band(last, next);
      last = next;
    }
    const double pole = (end == WallEnd::Sealed ? 0.7 : 0.95) * deep;
    return maker.close(last, ring.centre + pole * way, ring.rest + pole * restWay, ring.look,
                       out > 0);
  }
  const double inner = std::clamp(wall.lumen / wall.outside, 0.45, 0.92);
  const std::int32_t edge = maker.add(at(0, 1, kind + kLookInside)),
                     rim = maker.add(at(0.10 * deep, 0.5 * (1 + inner), kind + kLookInside)),
                     mouth = maker.add(at(0, inner, kind + kLookInside)),
                     depth = maker.add(at(-1.3 * deep, 0.85 * inner, kind + kLookInside + 1));
  band(last, edge);  // without width: the edge is sharp
  band(edge, rim), band(rim, mouth), band(mouth, depth);
  maker.close(depth, ring.centre - 1.4 * deep * way, ring.rest - 1.4 * deep * restWay,
              kind + kLookInside + 1, out > 0);
}

}  // namespace

Vec3 SmoothWay::at(double t) const {
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * slopeA + (3 * t2 - 2 * t3) * b +
         (t3 - t2) * slopeB;
}

Vec3 SmoothWay::direction(double t) const {
  const Vec3 slope =
      6 * (t * t - t) * (a - b) + (3 * t * t - 4 * t + 1) * slopeA + (3 * t * t - 2 * t) * slopeB;
  return slope.norm() > 1e-9 ? slope.normalized() : Vec3(Vec3::UnitX());
}

std::pair<Vec3, Vec3> across(const Vec3& way, const Vec3& like) {
  const Vec3 along = way.normalized(), near = like - like.dot(along) * along;
  const Vec3 u = near.norm() > 0.1 * like.norm() ? near.normalized() : along.unitOrthogonal();
  return {u, along.cross(u)};
}

void addWall(SurfaceCopy& mesh, const VesselWall& wall) {
  const double length = (wall.present.b - wall.present.a).norm();
  if (length < 1e-5 || (wall.to - wall.from) * length < 1e-5) return;
  WallMaker maker{mesh, sidesOf(wall), mesh.points.size(), mesh.triangles.size()};
  const float kind = kLookOfKind * float(wall.kind);
  const std::vector<double> shares = sharesOf(wall);
  Ring first;
  std::int32_t firstRing = 0, last = 0;
  Ring ring;
  for (const double share : shares) {
    ring = ringAt(wall, share);
    ring.look += kind;
    const std::int32_t here = maker.add(ring);
    if (share == shares.front())
      first = ring, firstRing = here;
    else
      maker.join(last, here);
    last = here;
  }
  addEnd(maker, wall, firstRing, first, wall.atFrom, -1);
  addEnd(maker, wall, last, ring, wall.atTo, 1);
  maker.finish();
}

void addClip(TriangleMesh& mesh, std::vector<Vec3f>& normals, const Vec3& middle, const Vec3& along,
             const Vec3& u, double outside) {
  constexpr double kWide = 0.5e-3, kThick = 0.28e-3;  // m: half a wire's width and thickness
  // Points of half the wire, from the tip of a leg to the bend; the other half is its mirror image.
  const Vec3 v = along.cross(u).normalized();
  const double half = 1.5 * outside + 1.0e-3, gap = (1 - kFlat) * outside + kThick;
  const double bend = -half + gap;
  std::vector<std::array<double, 2>> path = {
      {half, 0.55 * gap}, {0.5 * half, 0.90 * gap}, {0, 1.06 * gap}, {bend, gap}};
  for (const double angle : {30.0, 60.0}) {
    const double a = angle * std::numbers::pi / 180;
    path.push_back({bend - gap * math::sin(a), gap * math::cos(a)});
  }
  path.push_back({bend - gap, 0});
  for (int i = int(path.size()) - 2; i >= 0; --i)
    path.push_back({path[std::size_t(i)][0], -path[std::size_t(i)][1]});
  // A rounded rectangle: place and normal, in the wire's width and thickness.
  constexpr double kSection[8][4] = {{1, 0.5, 0.95, 0.3},     {0.7, 1, 0.3, 0.95},
                                     {-0.7, 1, -0.3, 0.95},   {-1, 0.5, -0.95, 0.3},
                                     {-1, -0.5, -0.95, -0.3}, {-0.7, -1, -0.3, -0.95},
                                     {0.7, -1, 0.3, -0.95},   {1, -0.5, 0.95, -0.3}};
  const auto first = std::int32_t(mesh.points.size());
  const auto count = int(path.size());
  const auto placeOf = [&](int i) -> Vec3 {
    const auto& [x, y] = path[std::size_t(i)];
    return middle + x * u + y * v;
  };
  const auto push = [&](const Vec3& place, const Vec3& normal) {
    mesh.points.push_back(place);
    normals.push_back(normal.normalized().cast<float>());
  };
  for (int i = 0; i < count; ++i) {
    const Vec3 way =
        (placeOf(std::min(i + 1, count - 1)) - placeOf(std::max(i - 1, 0))).normalized();
    const Vec3 side = way.cross(along);
    for (const auto& s : kSection)
      push(placeOf(i) + s[0] * kWide * along + s[1] * kThick * side, s[2] * along + s[3] * side);
  }
  for (int i = 0; i + 1 < count; ++i)
    for (int k = 0; k < 8; ++k) {
      const std::int32_t low = first + 8 * i, next = (k + 1) % 8;
      mesh.triangles.push_back({low + k, low + next, low + 8 + k});
      mesh.triangles.push_back({low + next, low + 8 + next, low + 8 + k});
    }
  for (const int end : {0, count - 1}) {
    const Vec3 out = (placeOf(end) - placeOf(end == 0 ? 1 : count - 2)).normalized();
    const auto pole = std::int32_t(mesh.points.size());
    push(placeOf(end) + 0.8 * kThick * out, out);
    for (int k = 0; k < 8; ++k) {
      const std::int32_t a = first + 8 * end + k, b = first + 8 * end + (k + 1) % 8;
      if (end == 0)
        mesh.triangles.push_back({pole, b, a});
      else
        mesh.triangles.push_back({pole, a, b});
    }
  }
}

}  // namespace resect
