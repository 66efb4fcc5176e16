// The obvious way to compute elastic tissue: a list of neighbours per particle, one particle after
// the other, formulas as they stand in docs/methods/tissue.md. Tests hold the fast kernels against
// it in double precision; the benchmark times it in single precision.
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "tissue/elastic/kernel/elastic_kernel.h"
#include "tissue/material.h"
#include "tissue/stencil.h"

namespace resect::test {

template <typename Scalar>
class ReferenceTissue {
 public:
  using V = Eigen::Matrix<Scalar, 3, 1>;
  using M = Eigen::Matrix<Scalar, 3, 3>;

  struct Neighbour {
    int particle;
    V x;       // X_ij, m
    Scalar w;  // w_ij
  };

  ReferenceTissue(const TissueCells& cells, double penalty) : penalty_(penalty) {
    const Lattice& lattice = cells.lattice;
    const double s = lattice.spacing.x();
    volume = Scalar(s * s * s);
    std::vector<int> number(lattice.cellCount(), -1);
    for (std::int64_t c = 0; c < lattice.cellCount(); ++c)
      if (cells.solid[c]) {
        number[c] = int(cellOf.size());
        cellOf.push_back(c);
      }
    const auto weights = bondWeights();
    for (const std::int64_t c : cellOf) {
      const TissueMaterial& m = cells.materials[cells.material.empty() ? 0 : cells.material[c]];
      mu.push_back(Scalar(m.shear()));
      lambda.push_back(Scalar(m.lame()));
      young.push_back(Scalar(m.young));
      material.push_back(cells.material.empty() ? 0 : cells.material[c]);
      mass.push_back(Scalar(m.density) * volume);
      neighbours.emplace_back();
      for (int d = 0; d < kDirections; ++d) {
        const Vec3i other = lattice.cell(c) + offsetOf(d);
        if (!lattice.contains(other) || number[lattice.index(other)] < 0) continue;
        neighbours.back().push_back({number[lattice.index(other)],
                                     (offsetOf(d).cast<double>() * s).cast<Scalar>(),
                                     Scalar(weights[neighbourKind(d)] / (s * s))});
      }
    }
    u.assign(cellOf.size(), V::Zero());
    v = u;
    correct();
  }

  // Bonds for which cut(i, j) is true are severed on both sides.
  template <typename Cut>
  void sever(Cut cut) {
    for (int i = 0; i < int(neighbours.size()); ++i)
      std::erase_if(neighbours[i], [&](const Neighbour& n) { return cut(i, n.particle); });
    correct();
  }

  Scalar energy() const {
    Scalar sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      for (const Neighbour& n : neighbours[i]) {
        if (n.particle < int(i) || !thread(i, n)) continue;
        const Scalar stretch = (n.x + u[n.particle] - u[i]).norm() - n.x.norm();
        sum += threadStiffness(i, n) / 2 * stretch * stretch;
      }
      if (!deforms[i]) continue;
      const M h = gradient(i), f = h + M::Identity();
      const Scalar growth = f.determinant() - 1;
      sum += volume * (mu[i] / 2 * (f.squaredNorm() - 3) - mu[i] * growth +
                       (lambda[i] + mu[i]) / 2 * growth * growth);
      for (const Neighbour& n : neighbours[i])
        sum += kappa[i] / 2 * n.w * (u[n.particle] - u[i]).dot(u[n.particle] - u[i] - h * n.x);
    }
    return sum;
  }

