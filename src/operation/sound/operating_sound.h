// The sounds of an operating room as samples: suction, energy devices, and the monitor's beep at
// each beat of the heart. All are made of noise and tones.
#pragma once

#include <span>
#include <vector>

#include "base/random.h"
#include "operation/live/live_state.h"

namespace resect {

// What is heard at a moment.
struct AudibleState {
  bool suction = false;      // a suction tube is in hand
  bool cutting = false;      // an electrosurgical pencil cuts
  bool coagulating = false;  // a pencil or bipolar forceps coagulate
  bool aspirating = false;   // an ultrasonic aspirator takes tissue
  double heartRate = 0;      // beats per minute; 0: no monitor is heard

  bool operator==(const AudibleState&) const = default;
};

// tools: one model per tool of the state. pedalled: number of the tool whose pedal the user
// presses; -1: none. If LiveState::played is not empty, the pedals in it are used instead. The
// monitor is heard if any organ has vessels.
AudibleState audibleState(const LiveState& state, std::span<const ToolModel> tools, int pedalled);

// Heart rate of an adult who has lost this volume of blood, m^3; beats per minute, 70 to 140. It is
// 100, 120 and 140 at the borders of the classes of haemorrhage (750, 1500 and 2000 ml; American
// College of Surgeons, Advanced Trauma Life Support), and linear in between.
double heartRateAfter(double bled);

// Makes samples, block after block. Sounds swell and fade within some 30 ms, to avoid clicks.
class OperatingSound {
 public:
  explicit OperatingSound(int samplesPerSecond) : rate_(samplesPerSecond) {}
  // Fills `samples` with the sound that follows the last block; one channel, -1 to 1.
  void fill(const AudibleState& state, std::span<float> samples);

 private:
  double rate_;
  Random random_{1};
  double suction_ = 0, cutting_ = 0, coagulating_ = 0, aspirating_ = 0;  // present loudness, 0 to 1
  double low_ = 0, band_ = 0;  // state of the noise's filter
  double time_ = 0;            // s, of the tones; falls back to 0 every second
  double beat_ = 0;            // beats since the last beep
  double beep_ = 1;            // s since the last beep began
};

}  // namespace resect
