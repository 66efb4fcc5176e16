// 07: a scalpel's edge is drawn through the liver; nothing is taken away, and the wound opens.
//
// The blade cuts the grid's edges, the surface gets two lips on each other. Each vertex near the
// wound knows the particles on its own side: here they are moved apart by a formula, as elastic
// tissue would move them, and the lips go with them. A second cut goes right through: two bodies.
// With a file name it also writes a picture: example_07_incision opened.png

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/measures.h"
#include "geometry/normals.h"
#include "geometry/resting_pose.h"
#include "geometry/topology.h"
#include "inventor/gl/SoOrganShape.h"
#include "inventor/picture/offscreen_view.h"
#include "inventor/reading/model_file.h"
#include "inventor/scene/operating_room.h"
#include "inventor/scene/operation_view.h"
#include "organ/builtin/builtin_liver.h"
#include "organ/discretize.h"
#include "organ/parts/bodies.h"

using namespace resect;

// A blade held upright and drawn along +X, slightly bent; its point goes in and comes out again.
struct Stroke {
  Vec3 begin;  // of the wound, on the skin, m
  double length = 0.09, depth = 0.024;

  double share(double x) const { return (x - begin.x()) / length; }
  double depthAt(double x) const {
    const double s = share(x);
    return s <= 0 || s >= 1 ? 0 : depth * std::sqrt(4 * s * (1 - s));
  }
  double bend(double x) const { return 0.006 * std::sin(3 * share(x)); }
};

void follow(Organ& organ) { updateSurface(organ, updateField(organ)); }

// How far tissue on one side of the wound (+1, -1) moves: most at the skin, nothing at the front.
Vec3 opening(const Stroke& stroke, const Vec3& p, double side) {
  const double s = stroke.share(p.x()), depth = stroke.depthAt(p.x());
  if (depth <= 0 || s <= 0 || s >= 1) return Vec3::Zero();
  const double above = p.y() - (stroke.begin.y() - depth);  // the front
  if (above <= 0) return Vec3::Zero();
  const double away = std::abs(p.z() - stroke.begin.z() - stroke.bend(p.x()));
  const double gape = 0.0055 * std::sqrt(above / stroke.depth) * std::sqrt(depth / stroke.depth);
  return {0, 0, side * gape * std::exp(-away / 0.025)};
}

// Every vertex goes where its particles go.
std::vector<Vec3f> opened(const Organ& organ, const Stroke& stroke) {
  const auto points = organ.surface.points();
  std::vector<Vec3f> moved(points.begin(), points.end());
  const auto sideOf = [&](const Vec3& p) {
    return p.z() > stroke.begin.z() + stroke.bend(p.x()) ? 1.0 : -1.0;
  };
  for (Vec3f& p : moved)
    p += opening(stroke, p.cast<double>(), sideOf(p.cast<double>())).cast<float>();
  const Lattice& lattice = organ.rest.lattice;
  organ.surface.visitBindings([&](std::int32_t first, std::span<const VertexBinding> bindings) {
    for (std::size_t v = 0; v < bindings.size(); ++v) {
      const std::size_t i = std::size_t(first) + v;
      double side = 0;
      for (int c = 0; c < bindings[v].count; ++c)
        side += bindings[v].weight[std::size_t(c)] *
                sideOf(lattice.centre(lattice.cell(bindings[v].cell[std::size_t(c)])));
      moved[i] = points[i] + opening(stroke, points[i].cast<double>(), side).cast<float>();
    }
  });
  return moved;
}

void draw(const char* file, Organ& organ, const std::vector<Vec3f>& points, const Aabb& place) {
  organ.surface.updateLook(organ.field);
  const auto triangles = organ.surface.triangles();
  TriangleMesh mesh;
  for (const Vec3f& p : points) mesh.points.push_back(p.cast<double>());
  for (const Triangle& t : triangles)
    if (t[0] != t[1]) mesh.triangles.push_back(t);
  std::vector<Vec3f> normals;
  for (const Vec3& n : pointNormals(mesh)) normals.push_back(n.cast<float>());
  OffscreenView picture(1280, 720);
  OperatingRoom room;
  room.setTable(readRoomModel("table"));
  room.organ()->update(
      wholeSurface(points, normals, organ.surface.cut(), triangles, organ.surface.points()));
  room.lightUp(organ.rest.lattice.box());
  room.look(RoomView::Surgeon, place, 1280.0 / 720);
  writePng(file, picture.render(room.root()));
}

int main(int argc, char** argv) {
  TriangleMesh liver = builtinLiver(0.004);
  liver = transformed(liver, standOnTable(liver, restingRotation(liver)));
  Organ organ = makeOrgan(discretize(liver, latticeForSpacing(bounds(liver), 0.005)), {});
  const double whole = volume(organ.surface.mesh());

  // Where is the skin over the middle of the wound?
  Stroke stroke{Vec3(-0.075, 0, 0.012)};
  for (const Vec3& p : organ.surface.mesh().points)
    if ((Vec3(-0.03, 0, 0.012) - Vec3(p.x(), 0, p.z())).norm() < 0.004)
      stroke.begin.y() = std::max(stroke.begin.y(), p.y());

  std::int64_t severed = 0;
  const auto edge = [&](double x) {
    const double z = stroke.begin.z() + stroke.bend(x);
    return std::vector<Vec3>{{x, stroke.begin.y() - stroke.depthAt(x), z},
                             {x, stroke.begin.y() + 0.03, z}};
  };
  constexpr int kStrokes = 24;
  for (int i = 0; i < kStrokes; ++i) {
    const std::vector<Vec3> from = edge(stroke.begin.x() + stroke.length * i / kStrokes),
                            to = edge(stroke.begin.x() + stroke.length * (i + 1) / kStrokes);
    severed += incise(organ, ruledBlade(from, to));
    follow(organ);
  }
  const TriangleMesh wound = organ.surface.mesh();
  const Topology skin = topology(wound);
  const double kept = std::abs(volume(wound) / whole - 1);
  fmt::print(
      "{} grid edges severed; closed: {}, oriented: {}, manifold edges: {}; volume changed by "
      "{:.1e}\n",
      severed, skin.closed(), skin.oriented(), skin.manifold(), kept);
  if (argc > 1)
    draw(argv[1], organ, opened(organ, stroke),
         Aabb{stroke.begin - Vec3(0, 0.02, 0.02), stroke.begin + Vec3(stroke.length, 0, 0.02)});

  // Right through, beside the wound.
  const std::vector<Vec3> low = {{0.045, -0.1, -0.3}, {0.045, -0.1, 0.3}},
                          high = {{0.045, 0.3, -0.3}, {0.045, 0.3, 0.3}};
  incise(organ, ruledBlade(low, high));
  follow(organ);
  const auto pieces = bodies(organ);
  double sum = 0;
  for (const Body& body : pieces) {
    sum += volume(body.mesh);
    fmt::print("body of {:.2f} ml, {} particles, closed: {}\n", 1e6 * volume(body.mesh),
               body.particles, topology(body.mesh).closed());
  }
  fmt::print("together {:.3f} ml of {:.3f} ml\n", 1e6 * sum, 1e6 * whole);
  return skin.closed() && skin.oriented() && skin.manifold() && kept < 1e-7 && severed > 500 &&
                 pieces.size() >= 2 && std::abs(sum / whole - 1) < 1e-7
             ? 0
             : 1;
}
