// Breathing: the motion of the diaphragm. The diaphragm moves the ligaments from which organs hang,
// and the table on which organs lie.
//
// A breath leads from the end of an exhalation (phase 0) to the end of the next exhalation (phase
// 1). The diaphragm's displacement is depth * sin^(2 n)(pi * phase) with n = 2, towards the
// patient's feet (+Z). Most of a breath is thus spent near the end of exhalation, as in patients.
// The waveform is that of Lujan, Larsen, Balter and Ten Haken, Med. Phys. 26, 715 (1999),
// doi.org/10.1118/1.598577.
#pragma once

#include "base/vec.h"

namespace resect {

// How the patient breathes.
struct Breathing {
  double depth = 0;       // diaphragm's displacement at the end of inhalation, m; 0: no motion
  double perMinute = 12;  // breaths per minute
  // Motion of the table divided by the motion of the diaphragm, 0 to 1. The table stands for the
  // organs under the liver, which move less than the diaphragm.
  double bed = 0.8;
  bool begins = true;  // whether the first breath begins at the start of the operation

  template <class Visitor>
  void visit(Visitor& v) {
    v("depth", depth), v("perMinute", perMinute), v("bed", bed), v("begins", begins);
  }
};

// Where in a breath the patient is.
struct Breath {
  double phase = 0;  // 0 to below 1
  // True: the patient breathes. False: the patient finishes the breath that has begun, and then
  // stops breathing.
  bool on = true;

  template <class Visitor>
  void visit(Visitor& v) {
    v("phase", phase), v("on", on);
  }
};

// The diaphragm's motion in one frame. share: a time in the frame, from 0 (its start) to 1.
struct BreathMotion {
  double depth = 0;         // m
  double from = 0, to = 0;  // phases at the frame's start and end; `to` may be above 1
  double duration = 0;      // of the frame, s; 0: no motion

  Vec3 displacement(double share) const;  // m
  Vec3 velocity(double share) const;      // m/s
};

// Displacement of the diaphragm divided by Breathing::depth, 0 to 1. phase: as in Breath.
double breathWave(double phase);

// Advances `breath` by a frame, and returns the motion in this frame. duration: s, above 0.
BreathMotion breathe(const Breathing& breathing, Breath& breath, double duration);

}  // namespace resect
