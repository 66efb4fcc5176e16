#include "skills/attempt/vessel_watch.h"

#include <algorithm>

#include "anatomy/vessel_closure.h"

namespace resect {
namespace {

// The tool that cuts in this frame: of several the one that made the last cut.
int cuttingTool(const StepReport& report) {
  int tool = -1;
  const auto look = [&](const std::vector<TissueEdit>& edits) {
    for (const TissueEdit& edit : edits)
      if (edit.tool >= 0 && (std::holds_alternative<Incision>(edit.what) ||
                             std::holds_alternative<RemoveCell>(edit.what) ||
                             std::holds_alternative<Carve>(edit.what)))
        tool = edit.tool;
  };
  look(report.edits), look(report.caused);
  return tool;
}

VesselStory storyOf(const Simulation& simulation, std::int32_t o, const VesselInjury& injury) {
  const Organ& organ = simulation.organs()[std::size_t(o)].organ;
  const VesselSegment& s = organ.map->anatomy.segments[std::size_t(injury.segment)];
  VesselStory story;
  story.organ = o, story.segment = injury.segment;
  story.kind = s.kind, story.diameter = 2 * s.radius;
  story.name = organ.map->nameOf(injury.segment);
  story.place = s.at(0.5 * (injury.from + injury.to));
  story.cut = simulation.time();
  const auto closed = [&](VesselEnd end) {
    return isClosed(organ.map->anatomy, organ.vessels, injury, end);
  };
  story.clippedRoot = closed(VesselEnd::Root), story.clippedFar = closed(VesselEnd::Far);
  return story;
}

}  // namespace

void VesselWatch::begin(const Simulation& simulation, Attempt& attempt) const {
  for (std::size_t o = 0; o < simulation.organs().size(); ++o)
    for (const VesselInjury& injury : simulation.organs()[o].organ.vessels.injuries) {
      VesselStory story = storyOf(simulation, std::int32_t(o), injury);
      story.before = true;
      attempt.vessels.push_back(std::move(story));
    }
}

void VesselWatch::addClips(const Simulation& simulation, Attempt& attempt) {
  clips_.resize(simulation.organs().size(), 0);
  for (std::size_t o = 0; o < clips_.size(); ++o) {
    const Organ& organ = simulation.organs()[o].organ;
    const std::vector<VesselClip>& clips = organ.vessels.clips;
    if (clips.size() == clips_[o]) continue;
    // They are kept in the order of the segments: find those that are not known yet. Heat closes
    // vessels too, but places no clip.
    for (const VesselClip& clip : clips) {
      if (clip.byHeat) continue;
      const Vec3 place = organ.map->anatomy.segments[std::size_t(clip.segment)].at(clip.share);
      const bool known = std::ranges::any_of(attempt.clips, [&](const ClipPlaced& c) {
        return c.organ == std::int32_t(o) && c.segment == clip.segment && c.place == place;
      });
      if (!known)
        attempt.clips.push_back(
            {simulation.time(), std::int32_t(o), clip.segment, place,
             organ.map->nameOf(clip.segment),
             2 * organ.map->anatomy.segments[std::size_t(clip.segment)].radius});
    }
    clips_[o] = clips.size();
  }
}

void VesselWatch::addCuts(const Simulation& simulation, const StepReport& report,
                          Attempt& attempt) {
  for (const CutVessel& cut : report.vessels) {
    const auto known = std::ranges::any_of(attempt.vessels, [&](const VesselStory& s) {
      return s.organ == cut.organ && s.segment == cut.segment;
    });
    const Organ& organ = simulation.organs()[std::size_t(cut.organ)].organ;
    const VesselInjury* injury = organ.vessels.injury(cut.segment);
    if (known || !injury) continue;
    VesselStory story = storyOf(simulation, cut.organ, *injury);
    story.tool = cuttingTool(report);
    attempt.vessels.push_back(std::move(story));
  }
}

void VesselWatch::add(const Simulation& simulation, const StepReport& report, Attempt& attempt) {
  if (!simulation.blood().any()) return;
  addClips(simulation, attempt);
  addCuts(simulation, report, attempt);
  bool occluded = false;
  for (VesselStory& story : attempt.vessels) {
    const Organ& organ = simulation.organs()[std::size_t(story.organ)].organ;
    const VesselInjury* injury = organ.vessels.injury(story.segment);
    if (!injury) continue;
    story.severed = injury->severed();
    if (!isClosed(organ.map->anatomy, organ.vessels, *injury))
      story.closed.reset();
    else if (!story.closed)
      story.closed = simulation.time();
  }
  for (const OperatedOrgan& o : simulation.organs())
    occluded = occluded || o.organ.vessels.inflowClamped;
  if (occluded) attempt.inflowOccluded += attempt.interval;
  if (occluded && !occluded_) ++attempt.inflowCycles;
  occluded_ = occluded;
}

void VesselWatch::finish(const Simulation& simulation, Attempt& attempt) const {
  for (VesselStory& story : attempt.vessels)
    if (const VesselInjury* injury =
            simulation.organs()[std::size_t(story.organ)].organ.vessels.injury(story.segment))
      story.bled = injury->bled;
}

}  // namespace resect
