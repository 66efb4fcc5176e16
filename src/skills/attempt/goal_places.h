// The places of a goal in an organ, and their present positions while the tissue moves.
#pragma once

#include <optional>
#include <vector>

#include "operation/task/task.h"
#include "organ/operated_organ.h"

namespace resect {

// A point of the tissue, with a normal of the surface.
struct TissuePoint {
  Vec3 rest = Vec3::Zero();  // rest position, m
  // Outward normal at rest, at the surface point that is nearest to this point; unit.
  Vec3 normal = Vec3::UnitY();
  std::int64_t cell = -1;  // particle that the point moves with; -1: none
};

// The points of the tissue at these places. organ: in its state before the operation. Throws Error
// if a place names a landmark that the organ lacks. Cost: a pass over the surface for each place.
std::vector<TissuePoint> goalPlaces(const std::vector<TaskPlace>& places, const Organ& organ);
// The point of the tissue at a position in rest space, m.
TissuePoint tissuePoint(const Vec3& rest, const Organ& organ);

// Returns the point with its present position (in `rest`) and present normal, both in the world. If
// the point has no particle, or if this particle was removed, returns `point` unchanged.
TissuePoint presentPoint(const TissuePoint& point, const OperatedOrgan& organ);

// Throws Error if the organ lacks what the goal needs: a landmark, a structure or vessels.
void requireFits(const TaskGoal& goal, const OperatedOrgan& organ);

// A vessel that a task can name.
struct VesselPlace {
  Vec3 place = Vec3::Zero();  // middle of its segment, at rest, m
  VesselKind kind = VesselKind::PortalVein;
  double diameter = 0;  // m
};
// Among the vessel segments with a diameter of at least 2 mm, the one whose middle is nearest to
// `rest`, a point in rest space, m. None if no such segment is within 3 cm.
std::optional<VesselPlace> vesselNear(const Organ& organ, const Vec3& rest);

// The label of the structure with that name in the organ; 0 if there is none.
int labelNamed(const Organ& organ, const std::string& name);

}  // namespace resect
