// Marks that show how far an instrument's tip is from other things: a plumb line from the tip down
// to what lies below it, a ring at the lower end of this line, and a glow at the tip. The glow is
// shown if the tool touches tissue, or if the tip is nearer than 8 mm to tissue.
#pragma once

#include "base/vec.h"

class SoBaseColor;
class SoCoordinate3;
class SoMaterial;
class SoSeparator;
class SoSphere;
class SoSwitch;
class SoTranslation;

namespace resect {

class TipMarker {
 public:
  explicit TipMarker(SoSeparator* parent);
  ~TipMarker();
  TipMarker(const TipMarker&) = delete;
  TipMarker& operator=(const TipMarker&) = delete;

  void hide();
  // tip: position of the tip; world, m. below: y of what lies under the tip; world, m. distance:
  // distance of the tip from tissue, m; 0 inside tissue. touching: whether the tool touches tissue.
  // Returns false if nothing has changed.
  bool show(const Vec3& tip, double below, double distance, bool touching);

 private:
  SoSeparator* parent_;
  SoSwitch* root_;
  SoCoordinate3* line_;
  SoTranslation* ringPlace_;
  SoTranslation* glowPlace_;
  SoSwitch* glowSwitch_;
  SoMaterial* glow_;
  SoSphere* ball_;
  bool shown_ = false, touching_ = false;
  Vec3 tip_ = Vec3::Zero();
  double below_ = 0, distance_ = 0;
};

}  // namespace resect
