#include "operation/live/sight.h"

namespace resect {

std::vector<OperationEvent> sightEvents(std::span<const Sight> sight, const Simulation& simulation,
                                        std::vector<Sight>& memory) {
  std::vector<OperationEvent> events;
  memory.resize(simulation.tools().size(), Sight::Unknown);
  for (std::size_t t = 0; t < memory.size(); ++t) {
    const bool inHand = simulation.tools()[t].inHand;
    const Sight now = inHand && t < sight.size() ? sight[t] : Sight::Unknown;
    if (now != memory[t] && now != Sight::Unknown) {
      OperationEvent event;
      event.frame = simulation.frame();
      event.time = simulation.time();
      event.tool = std::int64_t(t);
      event.kind = now == Sight::Seen ? kInView : kOutOfView;
      events.push_back(event);
    }
    memory[t] = now;
  }
  return events;
}

}  // namespace resect
