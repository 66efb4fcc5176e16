#include "operation/live/operation_events.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace resect {

namespace {

// Whether a tool has cut in this step; a blade may cut between particles and touch none.
bool cuts(const StepReport& report, std::int32_t tool) {
  const auto isCut = [&](const TissueEdit& edit) {
    return edit.tool == tool && std::holds_alternative<Incision>(edit.what);
  };
  return std::ranges::any_of(report.edits, isCut) || std::ranges::any_of(report.caused, isCut);
}

}  // namespace

std::vector<OperationEvent> eventsOf(const StepReport& report, const Simulation& simulation,
                                     EventMemory& memory) {
  std::vector<OperationEvent> events;
  const auto note = [&](const char* kind, std::int64_t tool, double amount, std::string text = {}) {
    events.push_back(
        {0, simulation.frame(), simulation.time(), tool, -1, kind, amount, std::move(text)});
  };
  const std::size_t tools = simulation.tools().size(), organs = simulation.organs().size();
  memory.touching.resize(tools, 0), memory.inHand.resize(tools, 0);
  for (std::size_t t = 0; t < tools; ++t) {
    const bool inHand = simulation.tools()[t].inHand;
    if (inHand != bool(memory.inHand[t])) note(inHand ? "take" : "put_back", std::int64_t(t), 0);
    bool touching = t < report.toolForce.size() && report.toolForce[t].squaredNorm() > 0;
    for (std::size_t o = 0; o < organs; ++o)
      touching |= !report.contacts[t * organs + o].cells.empty();
    touching |= cuts(report, std::int32_t(t));
    if (touching != bool(memory.touching[t]))
      note(touching ? "touch" : "release", std::int64_t(t), 0);
    memory.inHand[t] = inHand, memory.touching[t] = touching;
  }
  if (report.removed > 0) note("remove", -1, double(report.removed));
  if (report.severed > 0) note("cut", -1, double(report.severed));
  if (report.torn > 0) note("tear", -1, double(report.torn));
  for (const std::string& fault : report.faults) note("fault", -1, 0, fault);
  return events;
}

void remember(EventMemory& memory, const OperationEvent& event, std::size_t tools) {
  memory.touching.resize(tools, 0), memory.inHand.resize(tools, 0);
  if (event.tool < 0 || std::size_t(event.tool) >= tools) return;
  const auto t = std::size_t(event.tool);
  if (event.kind == "touch" || event.kind == "release") memory.touching[t] = event.kind == "touch";
  if (event.kind == "take" || event.kind == "put_back") memory.inHand[t] = event.kind == "take";
}

}  // namespace resect
