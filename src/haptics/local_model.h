// The local model of an instrument. The haptic loop (1 kHz) computes the force on the hand from
// this model until the simulation has computed the next frame.
//
// After each frame a new model is made from the contact points and grips of the instrument
// (tissue/touch.h). The model contains the force on the instrument, contact planes that stand for
// the tissue it touches (ContactPlane), and how the force changes when the instrument moves. The
// model has a fixed size, so that it can be passed through a TripleBuffer without allocating
// memory. docs/methods/haptics.md derives the stiffness. Units are m, N and s; coordinates are in
// the world. Making a model takes as much time as the contact of one instrument takes in one time
// step of the tissue.
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

// Model of tissue that pushes the instrument in one direction, and never pulls.
struct ContactPlane {
  Vec3 place = Vec3::Zero();    // centre of pressure
  Vec3 normal = Vec3::UnitY();  // unit: direction in which the tissue pushes the instrument
  double force = 0;             // force along `normal` at LocalModel::pose, N
  double stiffness = 0;         // N/m, along the normal
  double damping = 0;           // N s/m, along the normal
};

struct LocalModel {
  std::int64_t frame = -1;  // number of the simulated frame, from 0; -1: no frame yet
  double time = 0;          // simulated time at the end of the frame, s
  double duration = 0;      // duration of the frame, s
  bool inHand = false;      // the instrument is in a hand; if not, all fields after `pose` are 0
  Pose pose;                // pose of the simulated instrument at the end of the frame
  // Velocity (m/s) and spin (rad/s) of the simulated instrument, averaged over the frame.
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();

  // Force of the tissue on the instrument at `pose`, N, and the torque of this force about
  // pose.position, N m.
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();

  std::int32_t planeCount = 0;
  std::array<ContactPlane, kMostPlanes> planes;

  // The rest of the force, N: `force` minus the forces of all planes. If there are planes and no
  // grip, the rest is friction. Then forceAt() (haptics/force_renderer.h) limits the rest to
  // `friction` times the sum of the planes' forces. In all other cases the rest is the force on a
  // blade or a grip.
  Vec3 rest = Vec3::Zero();
  Vec3 restPlace = Vec3::Zero();  // point at which `rest` acts
  // Change of `rest` with the instrument's position, N/m. If there are planes and no grip, only
  // motion along the planes changes `rest`. In all other cases motion in any direction does.
  double restStiffness = 0;
  double friction = 0;  // Coulomb's coefficient of friction
  bool held = false;    // the instrument grips tissue

  // Tangent stiffness -dF/dx for translations of the instrument, N/m. It holds while all planes
  // stay in contact and nothing slides. The matrix is symmetric and positive semidefinite.
  Mat3 stiffness = Mat3::Zero();
};

// The motion of an instrument in a frame, and the force on it.
struct InstrumentFrame {
  Pose from, to;               // world poses at the start and at the end of the frame
  double duration = 1.0 / 60;  // duration of the frame, s, > 0
  Vec3 force = Vec3::Zero();   // force of all tissues, averaged over the frame, N
  double friction = 0.3;       // Coulomb's coefficient of friction
};

// Makes a model. The caller must set the model's fields `frame` and `time`. touches: for each
// tissue, the result of TissueModel::touchOf(). Throws Error unless frame.duration is above 0.
LocalModel makeLocalModel(const InstrumentFrame& frame, std::span<const TissueTouch> touches);

// Makes the local models of a simulation. All calls of make() use the same memory.
class LocalModels {
 public:
  // The model of one tool after Simulation::step(). Call this before the next step. tool: number of
  // the tool, from 0. duration: duration of the step's frame, s. Throws Error if there is no such
  // tool, or if the duration is not above 0.
  LocalModel make(const Simulation& simulation, std::size_t tool, double duration);

 private:
  std::vector<TissueTouch> touches_;
};

}  // namespace resect
