#include "tissue/material.h"

#include <cmath>

namespace resect {
namespace {

TissueMaterial ofShear(const char* name, double shear, double tearStretch) {
  TissueMaterial material;
  material.name = name;
  material.young = 2 * (1 + material.poisson) * shear;
  material.tearStretch = tearStretch;
  return material;
}

}  // namespace

double TissueMaterial::waveSpeed() const { return std::sqrt((lame() + 2 * shear()) / density); }

TissueMaterial liverTissue() { return {}; }
TissueMaterial tumourTissue() { return ofShear("tumour", 23.4e3, 1.46); }
TissueMaterial vesselWallTissue() { return ofShear("vessel wall", 210e3, 1.8); }
TissueMaterial capsuleTissue() { return ofShear("capsule", 85e3, 1.35); }

}  // namespace resect
