// The body that stops tissue in the operative field is the one that is drawn.
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "collision/signed_distance.h"
#include "geometry/point_triangle.h"
#include "inventor/scene/operating_room.h"
#include "inventor/scene/operation_view.h"
#include "io/surroundings/surroundings_of.h"
#include "operation/room.h"

using namespace resect;

namespace {

void addTriangle(void* mesh, SoCallbackAction* action, const SoPrimitiveVertex* a,
                 const SoPrimitiveVertex* b, const SoPrimitiveVertex* c) {
  TriangleMesh& m = *static_cast<TriangleMesh*>(mesh);
  const auto first = std::int32_t(m.points.size());
  for (const SoPrimitiveVertex* corner : {a, b, c}) {
    SbVec3f p;
    action->getModelMatrix().multVecMatrix(corner->getPoint(), p);
    m.points.emplace_back(p[0], p[1], p[2]);
  }
  m.triangles.push_back({first, first + 1, first + 2});
}

TriangleMesh drawnMesh(SoNode* node) {
  TriangleMesh mesh;
  SoCallbackAction action;
  action.addTriangleCallback(SoShape::getClassTypeId(), addTriangle, &mesh);
  action.apply(node);
  return mesh;
}

// What is drawn of the field, by the names of its parts.
TriangleMesh drawnFieldParts(const std::vector<std::string>& names) {
  auto* field = static_cast<SoSeparator*>(readRoomModel("field"));
  field->ref();
  TriangleMesh all;
  for (int i = 0; i < field->getNumChildren(); ++i)
    if (std::ranges::count(names, field->getChild(i)->getName().getString()) > 0)
      append(all, drawnMesh(field->getChild(i)));
  field->unref();
  return all;
}

// A share of the distances, from the least, m.
double quantile(std::vector<double> distances, double share) {
  std::ranges::sort(distances);
  return distances[std::size_t(share * double(distances.size() - 1))];
}

}  // namespace

TEST_CASE("the abdominal wall that stops tissue lies within 3 mm of the drawn one") {
  const TriangleMesh all = drawnFieldParts({"skin", "fat", "muscle", "gut", "omentum", "drape"});
  {
    const StandingBody body = abdominalWall({});
    std::vector<double> distances;
    for (const Triangle& t : body.shape.triangles) {
      const Vec3 middle =
          (body.shape.points[std::size_t(t[0])] + body.shape.points[std::size_t(t[1])] +
           body.shape.points[std::size_t(t[2])]) /
          3;
      // Not what lies below the table's top, nor the border at which the wall ends.
      if (middle.y() < 0.002) continue;
      const bool border = std::hypot(middle.x() / 0.335, middle.z() / 0.315) > 0.99;
      if (border) continue;
      double least = 1;
      for (const Triangle& d : all.triangles) {
        const Vec3 &a = all.points[std::size_t(d[0])], &b = all.points[std::size_t(d[1])],
                   &c = all.points[std::size_t(d[2])];
        if ((a - middle).squaredNorm() > 0.0025) continue;
        least = std::min(least, squaredDistance(middle, a, b, c));
      }
      distances.push_back(std::sqrt(least));
    }
    MESSAGE(body.name, ": ", distances.size(), " places, median ", 1e3 * quantile(distances, 0.5),
            " mm, 99 % within ", 1e3 * quantile(distances, 0.99), " mm, most ",
            1e3 * quantile(distances, 1), " mm");
    CHECK(quantile(distances, 1) < 0.003);
  }
}

TEST_CASE("what is drawn of the abdominal wall is not outside the one that stops tissue") {
  const StandingBody body = abdominalWall({});
  const SignedDistance shape(body.shape, 0.02, body.cell, 0.03);
  for (const char* part : {"skin", "fat", "muscle"}) {
    CAPTURE(part);
    std::vector<double> distances;
    for (const Vec3& point : drawnFieldParts({part}).points) {
      if (point.y() < 0.002) continue;
      distances.push_back(shape(point).distance);
    }
    MESSAGE(part, ": ", distances.size(), " points, 99 % at most ", 1e3 * quantile(distances, 0.99),
            " mm, most ", 1e3 * quantile(distances, 1), " mm");
    CHECK(quantile(distances, 0.999) < 0.003);
  }
}

TEST_CASE("the drawn field and the body lie at the same place, at any size of the organs") {
  for (const double width : {0.1, 0.234, 0.5}) {
    const Aabb organs{{0.1 - 0.5 * width, 0, -0.4}, {0.1 + 0.5 * width, 0.1, -0.3}};
    const FieldPlace place = fieldPlace(organs);
    CHECK(place.scale == doctest::Approx(std::clamp(width / 0.234, 0.6, 1.6)));
    OperatingRoom room;
    room.setField(readRoomModel("field"), organs);
    SoCallbackAction action;
    TriangleMesh mesh;
    action.addTriangleCallback(SoShape::getClassTypeId(), addTriangle, &mesh);
    action.apply(room.root());
    const StandingBody body = abdominalWall(place);
    for (std::size_t i = 0; i < body.shape.points.size(); i += 7) {
      const Vec3 p = body.pose * body.shape.points[i];
      // Only the edge of the opening: on the drape, drawn points lie far from each other.
      const Vec3 q = (p - place.position) / place.scale;
      if (q.y() < 0.01 || std::hypot(q.x() / 0.2, q.z() / 0.18) > 1) continue;
      double least = 1;
      for (const Vec3& r : mesh.points) least = std::min(least, (p - r).squaredNorm());
      CHECK(std::sqrt(least) < 0.006 * place.scale);
    }
  }
}
