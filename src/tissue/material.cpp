#include "tissue/material.h"

#include <algorithm>
#include <cmath>

#include "tissue/elastic/kernel/elastic_kernel.h"

namespace resect {
namespace {

TissueMaterial ofShear(const char* name, double shear, double tearEnergy) {
  TissueMaterial material;
  material.name = name;
  material.young = 2 * (1 + material.poisson) * shear;
  material.tearEnergy = tearEnergy;
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

double heldEnergy(const TissueMaterial& m, const Mat3& f) {
  const double growth = f.determinant() - 1, x = f.squaredNorm() - 3 - 2 * growth;
  const double b = m.stiffening, volume = (m.lame() + m.shear()) / 2 * growth * growth;
  if (b == 0 || x <= 0) return m.shear() / 2 * x + volume;
  const double most = std::min(x, kMostStiffening / b);  // from there on it grows no more
  return m.shear() / 2 * (x + b / 2 * most * most + kMostStiffening * (x - most)) + volume;
}

double energyOfStretch(const TissueMaterial& m, double stretch) {
  // The width that takes least energy, by golden section.
  const auto energy = [&](double width) {
    return heldEnergy(m, Vec3(stretch, width, width).asDiagonal());
  };
  const double golden = 0.6180339887498949;
  double low = 0.01, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (energy(a) < energy(b) ? high : low) = energy(a) < energy(b) ? b : a;
  }
  return kTearLength * energy(low);
}

TissueMaterial liverTissue() {
  TissueMaterial liver;
  liver.stiffening = 1;
  liver.capsule = 624;
  liver.capsuleTension = 30;
  liver.cutEnergy = 60;
  liver.capsuleCutEnergy = 0.1;
  liver.branches = {{0.65, 0.58}, {1.15, 0.026}};
  return liver;
}
TissueMaterial tumourTissue() { return ofShear("tumour", 23.4e3, 164); }
TissueMaterial vesselWallTissue() { return ofShear("vessel wall", 210e3, 1000); }
TissueMaterial capsuleTissue() { return ofShear("capsule", 85e3, 1000); }

}  // namespace resect
