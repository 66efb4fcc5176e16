// A dragger that sets the iso level, on a scale in the scene, as in the original thesis. The value
// is written above the scale.
#pragma once

#include <functional>

#include "base/vec.h"

class SoDragger;
class SoSeparator;
class SoText3;
class SoTranslate1Dragger;

namespace resect {

class IsoDragger {
 public:
  // `foot`: lower end of the scale, which is vertical; world, m.
  IsoDragger(SoSeparator* parent, const Vec3& foot);
  ~IsoDragger();
  IsoDragger(const IsoDragger&) = delete;
  IsoDragger& operator=(const IsoDragger&) = delete;

  float value() const { return value_; }
  // The value is clamped to [kMinIso, kMaxIso]; `changed` is not called.
  void setValue(float iso);
  Vec3 handle() const;  // middle of the dragger, world, m

  std::function<void(float)> changed;  // called with the value after a person moved the dragger

 private:
  static void dragged(void* self, SoDragger* dragger);
  void write();

  SoSeparator* parent_;
  SoSeparator* root_;
  SoTranslate1Dragger* dragger_;
  SoText3* text_;
  Vec3 foot_;
  float value_ = 50;
  bool writing_ = false;
};

}  // namespace resect
