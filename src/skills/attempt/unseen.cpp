#include "skills/attempt/unseen.h"

#include <optional>
#include <vector>

#include "operation/live/sight.h"

namespace resect {

void addUnseen(std::span<const OperationEvent> events, std::int64_t first, std::int64_t last,
               Attempt& attempt) {
  std::vector<std::optional<std::int64_t>> since(attempt.instruments.size());
  const auto seen = [&](std::size_t tool, std::int64_t frame) {
    if (!since[tool]) return;
    *attempt.instruments[tool].unseen += attempt.interval * double(frame - *since[tool]);
    since[tool].reset();
  };
  for (const OperationEvent& event : events) {
    if (event.tool < 0 || std::size_t(event.tool) >= since.size()) continue;
    if (event.frame <= first || event.frame > last) continue;
    const auto tool = std::size_t(event.tool);
    if (isSight(event) || event.kind == "put_back") seen(tool, event.frame);
    if (!isSight(event)) continue;
    std::optional<double>& unseen = attempt.instruments[tool].unseen;
    if (!unseen) unseen = 0;
    if (event.kind == kOutOfView) since[tool] = event.frame;
  }
  for (std::size_t tool = 0; tool < since.size(); ++tool) seen(tool, last);
}

}  // namespace resect
