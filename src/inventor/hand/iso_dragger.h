// The iso level's dragger on a scale in the scene, as in the original thesis, with its value
// written beside it.
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
  // `foot`: lower end of the vertical scale, world, m.
  IsoDragger(SoSeparator* parent, const Vec3& foot);
  ~IsoDragger();
  IsoDragger(const IsoDragger&) = delete;
  IsoDragger& operator=(const IsoDragger&) = delete;

  float value() const { return value_; }
  // Clamped to kMinIso to kMaxIso.
  void setValue(float iso);
  Vec3 handle() const;  // middle of the dragger, world, m

  std::function<void(float)> changed;  // after the dragger was moved

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
