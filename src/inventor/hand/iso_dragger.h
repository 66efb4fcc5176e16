// A dragger in the scene that sets the iso level, as in the original thesis. It slides along a
// vertical scale; the value is written above the scale.
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

// A place (world, m) for the lower end of the scale: beside the organ, at the left in the picture,
// where the scale does not hide the organ. towardsCamera: direction from the organ to the camera;
// it is rounded to steps of 10 degrees about the vertical.
Vec3 scaleFoot(const Aabb& organ, const Vec3& towardsCamera);

class IsoDragger {
 public:
  // `foot`: the lower end of the scale, where the iso level is 0; world, m.
  IsoDragger(SoSeparator* parent, const Vec3& foot);
  ~IsoDragger();
  IsoDragger(const IsoDragger&) = delete;
  IsoDragger& operator=(const IsoDragger&) = delete;

  float value() const { return value_; }
  // Moves the dragger without calling `changed`. The value is clamped to [kMinIso, kMaxIso].
  void setValue(float iso);
  Vec3 handle() const;  // middle of the dragger, world, m
  // Hides the scale, so that it can neither be seen nor dragged, or shows it again.
  void show(bool shown);
  bool shown() const;
  void moveTo(const Vec3& foot);  // foot: the new lower end; world, m

  std::function<void(float)> changed;  // called with the new value when a person moved the dragger

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
