// Guidance: distances from what the hand is to keep to, and what is drawn.
#include "inventor/hand/marks/guide_marks.h"

#include <Inventor/nodes/SoSeparator.h>
#include <doctest/doctest.h>

#include "inventor/init.h"

using namespace resect;

namespace {

GuidedTip uprightAt(double x, double y, double z) { return {Vec3(x, y, z), Vec3(x, y + 0.1, z)}; }

}  // namespace

TEST_CASE("distances from targets, lines, planes and structures") {
  Guide guide;
  CHECK_FALSE(distanceFrom(guide, uprightAt(0, 0, 0)));
  guide.places = {Vec3(0, 0, 0), Vec3(0.03, 0, 0)};
  guide.next = 1;
  CHECK(*distanceFrom(guide, uprightAt(0.03, 0.004, 0)) == doctest::Approx(0.004));
  guide.next = 2;
  CHECK_FALSE(distanceFrom(guide, uprightAt(0, 0, 0)));

  guide.kind = Guide::Kind::Line;  // a blade goes in below the line: its shaft counts
  CHECK(*distanceFrom(guide, uprightAt(0.01, -0.016, 0.002)) == doctest::Approx(0.002));
  CHECK(*distanceFrom(guide, uprightAt(0.035, 0, 0)) == doctest::Approx(0.005));

  guide.kind = Guide::Kind::Plane;
  guide.normal = Vec3(0, 0, 1);
  CHECK(*distanceFrom(guide, uprightAt(5, 5, -0.007)) == doctest::Approx(0.007));

  guide.kind = Guide::Kind::Ball;
  guide.radius = 0.01;
  CHECK(*distanceFrom(guide, uprightAt(0, 0.025, 0)) == doctest::Approx(0.015));
  CHECK(*distanceFrom(guide, uprightAt(0, 0.005, 0)) == doctest::Approx(-0.005));
}

TEST_CASE("the colour tells margin from structure, and on the line from beside it") {
  Guide guide;
  guide.kind = Guide::Kind::Ball;
  guide.margin = 0.01;
  CHECK(keepingOf(guide, -0.001) == Keeping::Wrong);
  CHECK(keepingOf(guide, 0.009) == Keeping::Near);
  CHECK(keepingOf(guide, 0.011) == Keeping::Well);
  CHECK(keepingOf(guide, 0.05) == Keeping::Far);
  guide.kind = Guide::Kind::Line;
  guide.radius = 0.006;
  CHECK(keepingOf(guide, 0.006) == Keeping::Well);
  CHECK(keepingOf(guide, 0.011) == Keeping::Near);
  CHECK(keepingOf(guide, 0.02) == Keeping::Wrong);
  CHECK(keepingOf(guide, 0.05) == Keeping::Far);  // it is not at the line yet
}

TEST_CASE("only what has changed is drawn again") {
  initInventor();
  auto* parent = new SoSeparator;
  parent->ref();
  {
    LineMarks marks(parent, {});
    CHECK(parent->getNumChildren() == 1);
    Guide guide;
    guide.places = {Vec3(0, 0.1, 0)};
    const Vec3 eye = Vec3::UnitZ();
    const Aabb first = marks.show(guideLines(guide, Keeping::Far, eye));
    CHECK(first.size().x() == doctest::Approx(2 * (0.006 + 0.003)));
    CHECK(marks.show(guideLines(guide, Keeping::Far, eye)).empty());
    CHECK_FALSE(marks.show(guideLines(guide, Keeping::Well, eye)).empty());  // another colour
    guide.places[0].x() += 1e-4;
    CHECK(marks.show(guideLines(guide, Keeping::Well, eye)).empty());
    guide.places[0].x() += 0.02;
    CHECK(marks.show(guideLines(guide, Keeping::Well, eye)).size().x() >
          0.03);  // where it was and is
    guide.next = 1;
    CHECK_FALSE(marks.show(guideLines(guide, Keeping::Well, eye)).empty());
    CHECK(marks.show({}).empty());
  }
  CHECK(parent->getNumChildren() == 0);
  parent->unref();
}
