// Depth cues for an instrument's tip: a plumb line from the tip down to what lies below it, a ring
// at the line's lower end, and a glow at the tip if tissue is touched or nearer than 8 mm.
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
  // `tip`: position of the tip, world, m. `below`: height (y) of what lies under the tip, world, m.
  // `distance`: from the tip to tissue, m; 0 inside tissue. `touching`: whether the tool touches
  // tissue. Returns false if nothing changed.
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
