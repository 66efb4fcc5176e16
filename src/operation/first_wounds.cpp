#include "operation/first_wounds.h"

#include "base/error.h"
#include "organ/apply_edits.h"
#include "organ/region_placer.h"

namespace resect {

void makeWounds(std::span<const OrganWound> wounds, OperatedOrgan& organ) {
  if (wounds.empty()) return;
  const Aabb box = particleBox(organ.organ.rest);
  for (std::size_t i = 0; i < wounds.size(); ++i) {
    const OrganWound& wound = wounds[i];
    const auto place = [&](const Vec3& at) {
      return wound.inWorld ? at : Vec3(box.min + at.cwiseProduct(box.max - box.min));
    };
    const Vec3 deeper = wound.depth * wound.into;
    const Vec3 before[] = {place(wound.from), place(wound.from) + deeper},
               after[] = {place(wound.to), place(wound.to) + deeper};
    std::vector<std::int64_t> removed;
    const TissueEdit cut{0, -1, Incision{ruledBlade(before, after)}};
    if (applyEdits(organ, 0, {&cut, 1}, removed).incised == 0)
      throw error(
          "wound {} of organ \"{}\" cuts no tissue; move it, or make it deeper (the organ at rest "
          "lies from {:.3f} {:.3f} {:.3f} to {:.3f} {:.3f} {:.3f} m)",
          i + 1, organ.name, box.min.x(), box.min.y(), box.min.z(), box.max.x(), box.max.y(),
          box.max.z());
  }
  updateSurface(organ.organ, updateField(organ.organ));
}

}  // namespace resect
