#include "operation/blood/bloody_tools.h"

#include <algorithm>

namespace resect {
namespace {

constexpr double kBeside = 0.005;      // m: blood so near to the axis wets the tool
constexpr double kLongest = 0.08;      // m: what is farther from the tip is the hand's
constexpr double kThinnest = 0.05e-3;  // m of liquid blood that stains

}  // namespace

void followBlood(const Simulation& simulation, std::vector<double>& reach) {
  const std::vector<ToolState>& tools = simulation.tools();
  reach.resize(tools.size(), 0);
  for (std::size_t t = 0; t < tools.size(); ++t) {
    if (!tools[t].inHand || !simulation.blood().any()) continue;
    const Pose fromWorld = tools[t].pose().inverse();
    for (std::size_t o = 0; o < simulation.organs().size(); ++o) {
      const BloodFilm& film = simulation.blood().film(o);
      if (!film.ready()) continue;
      for (const WetCell& wet : film.wet()) {
        const float area = film.skin()[film.skin().numberOf(wet.cell)].area;
        if (toCubicMetres(wet.liquid) < kThinnest * double(area)) continue;
        const Vec3 at = fromWorld * film.placeOf(simulation.organs()[o], wet.cell).place;
        if (at.head<2>().norm() < kBeside && at.z() > -kBeside && at.z() < kLongest)
          reach[t] = std::max(reach[t], at.z());
      }
    }
  }
}

}  // namespace resect
