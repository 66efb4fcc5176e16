// References for the bending tests: Timoshenko's beam, the elastica, and the first frequency of a
// free beam.
#pragma once

#include <Eigen/Dense>
#include <cmath>

namespace resect::test {

struct BeamSection {
  double height, width;   // m; bending is along the height
  double young, poisson;  // Pa, 1
  double inertia() const { return width * height * height * height / 12; }
  double area() const { return width * height; }
  double bending() const { return young * inertia(); }  // E I
  // kappa G A with Cowper's shear coefficient of rectangles (1966).
  double shearing() const {
    const double kappa = 10 * (1 + poisson) / (12 + 11 * poisson);
    return kappa * young / (2 * (1 + poisson)) * area();
  }
};

// Deflection at the tip of a cantilever of that length under a force at its tip.
inline double timoshenkoTip(const BeamSection& b, double length, double force) {
  return force * length * length * length / (3 * b.bending()) + force * length / b.shearing();
}

// Deflection and shortening at the tip of the elastica, in lengths, for the load P L^2 / (E I);
// the load keeps its direction. Shooting with Runge-Kutta steps.
struct ElasticaTip {
  double deflection, shortening;
};
inline ElasticaTip elastica(double load) {
  struct End {
    double slope, x, y;
  };
  const auto shoot = [&](double curvature) {
    constexpr int kSteps = 2000;
    const double ds = 1.0 / kSteps;
    double angle = 0, slope = curvature, x = 0, y = 0;
    for (int i = 0; i < kSteps; ++i) {
      const auto pull = [&](double a) { return -load * std::cos(a); };
      const double k1 = slope, l1 = pull(angle);
      const double k2 = slope + ds / 2 * l1, l2 = pull(angle + ds / 2 * k1);
      const double k3 = slope + ds / 2 * l2, l3 = pull(angle + ds / 2 * k2);
      const double k4 = slope + ds * l3, l4 = pull(angle + ds * k3);
      const double middle = angle + ds / 2 * k2, end = angle + ds / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      x += ds / 6 * (std::cos(angle) + 4 * std::cos(middle) + std::cos(end));
      y += ds / 6 * (std::sin(angle) + 4 * std::sin(middle) + std::sin(end));
      slope += ds / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
      angle = end;
    }
    return End{slope, x, y};
  };
  double low = 0, high = load + 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (shoot(middle).slope > 0 ? high : low) = middle;
  }
  const End end = shoot(low);
  return {end.y, 1 - end.x};
}

// First frequency of a free-free Timoshenko beam, 1/s: linear elements with one-point shear, 200 of
// them (converged to 1e-4).
inline double freeBeamFrequency(const BeamSection& b, double length, double density) {
  constexpr int kElements = 200;
  const int n = 2 * (kElements + 1);
  const double l = length / kElements;
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n), m = k;
  for (int e = 0; e < kElements; ++e) {
    const int w0 = 2 * e, a0 = w0 + 1, w1 = w0 + 2, a1 = w0 + 3;
    const double ei = b.bending() / l, ga = b.shearing() * l;
    k(a0, a0) += ei;
    k(a1, a1) += ei;
    k(a0, a1) -= ei;
    k(a1, a0) -= ei;
    // Shear strain (w1 - w0) / l - (a0 + a1) / 2.
    const int at[4] = {w0, a0, w1, a1};
    const double strain[4] = {-1 / l, -0.5, 1 / l, -0.5};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) k(at[i], at[j]) += ga * strain[i] * strain[j];
    for (const int d : {0, 1}) {
      const double mass = density * l * (d == 0 ? b.area() : b.inertia());
      const int p = w0 + d, q = w1 + d;
      m(p, p) += mass / 3;
      m(q, q) += mass / 3;
      m(p, q) += mass / 6;
      m(q, p) += mass / 6;
    }
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(k, m,
                                                                        Eigen::EigenvaluesOnly);
  return std::sqrt(eigen.eigenvalues()[2]) / (2 * 3.14159265358979324);  // two rigid motions before
}

}  // namespace resect::test
