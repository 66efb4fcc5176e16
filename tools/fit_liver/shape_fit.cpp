#include "shape_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.h"

namespace fit_liver {
namespace {

using resect::Blend;

// The fit works in decimetres, so that every parameter is of order one.
constexpr double kUnit = 0.1;
constexpr int kLanes = 16;
constexpr int kNumbers = 10;  // centre 3, turn 3 (about the own axes), log radius 3, log fillet

using Lane = Eigen::Array<float, kLanes, 1>;
using Numbers = std::array<double, kNumbers>;

struct Constants {
  Eigen::Matrix3f turn;  // own axes -> body
  Eigen::Vector3f centre, radii;
  float fillet;
  bool carve;
};

// What the way forward leaves for the way back, for one ellipsoid and one lane of samples.
struct Trace {
  Lane u[3], q[3], k0, k1, value, before;
};

Constants constants(const Part& part) {
  const auto& e = part.ellipsoid;
  return {Eigen::Quaterniond(e.turn).toRotationMatrix().cast<float>(),
          (e.centre / kUnit).cast<float>(), (e.radii / kUnit).cast<float>(),
          float(e.fillet / kUnit), e.blend == Blend::Carve};
}

// sum[j] += derivative of the lane's loss by the j-th number of each part; returns the loss.
Lane lossOf(std::span<const Constants> parts, const Lane (&p)[3], const Lane& target,
            float waviness, float sharpness, std::vector<Trace>& trace,
            std::vector<std::array<Lane, kNumbers>>& sum) {
  Lane value = Lane::Constant(100.0f);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Constants& c = parts[i];
    Trace& t = trace[i];
    Lane k0 = Lane::Zero(), k1 = Lane::Zero();
    for (int m = 0; m < 3; ++m) {
      t.u[m] = c.turn(0, m) * (p[0] - c.centre[0]) + c.turn(1, m) * (p[1] - c.centre[1]) +
               c.turn(2, m) * (p[2] - c.centre[2]);
      t.q[m] = t.u[m] * (1 / c.radii[m]);
      k0 += t.q[m].square();
      k1 += (t.q[m] * (1 / c.radii[m])).square();
    }
    t.k0 = k0.sqrt().max(1e-6f);
    t.k1 = k1.sqrt().max(1e-6f);
    t.value = t.k0 * (t.k0 - 1) / t.k1;
    t.before = value;
    const float sign = c.carve ? -1.0f : 1.0f;
    const Lane a = sign * value;
    const Lane h = (c.fillet - (a - t.value).abs()).max(0.0f) * (1 / c.fillet);
    value = sign * (a.min(t.value) - h.cube() * (c.fillet / 6));
  }

  const Lane difference = (value * (1 / sharpness)).tanh() - target;
  Lane apart;  // each lane of a pair: its difference less the other one's
  for (int lane = 0; lane < kLanes; ++lane) apart[lane] = difference[lane] - difference[lane ^ 1];
  const Lane loss = difference.square() + 0.5f * waviness * apart.square();
  const Lane slope = 1 - (difference + target).square();
  Lane back = 2 * (difference + waviness * apart) * slope * (1 / sharpness);  // d loss / d value

