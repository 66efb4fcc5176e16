// The built-in human liver, as a signed function and as a mesh.
//
// The liver is computed from a formula, so that nothing has to be downloaded. It has a right and a
// left lobe. Its diaphragmatic face, at the top and in front, is domed. Its visceral face, on the
// underside, is hollow, and has three further hollows: the gallbladder fossa, the umbilical fissure
// and the groove of the vena cava. The inferior margin, the edge between the two faces, is sharp.
// The formula blends ellipsoids that tools/fit_liver fitted to the liver of the Visible Human Male.
// docs/methods/builtin_liver.md describes the fit and its error. The volume is about 1.6 l. The
// liver's centre is near the origin. Coordinates are in metres: Y up, +Z anterior, +X the patient's
// left.
#pragma once

#include "anatomy/growth/vessel_growth.h"
#include "geometry/triangle_mesh.h"

namespace resect {

// Signed value, m, at the point p, m: negative inside. Within a few millimetres of the surface, the
// value is close to the distance from the surface. Farther away only the sign has a meaning. Cost:
// about a third of a microsecond.
double builtinLiverDistance(const Vec3& p);

// The liver's surface: closed, oriented outwards, one piece of genus 0. Most triangles have no edge
// that is longer than `edge`, which is 0.0005 to 0.005 m. At 2.5 mm there are some 60 000
// triangles, computed in a fraction of a second.
TriangleMesh builtinLiver(double edge = 0.0025);

// Input for growing the liver's vessels: the places where vessels enter and leave the liver, and
// the random seed. The hilum, where the portal vein enters the liver, and the vena cava lie as in
// the Visible Human Male. Of five seeds, the chosen one lets the hepatic artery and the bile
// duct reach the largest number of terminals (ends of the portal vein's branches).
VesselGrowth builtinLiverVessels();

}  // namespace resect
