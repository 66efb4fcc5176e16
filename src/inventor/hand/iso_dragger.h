// Where in the scene is the iso level set, as in the original thesis? A dragger on a scale, with
// its value written beside it.
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
  // `foot`: the lower end of the upright scale, world, m.
  IsoDragger(SoSeparator* parent, const Vec3& foot);
  ~IsoDragger();
  IsoDragger(const IsoDragger&) = delete;
  IsoDragger& operator=(const IsoDragger&) = delete;

  float value() const { return value_; }
  // kMinIso to kMaxIso; beyond them the nearer.
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
