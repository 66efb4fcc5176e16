#include "operation/live/operation_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace resect {

namespace {

// A blade may cut between particles and touch none, and a clip or heat may reach a vessel in a
// wound.
bool changesOrgan(const TissueEdit& edit) {
  return !std::holds_alternative<Release>(edit.what) &&
         !std::holds_alternative<Suction>(edit.what) && !std::holds_alternative<Press>(edit.what);
}

std::string vesselName(const Simulation& simulation, std::int32_t o, std::int32_t segment) {
  const VesselMap& map = *simulation.organs()[std::size_t(o)].organ.map;
  return fmt::format("{} of {:.1f} mm", map.nameOf(segment),
                     2e3 * map.anatomy.segments[std::size_t(segment)].radius);
}

// The vein that draws in most air now.
std::string veinOfMostAir(const Simulation& simulation) {
  double most = 0;
  std::string name;
  for (std::size_t o = 0; o < simulation.organs().size(); ++o)
    for (const VesselInjury& injury : simulation.organs()[o].organ.vessels.injuries)
      if (const double air = -std::min(injury.flow[0], injury.flow[1]); air > most)
        most = air, name = vesselName(simulation, std::int32_t(o), injury.segment);
  return name;
}

}  // namespace

bool worksOnOrgan(const StepReport& report, const Simulation& simulation, std::size_t tool) {
  if (tool < report.toolForce.size() && report.toolForce[tool].squaredNorm() > 0) return true;
  const std::size_t organs = simulation.organs().size();
  for (std::size_t o = 0; o < organs; ++o)
    if (!report.contacts[tool * organs + o].cells.empty()) return true;
  const auto byTool = [&](const TissueEdit& edit) {
    return edit.tool == std::int32_t(tool) && changesOrgan(edit);
  };
  return std::ranges::any_of(report.edits, byTool) || std::ranges::any_of(report.caused, byTool);
}

std::vector<OperationEvent> eventsOf(const StepReport& report, const Simulation& simulation,
                                     EventMemory& memory) {
  std::vector<OperationEvent> events;
  const auto note = [&](const char* kind, std::int64_t tool, double amount, std::string text = {}) {
    events.push_back(
        {0, simulation.frame(), simulation.time(), tool, -1, kind, amount, std::move(text)});
  };
  const std::size_t tools = simulation.tools().size();
  memory.touching.resize(tools, 0), memory.inHand.resize(tools, 0);
  for (std::size_t t = 0; t < tools; ++t) {
    const bool inHand = simulation.tools()[t].inHand;
    if (inHand != bool(memory.inHand[t])) note(inHand ? "take" : "put_back", std::int64_t(t), 0);
    const bool touching = worksOnOrgan(report, simulation, t);
    if (touching != bool(memory.touching[t]))
      note(touching ? "touch" : "release", std::int64_t(t), 0);
    memory.inHand[t] = inHand, memory.touching[t] = touching;
  }
  if (report.removed > 0) note("remove", -1, double(report.removed));
  if (report.severed > 0) note("cut", -1, double(report.severed));
  if (report.torn > 0) note("tear", -1, double(report.torn));
  if (const bool smokes = !report.smoke.empty(); smokes != memory.smoking) {
    note(smokes ? "smoke" : "smoke_clears", smokes ? report.smoke.front().tool : -1, 0);
    memory.smoking = smokes;
  }
  if (const bool draws = report.blood.airRate > 0; draws != memory.drawsAir) {
    if (draws)
      note("air", -1, 1e6 * report.blood.airRate, veinOfMostAir(simulation));
    else
      note("air_stops", -1, 0);
    memory.drawsAir = draws;
  }
  for (const CutVessel& slipped : report.slipped)
    note("clip_slips", -1, 0, vesselName(simulation, slipped.organ, slipped.segment));
  for (const std::string& fault : report.faults) note("fault", -1, 0, fault);
  return events;
}

void remember(EventMemory& memory, const OperationEvent& event, std::size_t tools) {
  memory.touching.resize(tools, 0), memory.inHand.resize(tools, 0);
  if (event.kind == "smoke" || event.kind == "smoke_clears") memory.smoking = event.kind == "smoke";
  if (event.kind == "air" || event.kind == "air_stops") memory.drawsAir = event.kind == "air";
  if (event.tool < 0 || std::size_t(event.tool) >= tools) return;
  const auto t = std::size_t(event.tool);
  if (event.kind == "touch" || event.kind == "release") memory.touching[t] = event.kind == "touch";
  if (event.kind == "take" || event.kind == "put_back") memory.inHand[t] = event.kind == "take";
}

}  // namespace resect
