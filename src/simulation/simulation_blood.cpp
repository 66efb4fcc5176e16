// The stages of heat and blood.
#include "organ/heat/heat_organ.h"
#include "simulation/simulation.h"
#include "tools/rest_place.h"

namespace resect {

// Warms and coagulates tissue. What it does to vessels and materials counts from this frame's blood
// and the next frame's tissue.
void Simulation::heatTissue(const FrameInput& input, StepReport& report) {
  report.smoke.clear();
  work_.applied.assign(work_.edits.begin(), work_.edits.end());
  work_.applied.insert(work_.applied.end(), work_.caused.begin(), work_.caused.end());
  for (std::size_t o = 0; o < organs_.size(); ++o) {
    work_.heat.clear();
    for (const TissueEdit& edit : work_.applied)
      if (const auto* heat = std::get_if<Heat>(&edit.what); heat && edit.organ == std::int32_t(o))
        work_.heat.push_back({heat->place, heat->radius, heat->power});
    if (work_.heat.empty() && organs_[o].organ.heat.empty()) continue;
    heatOrgan(organs_[o], work_.heat, input.duration, !work_.removedCells[o].empty());
    const double steam = organs_[o].organ.heat.steamRate();
    if (!(steam > 0)) continue;
    // The instruments share it by their power.
    double power = 0;
    for (const HeatSource& source : work_.heat) power += source.power;
    for (const TissueEdit& edit : work_.applied)
      if (const auto* heat = std::get_if<Heat>(&edit.what); heat && edit.organ == std::int32_t(o))
        report.smoke.push_back({std::int32_t(o), edit.tool,
                                presentPlace(organs_[o].organ, *organs_[o].tissue, heat->place),
                                steam * heat->power / power});
  }
}

void Simulation::flowBlood(const FrameInput& input, StepReport& report) {
  if (!blood_.any()) return;
  blood_.step(organs_, work_.applied, input.duration, time_ + input.duration, table_, report.blood);
}

}  // namespace resect
