// The built-in gallbladder, as a signed function and as a mesh.
//
// A filled gallbladder of our own making, in the coordinates of the built-in liver: fundus, body,
// infundibulum with its pouch (Hartmann), neck, and a stump of the cystic duct. It lies in the
// gallbladder fossa and is shaped by it: where it would enter the liver its wall follows the bed at
// a distance of a fifth of a millimetre. The fundus extends beyond the inferior margin, the neck
// bends down and to the left towards the porta hepatis. Size as in the adult, 7 to 10 cm long,
// about 3.5 cm wide, 30 to 50 ml (Gray's Anatomy, ed. Standring, 2016);
// docs/methods/builtin_liver.md has its own figures. In metres, Y up, +Z anterior, +X the patient's
// left.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// Signed value at p (m), m: negative inside; close to the distance within a few millimetres of the
// surface, only its sign means something farther away. About half a microsecond.
double builtinGallbladderDistance(const Vec3& p);

// Its surface: closed, oriented outwards, one piece of genus 0. `edge`, 0.0005 to 0.0025 m, is the
// longest edge of most triangles; at 1.5 mm there are some 12 000.
TriangleMesh builtinGallbladder(double edge = 0.0015);

}  // namespace resect
