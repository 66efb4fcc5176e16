// The local model of an instrument: a loop of 1 kHz computes the force on the hand from it until
// the simulation has computed its next frame.
//
// The model is made after each frame from the contact points and grips of the instrument
// (tissue/touch.h). It holds the force on the instrument, the planes that the instrument touches,
// and the change of the force when the instrument moves. Its size is fixed, so that it can be
// handed over by a TripleBuffer. docs/methods/haptics.md derives the stiffness. World coordinates,
// m, N, s. Cost: as much as one substep spends on the contact points of one instrument.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pose.h"
#include "simulation/simulation.h"
#include "tissue/touch.h"

namespace resect {

inline constexpr int kMostPlanes = 8;

// Tissue that pushes the instrument one way, and never pulls.
struct ContactPlane {
  Vec3 place = Vec3::Zero();    // centre of pressure
  Vec3 normal = Vec3::UnitY();  // unit: direction in which the tissue pushes the instrument
  double force = 0;             // N, at the model's pose
  double stiffness = 0;         // N/m, along the normal
  double damping = 0;           // N s/m, along the normal
};

struct LocalModel {
  std::int64_t frame = -1;  // number of the simulated frame, from 0; -1: no frame yet
  double time = 0;          // simulated time at the end of the frame, s
  double duration = 0;      // of the frame, s
  bool inHand = false;      // the instrument is in a hand; if not, all after `pose` is zero
  Pose pose;                // of the instrument in the simulation, at the end of the frame
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();  // mean in the frame, m/s and rad/s

  // Force of the tissue on the instrument at `pose`, N; its torque about pose.position, N m.
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();

  std::int32_t planeCount = 0;
  std::array<ContactPlane, kMostPlanes> planes;

  // The rest of the force: `force` minus the forces of the planes. If there are planes and no grip,
  // it is friction, which is at most `friction` times the sum of the planes' forces. Otherwise it
  // is the force on a blade or a grip.
  Vec3 rest = Vec3::Zero();
  Vec3 restPlace = Vec3::Zero();  // where `rest` acts
  double restStiffness = 0;       // N/m, in all directions; if planes and no grip: along the planes
  double friction = 0;            // Coulomb's coefficient
  bool held = false;              // the instrument grips tissue

  // -dF/dx for translations of the instrument, while all planes stay in contact and nothing slides.
  // Symmetric, positive semidefinite, N/m.
  Mat3 stiffness = Mat3::Zero();
};

// The motion of an instrument in a frame, and the force on it.
struct InstrumentFrame {
  Pose from, to;               // at the start and at the end of the frame; world
  double duration = 1.0 / 60;  // s, > 0
  Vec3 force = Vec3::Zero();   // of all tissues on the instrument, mean over the frame, N
  double friction = 0.3;       // Coulomb's coefficient
};

// Makes a model; the caller sets its `frame` and `time`. touches: one per tissue
// (TissueModel::touchOf()). Throws Error unless the duration is above 0.
LocalModel makeLocalModel(const InstrumentFrame& frame, std::span<const TissueTouch> touches);

// Makes the local models of a simulation. It reuses its memory from call to call.
class LocalModels {
 public:
  // The model of tool number `tool`, counted from 0, after a Simulation::step() of `duration`, s.
  // To be called before the next step. Throws Error if there is no such tool, or unless the
  // duration is above 0.
  LocalModel make(const Simulation& simulation, std::size_t tool, double duration);

 private:
  std::vector<TissueTouch> touches_;
};

}  // namespace resect
