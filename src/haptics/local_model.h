// The local model of an instrument: what a loop of 1 kHz needs to know of a contact until the
// simulation has computed its next frame.
//
// It is made after a frame from what contact knows (tissue/touch.h): the force on the instrument,
// the planes that it touches, and how the force changes when it moves. Its size is fixed, so it
// goes through a TripleBuffer. docs/methods/haptics.md derives the stiffness. World coordinates, m,
// N, s. Cost: that of one substep for the points of one instrument.
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
  Vec3 place = Vec3::Zero();    // centre of the pressure
  Vec3 normal = Vec3::UnitY();  // unit: the way in which the tissue pushes the instrument
  double force = 0;             // N, at the model's pose
  double stiffness = 0;         // N/m, along the normal
  double damping = 0;           // N s/m, along the normal
};

struct LocalModel {
  std::int64_t frame = -1;  // of the simulation; -1: no frame yet
  double time = 0;          // at the end of the frame, s
  double duration = 0;      // of the frame, s
  bool inHand = false;      // false: all that follows the pose is zero
  Pose pose;                // of the instrument in the simulation, at the end of the frame
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();  // of the instrument in the frame, rad/s

  // Force of the tissue on the instrument at the pose; its torque about the pose's position, N m.
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();

  std::int32_t planeCount = 0;
  std::array<ContactPlane, kMostPlanes> planes;

  // The rest of the force: all that the planes do not explain. If there are planes and no grip it
  // is friction, which is at most `friction` times the planes' forces. Otherwise it is what a blade
  // or a grip feels.
  Vec3 rest = Vec3::Zero();
  Vec3 restPlace = Vec3::Zero();  // where it acts
  double restStiffness = 0;       // N/m, in all directions; with planes: along them
  double friction = 0;            // Coulomb's coefficient
  bool held = false;              // the instrument grips tissue

  // How the force changes when the instrument moves without turning, -dF/dx, while all planes touch
  // and nothing slides. Symmetric, positive semidefinite, N/m.
  Mat3 stiffness = Mat3::Zero();
};

// An instrument in a frame.
struct InstrumentFrame {
  Pose from, to;               // at its start and at its end
  double duration = 1.0 / 60;  // s, > 0
  Vec3 force = Vec3::Zero();   // of all tissues on the instrument, mean over the frame, N
  double friction = 0.3;       // Coulomb's coefficient
};

// touches: one per tissue (TissueModel::touchOf()). Throws Error if the duration is not above 0.
LocalModel makeLocalModel(const InstrumentFrame& frame, std::span<const TissueTouch> touches);

// Makes the local models of a simulation, using its memory again and again.
class LocalModels {
 public:
  // The model of tool number `tool` after Simulation::step() with a frame of `duration` s. To be
  // called before the next step. Throws Error if there is no such tool, or the duration is not
  // above 0.
  LocalModel make(const Simulation& simulation, std::size_t tool, double duration);

 private:
  std::vector<TissueTouch> touches_;
};

}  // namespace resect
