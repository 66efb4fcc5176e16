#include "operation/sound/operating_sound.h"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <numbers>

using namespace resect;

namespace {

constexpr int kRate = 44100;

std::vector<float> played(OperatingSound& sound, const AudibleState& state, double seconds,
                          std::size_t block = 512) {
  std::vector<float> samples(std::size_t(seconds * kRate));
  for (std::size_t i = 0; i < samples.size(); i += block)
    sound.fill(state, std::span(samples).subspan(i, std::min(block, samples.size() - i)));
  return samples;
}

// Amplitude of the tone of this frequency.
double toneIn(std::span<const float> samples, double hertz) {
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    sum += double(samples[i]) * std::polar(1.0, -2 * std::numbers::pi * hertz * double(i) / kRate);
  return 2 * std::abs(sum) / double(samples.size());
}

double largestStep(std::span<const float> samples) {
  double most = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    most = std::max(most, double(std::abs(samples[i] - samples[i - 1])));
  return most;
}

double loudness(std::span<const float> samples) {
  double sum = 0;
  for (const float s : samples) sum += double(s) * double(s);
  return std::sqrt(sum / double(samples.size()));
}

}  // namespace

TEST_CASE("without a device in use and without a monitor nothing is heard") {
  OperatingSound sound(kRate);
  for (const float s : played(sound, {}, 1)) CHECK(s == 0);
}

TEST_CASE("each device has a tone of its own, which ends with its use without a click") {
  OperatingSound sound(kRate);
  const auto cutting = played(sound, {.cutting = true}, 1);
  CHECK(toneIn(cutting, 660) > 0.03);
  CHECK(toneIn(cutting, 660) > 20 * toneIn(cutting, 440));
  const auto after = played(sound, {}, 1);
  CHECK(largestStep(after) < 1.2 * largestStep(cutting));
  CHECK(loudness(std::span(after).last(kRate / 2)) < 1e-4);
  const auto coagulating = played(sound, {.coagulating = true}, 1);
  CHECK(toneIn(coagulating, 440) > 0.03);
  CHECK(toneIn(coagulating, 440) > 20 * toneIn(coagulating, 660));
  const auto suction = played(sound, {.suction = true}, 1);
  CHECK(loudness(suction) > 0.01);
  CHECK(toneIn(suction, 660) < 0.005);  // noise
}

TEST_CASE("the monitor beeps once for each beat of the heart") {
  for (const double rate : {70.0, 120.0}) {
    OperatingSound sound(kRate);
    const auto samples = played(sound, {.heartRate = rate}, 30);
    int beeps = 0;
    std::size_t quiet = std::size_t(kRate);
    for (const float s : samples) {
      if (std::abs(s) > 0.05f) beeps += quiet > kRate / 10, quiet = 0;
      ++quiet;
    }
    CHECK(std::abs(beeps - int(rate / 2)) <= 1);
  }
}

TEST_CASE("all sounds together stay in range, and the size of blocks does not matter") {
  const AudibleState all{true, true, true, true, 140};
  OperatingSound a(kRate), b(kRate);
  const auto whole = played(a, all, 3), parts = played(b, all, 3, 77);
  CHECK(whole == parts);
  for (const float s : whole) REQUIRE(std::abs(s) < 0.9f);
}

TEST_CASE("the heart beats faster the more blood is lost") {
  CHECK(heartRateAfter(0) == 70);
  CHECK(heartRateAfter(375e-6) == doctest::Approx(85));
  CHECK(heartRateAfter(750e-6) == doctest::Approx(100));
  CHECK(heartRateAfter(1500e-6) == doctest::Approx(120));
  CHECK(heartRateAfter(3000e-6) == 140);
}

TEST_CASE("what is heard follows the instruments in hand, their pedals and jaws") {
  LiveState state;
  std::vector<ToolModel> tools(3);
  tools[0].kind = "suction", tools[1].kind = "pencil", tools[2].kind = "bipolar";
  state.inHand = {0, 0, 0}, state.touching = {0, 1, 0};
  state.squeeze = {0, 0, 1};
  CHECK(audibleState(state, tools, -1) == AudibleState{});
  state.inHand = {1, 0, 0};
  CHECK(audibleState(state, tools, -1) == AudibleState{.suction = true});
  state.inHand = {0, 1, 0};
  CHECK(audibleState(state, tools, -1) == AudibleState{.cutting = true});
  CHECK(audibleState(state, tools, 1) == AudibleState{.coagulating = true});
  state.inHand = {0, 0, 1};
  CHECK(audibleState(state, tools, -1) == AudibleState{.coagulating = true});
  state.squeeze[2] = 0;
  state.bleeds = true, state.bled = 750e-6;
  CHECK(audibleState(state, tools, -1) == AudibleState{.heartRate = 100});
  // A motion that plays brings its own pedals.
  state.inHand = {0, 1, 0};
  state.played.resize(3);
  state.played[1].pedal = 1;
  CHECK(audibleState(state, tools, -1).coagulating);
}
