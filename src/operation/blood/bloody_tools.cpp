#include "operation/blood/bloody_tools.h"

#include <algorithm>

namespace resect {
namespace {

constexpr double kBeside = 0.005;      // m: blood so near to the axis wets the tool
constexpr double kLongest = 0.08;      // m: what is farther from the tip is the hand's
constexpr double kThinnest = 0.05e-3;  // m of liquid blood that stains
constexpr double kSoaks = 0.012;       // m: as thick as a swab is

}  // namespace

void followBlood(const Simulation& simulation, std::vector<double>& reach) {
  const std::vector<ToolState>& tools = simulation.tools();
  reach.resize(tools.size(), 0);
  for (std::size_t t = 0; t < tools.size(); ++t) {
    if (!tools[t].inHand || !simulation.blood().any()) continue;
    const Pose fromWorld = tools[t].pose().inverse();
    const ToolModel& model = tools[t].tool->model;
    const double beside = model.kind == "gauze" ? model.contactRadius : kBeside;
    double wet = 0;  // m^2 of wet tissue at the tip
    for (std::size_t o = 0; o < simulation.organs().size(); ++o) {
      const BloodFilm& film = simulation.blood().film(o);
      if (!film.ready()) continue;
      for (const WetCell& cell : film.wet()) {
        const float area = film.skin()[film.skin().numberOf(cell.cell)].area;
        if (toCubicMetres(cell.liquid) < kThinnest * double(area)) continue;
        const Vec3 at = fromWorld * film.placeOf(simulation.organs()[o], cell.cell).place;
        if (at.head<2>().norm() > beside || at.z() < -kBeside || at.z() > kLongest) continue;
        reach[t] = std::max(reach[t], at.z());
        if (at.z() < kBeside) wet += double(area);
      }
    }
    // Half of the underside wet, and the whole swab is red.
    if (model.kind == "gauze")
      reach[t] = std::max(reach[t], std::min(1.0, wet / (2 * beside * beside)) * kSoaks);
  }
}

}  // namespace resect
