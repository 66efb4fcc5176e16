// A dragger in the scene that sets the iso level. The colour field is a smooth field, about 100 in
// tissue and 0 outside. The organ's surface is where the colour field has the value of the iso
// level. The dragger slides along a vertical scale. The iso level is written above the scale.
#pragma once

#include <functional>

#include "base/vec.h"
#include "geometry/aabb.h"

class SoDragger;
class SoSeparator;
class SoSwitch;
class SoText3;
class SoTransform;
class SoTranslate1Dragger;

namespace resect {

// A place for the lower end of the scale; world, m. It is to the left of the organ in the picture,
// so that the scale does not hide the organ. towardsCamera: direction from the organ to the camera.
// Only the direction's angle about the vertical matters, rounded to steps of 10 degrees.
Vec3 scaleFoot(const Aabb& organ, const Vec3& towardsCamera);

class IsoDragger {
 public:
  // foot: the lower end of the scale, at which the iso level is 0; world, m.
  IsoDragger(SoSeparator* parent, const Vec3& foot);
  ~IsoDragger();
  IsoDragger(const IsoDragger&) = delete;
  IsoDragger& operator=(const IsoDragger&) = delete;

  float value() const { return value_; }
  // Moves the dragger to an iso level, limited to [kMinIso, kMaxIso]. Does not call `changed`.
  void setValue(float iso);
  Vec3 handle() const;  // middle of the dragger, world, m
  // Shows or hides the scale and the dragger. While they are hidden, the dragger cannot be dragged.
  void show(bool shown);
  bool shown() const;
  void moveTo(const Vec3& foot);  // foot: the new lower end; world, m

  std::function<void(float)> changed;  // called with the new value when the user moves the dragger

 private:
  static void dragged(void* self, SoDragger* dragger);
  void write();

  SoSeparator* parent_;
  SoSwitch* root_;
  SoTransform* place_;
  SoTranslate1Dragger* dragger_;
  SoText3* text_;
  Vec3 foot_;
  float value_ = 50;
  bool writing_ = false;
};

}  // namespace resect