  std::vector<V> forces() const {
    std::vector<M> a(u.size());
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (!deforms[i]) {
        a[i].setZero();
        continue;
      }
      const M h = gradient(i), f = h + M::Identity();
      M cof;
      cof.row(0) = f.row(1).cross(f.row(2));
      cof.row(1) = f.row(2).cross(f.row(0));
      cof.row(2) = f.row(0).cross(f.row(1));
      const Scalar limit = std::min(Scalar(1), Scalar(kCofactorLimit) / cof.squaredNorm());
      const M p = mu[i] * (f - cof) + limit * (lambda[i] + mu[i]) * (f.determinant() - 1) * cof;
      a[i] = volume * p * inverseMoment[i] - kappa[i] * h;
    }
    std::vector<V> result(u.size(), V::Zero());
    for (std::size_t i = 0; i < u.size(); ++i)
      for (const Neighbour& n : neighbours[i]) {
        const int j = n.particle;
        const Scalar both = (deforms[i] ? kappa[i] : 0) + (deforms[j] ? kappa[j] : 0);
        if (thread(i, n)) {
          const V x = n.x + u[j] - u[i];
          result[i] += threadStiffness(i, n) * (1 - n.x.norm() / x.norm()) * x;
        }
        result[i] += n.w * ((a[i] + a[j]) * n.x + both * (u[j] - u[i]));
      }
    return result;
  }

  // One substep of symplectic Euler with forces looked up `damping` of a substep ahead.
  void step(Scalar dt, Scalar damping, const V& gravity) {
    const std::vector<V> here = u;
    for (std::size_t i = 0; i < u.size(); ++i) u[i] += damping * dt * v[i];
    const std::vector<V> f = forces();
    for (std::size_t i = 0; i < u.size(); ++i) {
      v[i] += dt * (f[i] / mass[i] + gravity);
      u[i] = here[i] + dt * v[i];
    }
  }

  // Bonds of which neither end has a gradient.
  bool thread(std::size_t i, const Neighbour& n) const {
    return !deforms[i] && !deforms[n.particle];
  }
  Scalar threadStiffness(std::size_t i, const Neighbour& n) const {
    const Scalar s = std::cbrt(volume);
    const int kind = int(std::lround(n.x.squaredNorm() / (s * s)));
    const Scalar share = kind == 1 ? Scalar(0.5) : kind == 2 ? Scalar(0.25) : Scalar(0.15);
    return share * (young[i] + young[n.particle]) / 2 * s;
  }

  M gradient(std::size_t i) const {
    M sum = M::Zero();
    for (const Neighbour& n : neighbours[i]) sum += n.w * (u[n.particle] - u[i]) * n.x.transpose();
    return sum * inverseMoment[i];
  }

  Scalar volume;
  std::vector<std::int64_t> cellOf;  // lattice cell of each particle
  std::vector<std::vector<Neighbour>> neighbours;
  std::vector<Scalar> young, mu, lambda, kappa, mass;
  std::vector<int> material;
  std::vector<V> u, v;
  std::vector<M> inverseMoment;
  std::vector<char> deforms;

 private:
  void correct() {
    inverseMoment.assign(u.size(), M::Zero());
    deforms.assign(u.size(), 0);
    kappa.assign(u.size(), 0);
    for (std::size_t i = 0; i < u.size(); ++i) {
      Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
      for (const Neighbour& n : neighbours[i]) {
        const Eigen::Vector3d x = n.x.template cast<double>();
        m += double(n.w) * x * x.transpose();
      }
      if (Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).eigenvalues().minCoeff() < 0.15)
        continue;
      deforms[i] = 1;
      Eigen::Matrix3d others = Eigen::Matrix3d::Zero();
      double softness = 1 / double(mu[i]);
      for (const Neighbour& n : neighbours[i]) {
        softness += 1 / double(mu[n.particle]);
        const Eigen::Vector3d x = n.x.template cast<double>();
        if (material[n.particle] != material[i]) others += double(n.w) * x * x.transpose();
      }
      kappa[i] = Scalar(penalty_ * double(neighbours[i].size() + 1) / softness) * volume;
      Eigen::Matrix3d joint = Eigen::Matrix3d::Identity();
      if (!others.isZero()) {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(others);
        const Eigen::Vector3d normal = eigen.eigenvectors().col(2);
        double all = 0, seen = 0;
        for (const Neighbour& n : neighbours[i]) {
          const double along = normal.dot(n.x.template cast<double>());
          all += double(n.w) * along * along;
          seen += double(n.w) * along * along * (1 + double(young[i] / young[n.particle])) / 2;
        }
        joint += (std::sqrt(all / seen) - 1) * normal * normal.transpose();
      }
      inverseMoment[i] = (joint * m.inverse() * joint).template cast<Scalar>();
    }
  }

  double penalty_;
};

}  // namespace resect::test
