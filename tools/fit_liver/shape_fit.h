// Fits the parameters of a blended shape to a measured one.
//
// Adam (Kingma, Ba 2015) on the mean squared difference of tanh(value / sharpness) between shape
// and measurement, with the exact derivative of every ellipsoid's centre, turn, radii and fillet,
// found backwards through the chain of blends. Deterministic: one thread, one seed.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "organ/builtin/blended_shape.h"

namespace fit_liver {

// Two points a few millimetres apart. Their errors count, and so does the difference of the errors:
// a shape that runs beside the measured one looks right, one that waves around it looks lumpy.
struct Sample {
  resect::Vec3 point;  // m
  double distance;     // signed, m
};
using SamplePair = std::array<Sample, 2>;

// One ellipsoid with what the fit may do to it.
struct Part {
  resect::BlendedEllipsoid ellipsoid;
  std::string name;  // what a surgeon would call it; empty for a plain piece of the body
  double smallestRadius = 0.012, largestRadius = 0.2;
  double sharpestRim = 0.0005;  // m: least radius of curvature
  double smallestFillet = 0.008, largestFillet = 0.06;
  bool held = false;                         // given, not fitted
  double leash = 1;                          // m: how far the centre may go from ...
  resect::Vec3 home = resect::Vec3::Zero();  // ... here
};

struct FitSettings {
  int steps = 1000;
  int batch = 4096;               // samples a step
  double rate = 0.01;             // step of the parameters, in decimetres, radians and logarithms
  double waviness = 8;            // weight of the differences within the pairs
  double sharpnessFirst = 0.012;  // m: how far from the surface errors count, at the first ...
  double sharpnessLast = 0.004;   // ... and the last step
};

// Changes the parts in place; returns the mean loss over the last tenth of the steps.
double fit(std::vector<Part>& parts, std::span<const SamplePair> samples,
           const FitSettings& settings, std::uint64_t seed);

resect::BlendedShape shapeOf(std::span<const Part> parts);

}  // namespace fit_liver
