// Colour and gloss of an instrument's surface, as the Material node of Open Inventor gives them.
#pragma once

#include "base/vec.h"

namespace resect {

// Each number is from 0 to 1. The defaults describe the steel of the scissors that come with
// Resect.
struct Finish {
  Vec3f diffuse{0.62f, 0.63f, 0.65f};
  Vec3f specular{0.65f, 0.65f, 0.67f};
  float shininess = 0.4f;  // 1 is OpenGL's exponent 128

  template <class Visitor>
  void visit(Visitor& v) {
    v("diffuse", diffuse), v("specular", specular), v("shininess", shininess);
  }
};

}  // namespace resect
