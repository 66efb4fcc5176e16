// The places of a goal in an organ, and where they are while its tissue moves.
#pragma once

#include <optional>
#include <vector>

#include "operation/task/task.h"
#include "organ/operated_organ.h"

namespace resect {

// A point of the tissue, with the surface's normal there.
struct TissuePoint {
  Vec3 rest = Vec3::Zero();     // m
  Vec3 normal = Vec3::UnitY();  // outwards, of the surface point nearest to it, at rest; unit
  std::int64_t cell = -1;       // particle that carries it
};

// organ: before the operation. Throws Error if a place names a landmark that the organ lacks. Cost:
// a pass over the surface for each place.
std::vector<TissuePoint> goalPlaces(const std::vector<TaskPlace>& places, const Organ& organ);
// A point of the tissue at rest.
TissuePoint tissuePoint(const Vec3& rest, const Organ& organ);

// Where the point is now, and its normal, in the world. Where its particle is gone, the point stays
// where it was at rest.
TissuePoint presentPoint(const TissuePoint& point, const OperatedOrgan& organ);

// Throws Error if the organ lacks what the goal names: its landmarks, its structure, its vessels.
void requireFits(const TaskGoal& goal, const OperatedOrgan& organ);

// A vessel that a task can name.
struct VesselPlace {
  Vec3 place = Vec3::Zero();  // of its middle, at rest, m
  VesselKind kind = VesselKind::PortalVein;
  double diameter = 0;  // m
};
// The vessel of 2 mm and more that is nearest to a point of the organ at rest, within 3 cm; none if
// there is none.
std::optional<VesselPlace> vesselNear(const Organ& organ, const Vec3& rest);

// The structure's label in the organ; 0 if it has none of that name.
int labelNamed(const Organ& organ, const std::string& name);

}  // namespace resect