  for (std::size_t i = parts.size(); i-- > 0;) {
    const Constants& c = parts[i];
    const Trace& t = trace[i];
    auto& s = sum[i];
    const float sign = c.carve ? -1.0f : 1.0f;
    const Lane a = sign * t.before;
    const Lane gap = (a - t.value).abs();
    const Lane h = (c.fillet - gap).max(0.0f) * (1 / c.fillet);
    const Lane half = 0.5f * h.square();  // share of the one that is larger
    const Lane shareOfBody = (a < t.value).select(1 - half, half);
    const Lane g = sign * back;  // d loss / d (sign value)
    s[9] -= g * (h.cube() * (1.0f / 6) + h.square() * gap * (0.5f / c.fillet)) * c.fillet;
    back = back * shareOfBody;
    const Lane gv = g * (1 - shareOfBody);
    // value = (k0^2 - k0) / k1, k0 = |q|, k1 = |q / r|, q = u / r.
    const Lane alongQ = gv * (2 * t.k0 - 1) / (t.k0 * t.k1);
    const Lane alongK1 = gv * t.value / t.k1.square();
    Lane gu[3];
    for (int m = 0; m < 3; ++m) {
      const float inverse = 1 / c.radii[m];
      const Lane gq = alongQ * t.q[m] - alongK1 * t.q[m] * (inverse * inverse);
      gu[m] = gq * inverse;
      s[6 + m] += -gq * t.q[m] + alongK1 * (t.q[m] * inverse).square();
    }
    for (int m = 0; m < 3; ++m) {
      s[m] -= c.turn(m, 0) * gu[0] + c.turn(m, 1) * gu[1] + c.turn(m, 2) * gu[2];
      const int n = (m + 1) % 3, o = (m + 2) % 3;
      s[3 + m] -= t.u[n] * gu[o] - t.u[o] * gu[n];
    }
  }
  return loss;
}

// Moves the part by the step and back into the range it may have.
void movePart(Part& part, const Numbers& step) {
  auto& e = part.ellipsoid;
  e.centre += kUnit * resect::Vec3(step[0], step[1], step[2]);
  const resect::Vec3 away = e.centre - part.home;
  if (away.norm() > part.leash) e.centre = part.home + away * (part.leash / away.norm());
  const resect::Vec3 w(step[3], step[4], step[5]);
  const double angle = w.norm();
  if (angle > 0)
    e.turn =
        (Eigen::Quaterniond(e.turn) * Eigen::AngleAxisd(angle, w / angle)).normalized().coeffs();
  for (int m = 0; m < 3; ++m)
    e.radii[m] =
        std::clamp(e.radii[m] * std::exp(step[6 + m]), part.smallestRadius, part.largestRadius);
  // The sharpest rim of an ellipsoid is its least radius squared over its largest.
  e.radii = e.radii.cwiseMax(std::sqrt(part.sharpestRim * e.radii.maxCoeff()));
  e.fillet = std::clamp(e.fillet * std::exp(step[9]), part.smallestFillet, part.largestFillet);
}

}  // namespace

double fit(std::vector<Part>& parts, std::span<const SamplePair> samples,
           const FitSettings& settings, std::uint64_t seed) {
  constexpr double kMomentum = 0.9, kScale = 0.99, kTiny = 1e-9;
  resect::Random random(seed);
  std::vector<Constants> fixed(parts.size());
  std::vector<Trace> trace(parts.size());
  std::vector<std::array<Lane, kNumbers>> sum(parts.size());
  std::vector<Numbers> mean(parts.size(), Numbers{}), square(parts.size(), Numbers{});
  double tail = 0;
  int tailSteps = 0;
  for (int step = 0; step < settings.steps; ++step) {
    const double progress = double(step) / settings.steps;
    const float sharpness =
        float(settings.sharpnessFirst / kUnit *
              std::pow(settings.sharpnessLast / settings.sharpnessFirst, progress));
    const double rate = settings.rate * 0.5 * (1 + std::cos(3.14159265358979 * progress)) + 2e-5;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      fixed[i] = constants(parts[i]);
      sum[i].fill(Lane::Zero());
    }
    double loss = 0;
    for (int done = 0; done < settings.batch; done += kLanes) {
      Lane p[3], target;
      const SamplePair* pair = nullptr;
      for (int lane = 0; lane < kLanes; ++lane) {
        if (lane % 2 == 0) pair = &samples[random.below(int(samples.size()))];
        const Sample& s = (*pair)[lane % 2];
        for (int m = 0; m < 3; ++m) p[m][lane] = float(s.point[m] / kUnit);
        target[lane] = float(s.distance / kUnit);
      }
      target = (target * (1 / sharpness)).tanh();
      loss += lossOf(fixed, p, target, float(settings.waviness), sharpness, trace, sum).sum();
    }
    loss /= settings.batch;
    if (progress >= 0.9) tail += loss, ++tailSteps;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].held) continue;
      Numbers change;
      for (int j = 0; j < kNumbers; ++j) {
        const double g = double(sum[i][j].sum()) / settings.batch;
        mean[i][j] += (1 - kMomentum) * (g - mean[i][j]);
        square[i][j] += (1 - kScale) * (g * g - square[i][j]);
        const double m = mean[i][j] / (1 - std::pow(kMomentum, step + 1));
        const double v = square[i][j] / (1 - std::pow(kScale, step + 1));
        change[j] = -rate * m / (std::sqrt(v) + kTiny);
      }
      movePart(parts[i], change);
    }
  }
  return tail / std::max(tailSteps, 1);
}

resect::BlendedShape shapeOf(std::span<const Part> parts) {
  std::vector<resect::BlendedEllipsoid> ellipsoids;
  for (const Part& part : parts) ellipsoids.push_back(part.ellipsoid);
  return resect::BlendedShape(ellipsoids);
}

}  // namespace fit_liver
