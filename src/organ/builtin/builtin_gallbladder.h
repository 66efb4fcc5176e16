// The built-in gallbladder, as a signed function and as a mesh.
//
// A filled gallbladder of our own making, in the coordinates of the built-in liver: fundus, body,
// infundibulum with its pouch (Hartmann), neck, and a stump of the cystic duct. It lies in the
// gallbladder fossa and is shaped by it: where it would enter the liver, its wall runs a fifth of a
// millimetre outside the liver's surface instead. The fundus extends beyond the inferior margin;
// the neck bends down and to the left towards the porta hepatis. It has the size of an adult's: 7
// to 10 cm long, about 3.5 cm wide, 30 to 50 ml (Gray's Anatomy, ed. Standring, 2016);
// docs/methods/builtin_liver.md has the exact figures of this one. In metres, Y up, +Z anterior, +X
// the patient's left.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// Signed value, m, at the point p, m: negative inside. Within a few millimetres of the surface it
// is close to the distance; farther away only its sign has a meaning. Cost: about half a
// microsecond.
double builtinGallbladderDistance(const Vec3& p);

// Its surface: closed, oriented outwards, one piece of genus 0. `edge`, 0.0005 to 0.0025 m, is the
// longest edge of most triangles; at 1.5 mm there are some 12 000 triangles.
TriangleMesh builtinGallbladder(double edge = 0.0015);

}  // namespace resect
