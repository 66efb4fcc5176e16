#include "support/organs/twelve_organs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "isosurface/polygonise.h"

namespace resect::test {
namespace {

// Distance to a surface, m, or nearly: negative inside.
using Shape = std::function<double(const Vec3&)>;

Shape ellipsoid(const Vec3& centre, const Vec3& radii) {
  return [=](const Vec3& p) {
    const Vec3 q = (p - centre).cwiseQuotient(radii);
    const double k = q.norm(), slope = q.cwiseQuotient(radii).norm();
    return slope > 0 ? k * (k - 1) / slope : -radii.minCoeff();
  };
}

struct Knot {
  Vec3 at;
  double radius;
};

// A tube through the knots, whose radius changes evenly from one to the next.
Shape tube(const std::vector<Knot>& knots) {
  return [=](const Vec3& p) {
    double nearest = 1;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const Vec3 way = knots[i + 1].at - knots[i].at;
      const double share = std::clamp((p - knots[i].at).dot(way) / way.squaredNorm(), 0.0, 1.0);
      const double radius = knots[i].radius + share * (knots[i + 1].radius - knots[i].radius);
      nearest = std::min(nearest, (p - knots[i].at - share * way).norm() - radius);
    }
    return nearest;
  };
}

// Both, blended over about this width, m.
Shape with(const Shape& a, const Shape& b, double blend) {
  return [=](const Vec3& p) {
    const double da = a(p), db = b(p), h = std::max(blend - std::abs(da - db), 0.0) / blend;
    return std::min(da, db) - 0.25 * h * h * blend;
  };
}
Shape without(const Shape& a, const Shape& b, double blend) {
  const Shape joined = with([a](const Vec3& p) { return -a(p); }, b, blend);
  return [joined](const Vec3& p) { return -joined(p); };
}
Shape hollow(const Shape& a, double wall) {
  return [=](const Vec3& p) {
    const double d = a(p);
    return std::max(d, -(d + wall));
  };
}

Shape liver() {
  return without(with(ellipsoid({-0.03, 0, 0}, {0.075, 0.066, 0.07}),
                      ellipsoid({0.06, 0.015, 0.02}, {0.07, 0.032, 0.05}), 0.04),
                 ellipsoid({0.01, -0.09, 0.01}, {0.08, 0.045, 0.06}), 0.02);
}
Shape spleen() {
  return without(ellipsoid({0, 0, 0}, {0.058, 0.022, 0.038}),
                 ellipsoid({0, -0.04, 0}, {0.04, 0.028, 0.03}), 0.01);
}
Shape kidney() {
  return without(ellipsoid({0, 0, 0}, {0.055, 0.03, 0.023}),
                 ellipsoid({0, 0.036, 0}, {0.018, 0.018, 0.03}), 0.012);
}
Shape pancreas() {
  return with(ellipsoid({-0.06, -0.012, 0.005}, {0.02, 0.026, 0.015}),
              tube({{{-0.05, 0, 0}, 0.012},
                    {{-0.02, 0.012, 0.008}, 0.011},
                    {{0.03, 0.016, -0.004}, 0.011},
                    {{0.075, 0.03, -0.02}, 0.008}}),
              0.015);
}
Shape gallbladder() {
  return hollow(
      with(ellipsoid({0, 0, 0}, {0.03, 0.018, 0.018}),
           tube({{{0.02, 0, 0}, 0.012}, {{0.04, 0.004, 0}, 0.007}, {{0.055, 0.002, 0.004}, 0.005}}),
           0.015),
      0.003);
}
Shape stomach() {
  return hollow(tube({{{0.05, 0.1, -0.02}, 0.04},
                      {{0.045, 0.05, -0.01}, 0.045},
                      {{0.02, -0.02, 0.01}, 0.042},
                      {{-0.03, -0.06, 0.02}, 0.034},
                      {{-0.075, -0.045, 0.01}, 0.02},
                      {{-0.09, -0.025, 0}, 0.014}}),
                0.006);
}
Shape lung() {
  return without(ellipsoid({0, 0, 0}, {0.065, 0.12, 0.085}),
                 ellipsoid({0.075, -0.04, 0.02}, {0.05, 0.06, 0.055}), 0.02);
}
Shape heart() {
  const Shape outer = with(with(ellipsoid({0.012, -0.01, 0}, {0.036, 0.05, 0.035}),
                                ellipsoid({-0.02, 0, 0.012}, {0.033, 0.042, 0.03}), 0.02),
                           ellipsoid({-0.005, 0.04, -0.008}, {0.04, 0.025, 0.03}), 0.015);
  return without(without(outer, ellipsoid({0.013, -0.012, 0}, {0.022, 0.034, 0.021}), 0.003),
                 ellipsoid({-0.024, -0.002, 0.014}, {0.02, 0.03, 0.018}), 0.003);
}
Shape aorta() {
  const Shape trunk = tube({{{-0.02, -0.03, 0.02}, 0.015},
                            {{-0.022, 0.03, 0.018}, 0.015},
                            {{-0.005, 0.055, 0.004}, 0.014},
                            {{0.018, 0.05, -0.012}, 0.013},
                            {{0.026, 0.02, -0.02}, 0.0125},
                            {{0.024, -0.045, -0.022}, 0.012}});
  const Shape arch =
      with(with(tube({{{-0.014, 0.05, 0.01}, 0.007}, {{-0.028, 0.09, 0.012}, 0.006}}),
                tube({{{0, 0.055, 0.002}, 0.005}, {{-0.002, 0.095, 0.004}, 0.005}}), 0.002),
           tube({{{0.014, 0.054, -0.008}, 0.006}, {{0.03, 0.09, -0.01}, 0.005}}), 0.002);
  return hollow(with(trunk, arch, 0.006), 0.0025);
}
Shape uterus() {
  const Shape body = with(ellipsoid({0, 0.02, 0}, {0.028, 0.03, 0.021}),
                          tube({{{0, 0, 0}, 0.015}, {{0, -0.04, 0}, 0.013}}), 0.02);
  const Shape tubes = with(tube({{{0.02, 0.035, 0}, 0.005},
                                 {{0.05, 0.04, -0.005}, 0.004},
                                 {{0.07, 0.025, -0.01}, 0.006}}),
                           tube({{{-0.02, 0.035, 0}, 0.005},
                                 {{-0.05, 0.04, -0.005}, 0.004},
                                 {{-0.07, 0.025, -0.01}, 0.006}}),
                           0.002);
  return with(body, tubes, 0.01);
}
Shape bladder() { return hollow(ellipsoid({0, 0, 0}, {0.042, 0.035, 0.038}), 0.005); }
Shape brain() {
  const Shape halves = with(ellipsoid({-0.026, 0, 0}, {0.042, 0.05, 0.08}),
                            ellipsoid({0.026, 0, 0}, {0.042, 0.05, 0.08}), 0.012);
  const Shape small = with(ellipsoid({0, -0.05, -0.045}, {0.045, 0.022, 0.028}),
                           tube({{{0, -0.03, -0.01}, 0.016}, {{0, -0.085, -0.02}, 0.011}}), 0.01);
  const Shape smooth = with(halves, small, 0.015);
  return [smooth](const Vec3& p) {  // folds of 1.2 mm
    const double fold = std::sin(420 * p.x()) * std::sin(380 * p.y() + 2 * std::sin(150 * p.z())) *
                        std::sin(400 * p.z());
    return smooth(p) + 0.0012 * fold;
  };
}

struct Kind {
  const char* name;
  Shape (*shape)();
  double edge;  // m
  bool hollow;
  double least, most;  // ml
};
constexpr Kind kKinds[] = {{"liver", &liver, 0.004, false, 1200, 2000},
                           {"spleen", &spleen, 0.003, false, 120, 250},
                           {"kidney", &kidney, 0.003, false, 100, 200},
                           {"pancreas", &pancreas, 0.002, false, 50, 120},
                           {"gallbladder", &gallbladder, 0.0015, true, 8, 30},
                           {"stomach", &stomach, 0.003, true, 150, 400},
                           {"lung", &lung, 0.005, false, 1500, 2800},
                           {"heart", &heart, 0.003, true, 200, 450},
                           {"aorta", &aorta, 0.0015, true, 20, 80},
                           {"uterus", &uterus, 0.002, false, 60, 150},
                           {"bladder", &bladder, 0.0025, true, 50, 150},
                           {"brain", &brain, 0.004, false, 1000, 1600}};

}  // namespace

BroughtOrgan broughtOrgan(const std::string& name) {
  const auto kind = std::ranges::find_if(kKinds, [&](const Kind& k) { return name == k.name; });
  if (kind == std::end(kKinds)) throw std::invalid_argument("no organ " + name);
  const Aabb box{Vec3(-0.2, -0.2, -0.2), Vec3(0.2, 0.2, 0.2)};
  PolygoniseSettings settings;
  settings.edge = kind->edge;
  settings.lipschitz = 3;
  return {name, kind->hollow, kind->least, kind->most, polygonise(kind->shape(), box, settings)};
}

}  // namespace resect::test
