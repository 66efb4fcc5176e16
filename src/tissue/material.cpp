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

double TissueMaterial::viscousShear() const {
  double shares = 0;
  for (const Relaxation& branch : branches) shares += branch.share;
  return shares * shear();
}

double TissueMaterial::waveSpeed() const {
  return std::sqrt((lame() + 2 * shear() + 4.0 / 3 * viscousShear()) / density);
}

TissueMaterial liverTissue() {
  TissueMaterial liver;
  liver.stiffening = 1;
  liver.capsule = 624;
  liver.branches = {{0.65, 0.58}, {1.15, 0.026}};
  return liver;
}
TissueMaterial tumourTissue() { return ofShear("tumour", 23.4e3, 1.46); }
TissueMaterial vesselWallTissue() { return ofShear("vessel wall", 210e3, 1.8); }
TissueMaterial capsuleTissue() { return ofShear("capsule", 85e3, 1.35); }

}  // namespace resect
