// What a scenario's title promises, and whether a run kept the promises.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "operation/run.h"

namespace resect {

struct PromiseKind {
  std::string_view word;      // name of the promise in files
  std::string_view sentence;  // what happened in a run that broke it; for people
};
// What each word promises:
// - removal: tissue is removed.
// - cut: tissue is cut, and no tissue is removed.
// - push: the force on an instrument exceeds 0.01 N, and no tissue is cut or removed.
// - parts: at the end, at least one piece of an organ is separate from the organ's body, which is
//   its largest part (organ/parts/tissue_parts.h).
// - blood: blood is lost.
// - dry: at the end hardly anything bleeds (grade 0 or 1 on the VIBe scale: at most 5 ml/min).
inline constexpr std::array kPromises{
    PromiseKind{"removal", "no tissue was removed"},
    PromiseKind{"cut", "tissue was removed, or none was cut"},
    PromiseKind{"push", "no instrument pushed, or tissue was cut or removed"},
    PromiseKind{"parts", "the organ is still in one piece"},
    PromiseKind{"blood", "no blood was lost"},
    PromiseKind{"dry", "it still bleeds at the end"}};

// One sentence for each tool that moves by keys (ToolKey) but touched no organ, and one for each
// promise of the scenario that was not kept.
std::vector<std::string> findings(const RunSummary& summary, const Scenario& scenario);

}  // namespace resect
