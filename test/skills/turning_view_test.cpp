// The picture of paths in space that turns.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "skills/report/chart.h"

using namespace resect;

namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++found;
  return found;
}

// The middles of the first circles, in the order of the pictures.
std::vector<Eigen::Vector2d> circles(const std::string& svg) {
  std::vector<Eigen::Vector2d> middles;
  for (std::size_t at = svg.find("cx=\""); at != svg.npos; at = svg.find("cx=\"", at + 1))
    middles.emplace_back(std::stod(svg.substr(at + 4)),
                         std::stod(svg.substr(svg.find("cy=\"", at) + 4)));
  return middles;
}

}  // namespace

TEST_CASE("a view turns once about the vertical, and all of it stays in the picture") {
  TurningView view;
  view.title = "Paths <here>";
  view.curves = {{"#2166a5", {Vec3(-0.1, 0, 0), Vec3(0.1, 0, 0)}}};
  view.dots = {{"#b3362b", {Vec3(0, 0.05, 0), Vec3(0, -0.05, 0)}}};
  view.balls = {Vec3(0.1, 0, 0)};
  view.radius = 0.01;
  const std::string svg = toSvg(view);
  CHECK(svg.find("Paths &lt;here&gt;") != std::string::npos);
  CHECK(count(svg, "<g ") == 40);
  CHECK(count(svg, "</g>") == 40);
  CHECK(count(svg, "<polyline") == 40);
  CHECK(count(svg, "h0") == 80);
  const std::vector<Eigen::Vector2d> ball = circles(svg);
  REQUIRE(ball.size() == 40);
  // From the front at the right, then nearer, at the left after half a turn, and farther.
  CHECK(ball[0].x() > 200);
  CHECK(ball[20].x() < 100);
  CHECK(ball[10].x() == doctest::Approx(ball[30].x()).epsilon(0.02));
  CHECK(std::abs(ball[10].y() - ball[30].y()) > 40);
  for (const Eigen::Vector2d& p : ball) {
    CHECK(p.x() > 14);
    CHECK(p.x() < 286);
    CHECK(p.y() > 14);
    CHECK(p.y() < 286);
  }
  CHECK(toSvg(TurningView{}).find("nan") == std::string::npos);
}
