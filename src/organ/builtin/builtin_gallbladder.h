// The built-in gallbladder, as a signed function and as a mesh.
//
// A filled gallbladder of our own making, in the coordinates of the built-in liver: metres, Y up,
// +Z anterior, +X the patient's left. From its closed end to its outlet, it consists of the fundus,
// the body, the infundibulum (a funnel with a bulge, Hartmann's pouch), the neck, and a stump of
// the cystic duct. The gallbladder lies in the gallbladder fossa, a hollow of the liver. Its shape
// is clipped by the liver: where the gallbladder would enter the liver, its wall runs a fifth of a
// millimetre outside the liver's surface. The fundus extends beyond the lower edge (inferior
// margin) of the liver. The neck bends down and to the left towards the porta hepatis, where
// vessels enter the liver. The size is that of an adult's gallbladder: 7 to 10 cm long, about 3.5
// cm wide, 30 to 50 ml (Gray's Anatomy, ed. Standring, 2016). docs/methods/builtin_liver.md has the
// exact figures of this gallbladder.
#pragma once

#include "geometry/triangle_mesh.h"

namespace resect {

// Signed value, m, at the point p, m: negative inside. Within a few millimetres of the surface, the
// value is close to the distance from the surface. Farther away only the sign has a meaning. Cost:
// about half a microsecond.
double builtinGallbladderDistance(const Vec3& p);

// The gallbladder's surface: closed, oriented outwards, one piece of genus 0. Most triangles have
// no edge that is longer than `edge`, which is 0.0005 to 0.0025 m. At 1.5 mm there are some 12 000
// triangles.
TriangleMesh builtinGallbladder(double edge = 0.0015);

}  // namespace resect
