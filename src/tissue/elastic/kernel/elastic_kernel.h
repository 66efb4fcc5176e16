// The kernels of elastic tissue: the two passes over the cells for each substep, and a function
// that gives the placements (displacement and gradient) of cells. The kernels are compiled for
// several instruction sets.
//
// The method is total-Lagrangian SPH with corrected gradient and bond penalty (Ganzenmueller 2015),
// in the energy form of docs/methods/tissue.md. The computation of a cell reads data of its
// neighbours, but writes only data of this cell. Every SIMD lane does the same operations in the
// same order, and code paths are chosen for kChunk cells at a time. So the results depend neither
// on the instruction set nor on the number of threads.
#pragma once

#include <cstddef>

#include "tissue/elastic/elastic_state.h"

namespace resect {

// Limit of |cof F|^2, where cof F is the cofactor matrix of F; the value at rest is 3. Beyond the
// limit, the response to volume change and the stress of the Maxwell branches are multiplied by the
// factor limit / |cof F|^2. The stiffening b x (tissue/material.h) is multiplied by the square of
// this factor. So one length of the substep is stable for any deformation. Shorter substeps allow a
// higher limit (ElasticTissue::chooseFineness()).
inline constexpr float kCofactorLimit = 6;

// Upper limit of b x in tissue/material.h, the relative growth of the shear modulus.
inline constexpr float kMostStiffening = 3;

// The stress of Maxwell branches changes slowly, so branches are advanced only once in this many
// substeps.
inline constexpr int kSubstepsPerRelaxation = 4;

// Components of velocity up to this size, m/s, are set to zero. At the front of a wave that enters
// tissue at rest, velocities become smaller and smaller until they are denormal numbers. Denormal
// numbers would make a pass ten times slower. Also, not all machines treat denormal numbers alike,
// so the results would depend on the machine.
inline constexpr float kAtRest = 1e-12f;

// Poisson's ratio nu of the capsule, and 1 / (1 - nu^2).
inline constexpr float kCapsulePoisson = 0.5f, kBothWays = 4.0f / 3;

// Constants of a substep that both passes read.
struct SubstepConstants {
  float faceShare = 0;         // weight of a face neighbour / weight of an edge neighbour
  float cornerShare = 0;       // weight of a corner neighbour / weight of an edge neighbour
  float edgePerLength = 0;     // weight of an edge neighbour / spacing, 1/m
  float bondStiffness = 0;     // 2 * weight of an edge neighbour / spacing^2, 1/m^2
  float dt = 0;                // s
  float lookAhead = 0;         // beta dt, s; beta: TissueSettings::damping
  float keep = 1;              // factor on velocities in a substep, for drag
  float gravity[3] = {};       // m/s^2
  float mostSpeedSquared = 0;  // m^2/s^2; if exceeded, tissue has exploded
  float cofactorLimit = kCofactorLimit;      // see kCofactorLimit
  float lessCofactorLimit = kCofactorLimit;  // limit that the next longer substep would have
  // relaxes: whether the stress pass counts stiff cells and advances the Maxwell branches.
  // relaxTime: time by which it advances them, s.
  bool relaxes = false;
  float relaxTime = 0;
};

// beyond: number of cells whose |cof F|^2 exceeds cofactorLimit. beyondLess: number of cells whose
// |cof F|^2 exceeds lessCofactorLimit.
struct StiffCells {
  std::int64_t beyond = 0, beyondLess = 0;
};

// Pointers to the arrays of an ElasticState.
struct ElasticView {
  float *u[3], *ahead[3], *v[3], *stress[9], *bondForce[3];
  float *relaxed[kMostBranches][6], *viscous[6];
  const float *viscousVolume, *branchVolume[kMostBranches], *branchRate[kMostBranches];
  const float* stiffening;
  const float *capsule, *tightness, *skinNormal[3];  // null without a capsule
  int branches;
  const float *inverseMoment[6], *skew[3], *planeWeight[3], *load[3];
  const float *inverseMass, *weight, *shearVolume, *lameVolume, *kappa;
  const std::uint32_t* bonds;
  const std::uint8_t* held;
  const TissueChunk* chunks;
  std::int32_t step[kDirections];
};
ElasticView viewOf(ElasticState& state);

struct ElasticKernel {
  const char* name;
  // For the chunks [begin, end): computes stress and bondForce from `ahead`. If
  // SubstepConstants::relaxes is true, also advances the branches and returns the numbers of stiff
  // cells. If not, returns zeros.
  StiffCells (*stressPass)(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                           std::size_t end);
  // For the chunks [begin, end): computes v, u and `ahead` from stress and bondForce. Returns false
  // if a speed is NaN or exceeds the limit (mostSpeedSquared).
  bool (*motionPass)(const ElasticView& s, const SubstepConstants& c, std::size_t begin,
                     std::size_t end);
  // Writes the placements of the cells of one chunk to `out`: column n belongs to the cell start +
  // n. Rows 0 to 2 are the displacement; rows 3 to 11 are F - I, row by row. start: index in the
  // box, a multiple of kChunk. wanted: bit n is set if the caller needs the cell start + n. Columns
  // that are not wanted may be written too. weight: weights of neighbours, in units of an edge
  // neighbour's weight. Index: neighbourKind() (tissue/stencil.h).
  void (*placements)(const ElasticView& s, const float weight[4], std::int32_t start,
                     std::uint32_t wanted, float (*out)[kChunk]);
};

// fastestKernel(): the fastest kernel that this machine can run. kernelNamed(): the kernel called
// "baseline", "avx2" or "avx512"; null for another name, or if the machine lacks its instructions.
const ElasticKernel& fastestKernel();
const ElasticKernel* kernelNamed(const char* name);

}  // namespace resect
