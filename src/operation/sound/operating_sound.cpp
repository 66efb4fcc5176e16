#include "operation/sound/operating_sound.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "base/elementary.h"

namespace resect {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kFade = 0.03;  // s
// Loudness of each sound. The monitor is heard over the others.
constexpr double kSuction = 0.10, kCutting = 0.05, kCoagulating = 0.05, kAspirating = 0.05,
                 kMonitor = 0.12;
// Tones of energy devices, Hz: cutting is higher than coagulating, as users of real devices expect.
// All are whole numbers, so that they go on smoothly when time_ falls back by a second.
constexpr double kCutTone = 660, kCoagTone = 440, kAspiratorTone = 190;
constexpr double kBeepTone = 880, kBeep = 0.09, kBeepEdge = 0.008;  // Hz, s, s

// A tone with the first overtones, softer than a square wave.
double buzz(double hertz, double time) {
  const double phase = kTurn * hertz * time;
  return math::sin(phase) + math::sin(3 * phase) / 4 + math::sin(5 * phase) / 10;
}

}  // namespace

AudibleState audibleState(const LiveState& state, std::span<const ToolModel> tools, int pedalled) {
  AudibleState heard;
  heard.heartRate = state.bleeds ? heartRateAfter(state.bled) : 0;
  for (std::size_t i = 0; i < tools.size() && i < state.inHand.size(); ++i) {
    if (!state.inHand[i]) continue;
    const bool plays = i < state.played.size();
    const bool pedal = plays ? state.played[i].pedal > 0.5 : int(i) == pedalled;
    const double squeeze = plays ? state.played[i].squeeze : state.squeeze[i];
    const bool touches = state.touching[i] != 0;
    const std::string& kind = tools[i].kind;
    heard.suction |= kind == "suction";
    heard.aspirating |= kind == "aspirator" && touches;
    heard.coagulating |= (kind == "pencil" && pedal) || (kind == "bipolar" && squeeze > 0.5);
    heard.cutting |= kind == "pencil" && touches && !pedal;
  }
  return heard;
}

double heartRateAfter(double bled) {
  constexpr struct {
    double ml, rate;
  } kClasses[] = {{0, 70}, {750, 100}, {1500, 120}, {2000, 140}};
  const double ml = 1e6 * bled;
  for (std::size_t i = 1; i < std::size(kClasses); ++i) {
    const auto &a = kClasses[i - 1], &b = kClasses[i];
    if (ml < b.ml) return a.rate + (b.rate - a.rate) * std::max(0.0, ml - a.ml) / (b.ml - a.ml);
  }
  return std::end(kClasses)[-1].rate;
}

void OperatingSound::fill(const AudibleState& state, std::span<float> samples) {
  const double step = 1 / rate_, follow = 1 - math::exp(-step / (kFade / 3));
  // A resonance at 1.1 kHz (state variable filter, Chamberlin 1985), wide enough to sound as air.
  const double tuning = 2 * math::sin(std::numbers::pi * 1100 / rate_), damping = 0.9;
  for (float& sample : samples) {
    const auto approach = [&](double& loudness, bool on) {
      loudness += follow * ((on ? 1.0 : 0.0) - loudness);
      return loudness;
    };
    low_ += tuning * band_;
    band_ += tuning * (random_.uniform(-1, 1) - low_ - damping * band_);
    double sum = kSuction * approach(suction_, state.suction) * band_;
    sum += kCutting * approach(cutting_, state.cutting) * buzz(kCutTone, time_);
    sum += kCoagulating * approach(coagulating_, state.coagulating) * buzz(kCoagTone, time_);
    sum += kAspirating * approach(aspirating_, state.aspirating) *
           (buzz(kAspiratorTone, time_) + band_);
    if (beep_ < kBeep) {
      const double edge = std::min({1.0, beep_ / kBeepEdge, (kBeep - beep_) / kBeepEdge});
      sum += kMonitor * edge * math::sin(kTurn * kBeepTone * beep_);
    }
    beep_ += step;
    beat_ += step * state.heartRate / 60;
    if (beat_ >= 1) beat_ -= 1, beep_ = 0;
    if ((time_ += step) >= 1) time_ -= 1;
    sample = float(std::clamp(sum, -1.0, 1.0));
  }
}

}  // namespace resect
