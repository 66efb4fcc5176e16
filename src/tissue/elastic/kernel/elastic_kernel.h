// The kernels of elastic tissue: two passes over the cells for each substep, and a third for those
// who read the result; compiled for several instruction sets.
//
// Total-Lagrangian SPH with corrected gradient and bond penalty (Ganzenmueller 2015 in the energy
// form of docs/methods/tissue.md). Each cell only gathers, every lane does the same operations in
// the same order, and code paths are chosen for kChunk cells at a time, so the results depend
// neither on the instruction set nor on the number of threads.
#pragma once

#include <cstddef>

#include "tissue/elastic/elastic_state.h"

namespace resect {

// Limit of |cof F|^2, which is 3 at rest: beyond it the response to volume change is reduced in
// proportion, so that one length of substep is stable for any deformation.
inline constexpr float kMostStiffening = 6;

// Speeds below this are set to zero (m/s). The front of a wave enters tissue at rest as ever
// smaller numbers; as denormals they would make a pass ten times slower, and machines flush
// denormals in different ways or not at all.
inline constexpr float kAtRest = 1e-12f;

// Constants of a substep that both passes read.
struct SubstepConstants {
  float faceShare = 0;         // weight of a face neighbour (tissue/stencil.h) over an edge one's
  float cornerShare = 0;       // the same of a corner neighbour
  float edgePerLength = 0;     // an edge neighbour's weight over the spacing, 1/m
  float bondStiffness = 0;     // twice that weight over the spacing squared, 1/m^2
  float dt = 0;                // s
  float lookAhead = 0;         // beta dt, s
  float keep = 1;              // factor of the velocity per substep by drag
  float gravity[3] = {};       // m/s^2
  float mostSpeedSquared = 0;  // faster counts as exploded, m^2/s^2
};

// The arrays of an ElasticState by address.
struct ElasticView {
  float *u[3], *ahead[3], *v[3], *stress[9], *bondForce[3];
  const float *inverseMoment[6], *skew[3], *planeWeight[3], *load[3];
  const float *inverseMass, *shearVolume, *lameVolume, *kappa;
  const std::uint32_t* bonds;
  const std::uint8_t* held;
  const TissueChunk* chunks;
  std::int32_t step[kDirections];
};
ElasticView viewOf(ElasticState& state);

struct ElasticKernel {
  const char* name;
  // For chunks [begin, end): stress and bondForce from `ahead`.
  void (*stressPass)(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                     std::size_t end);
  // Then v, u and `ahead` from them; false if a speed is beyond the limit or NaN.
  bool (*motionPass)(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                     std::size_t end);
  // Displacement (rows 0 to 2 of `out`) and gradient of displacement (then, row by row) of the
  // `wanted` of kChunk cells from `start` on, a multiple of kChunk; bit n: cell start + n. Others
  // may be written. weight: by kind of neighbour, over that of an edge neighbour.
  void (*placements)(const ElasticView& s, const float weight[4], std::int32_t start,
                     std::uint32_t wanted, float (*out)[kChunk]);
};

// The fastest kernel for this machine; and by name ("baseline", "avx2", "avx512"; null if the
// machine lacks its instructions).
const ElasticKernel& fastestKernel();
const ElasticKernel* kernelNamed(const char* name);

}  // namespace resect
