// Shows where vessels bleed, for a hand that is to stop it: a ring round each end, the larger the
// more it bleeds, also where tissue hides it.
#pragma once

#include <span>

#include "blood/bleeding.h"

class SoCoordinate3;
class SoLineSet;
class SoSeparator;
class SoSwitch;

namespace resect {

class BleedingMarks {
 public:
  static constexpr double kLeastFlow = 3e-9;  // m^3/s: ends that bleed less are not shown

  explicit BleedingMarks(SoSeparator* parent);
  ~BleedingMarks();
  BleedingMarks(const BleedingMarks&) = delete;
  BleedingMarks& operator=(const BleedingMarks&) = delete;

  // towardsEye: unit; the rings face it. Returns the box, world, m, of what has to be drawn again:
  // empty if nothing changed visibly.
  Aabb show(std::span<const BleedingEnd> ends, const Vec3& towardsEye);
  Aabb hide();

 private:
  struct Ring {
    Vec3 place;
    double radius;
  };
  SoSeparator* parent_;
  SoSwitch* root_;
  SoCoordinate3* corners_;
  SoLineSet* lines_;
  std::vector<Ring> shown_;
  Vec3 towardsEye_ = Vec3::Zero();
  Aabb box_;  // of what is shown
};

}  // namespace resect
