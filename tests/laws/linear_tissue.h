// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/step.h"
#include "scenes/tissues.h"

/// A tissue at rest as a linear system, measured from its forces and not from its tangents, so
/// that what is derived from the tangents has something to be compared with.
namespace palpate::laws {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// x'' = -K x - C x' in the free coordinates, each scaled by the root of its mass.
struct LinearTissue {
  explicit LinearTissue(const TissueModel& model) {
    for (int i = 0, h = 0; i < particle_count(model); ++i) {
      const bool held = h < static_cast<int>(model.fixed.size()) && model.fixed[h] == i;
      if (held) ++h;
      if (!held) particles.push_back(i);
    }
    const auto size = static_cast<Eigen::Index>(3 * particles.size());
    stiffness.resize(size, size);
    damping.resize(size, size);
    Vec3Array x = model.rest_position, v(x.size(), Vec3::Zero());
    // differences of 1e-7 m are exact to 1e-9 or better on springs of millimetres
    for (Eigen::Index column = 0; column < size; ++column) {
      stiffness.col(column) = difference(model, x, v, x, column, 1e-7);
      damping.col(column) = difference(model, x, v, v, column, 1e-3);
    }
    const MatrixXd k = stiffness, c = damping;
    asymmetry = (k - k.transpose()).cwiseAbs().maxCoeff() / k.cwiseAbs().maxCoeff();
    stiffness = 0.5 * (k + k.transpose());
    damping = 0.5 * (c + c.transpose());
    exact_stiffness = k;
    root_mass.resize(size);
    for (std::size_t p = 0; p < particles.size(); ++p) {
      root_mass.segment<3>(static_cast<Eigen::Index>(3 * p))
          .setConstant(std::sqrt(model.mass[particles[p]]));
    }
    const VectorXd inverse = root_mass.cwiseInverse();
    for (MatrixXd* matrix : {&stiffness, &damping, &exact_stiffness}) {
      *matrix = inverse.asDiagonal() * *matrix * inverse.asDiagonal();
    }
  }

  std::vector<int> particles;   ///< that are free
  MatrixXd stiffness, damping;  ///< symmetric parts
  MatrixXd exact_stiffness;     ///< as measured
  VectorXd root_mass;
  double asymmetry = 0.0;  ///< of the stiffness

 private:
  VectorXd difference(const TissueModel& model, const Vec3Array& x, const Vec3Array& v,
                      Vec3Array& changed, Eigen::Index column, double shift) const {
    double& coordinate = changed[particles[static_cast<std::size_t>(column / 3)]][column % 3];
    const double middle = coordinate;
    Vec3Array above(x.size()), below(x.size());
    coordinate = middle + shift;
    compute_forces(model, Load(), x, v, above);
    coordinate = middle - shift;
    compute_forces(model, Load(), x, v, below);
    coordinate = middle;
    VectorXd slope(static_cast<Eigen::Index>(3 * particles.size()));
    for (std::size_t p = 0; p < particles.size(); ++p) {
      const int i = particles[p];
      slope.segment<3>(static_cast<Eigen::Index>(3 * p)) = -(above[i] - below[i]) / (2.0 * shift);
    }
    return slope;
  }
};

struct Mode {
  double frequency = 0.0;  ///< [rad/s]
  VectorXd shape;          ///< in scaled coordinates, unit length
};

/// The fastest mode of the undamped tissue, from Eigen's dense solver.
inline Mode find_top_mode(const LinearTissue& tissue) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(tissue.stiffness);
  const Eigen::Index top = solver.eigenvalues().size() - 1;
  return {std::sqrt(solver.eigenvalues()[top]), solver.eigenvectors().col(top)};
}

/// Adds scaled offsets and velocities to a state.
inline void displace(const LinearTissue& tissue, const VectorXd& offset, const VectorXd& velocity,
                     State& state) {
  const VectorXd dx = offset.cwiseQuotient(tissue.root_mass);
  const VectorXd dv = velocity.cwiseQuotient(tissue.root_mass);
  for (std::size_t p = 0; p < tissue.particles.size(); ++p) {
    const auto at = static_cast<Eigen::Index>(3 * p);
    state.position[tissue.particles[p]] += dx.segment<3>(at);
    state.velocity[tissue.particles[p]] += dv.segment<3>(at);
  }
}

/// The matrix that one step multiplies (x, v) by.
inline MatrixXd build_step_matrix(const LinearTissue& tissue, Integrator integrator, double dt) {
  const Eigen::Index n = tissue.stiffness.rows();
  const MatrixXd identity = MatrixXd::Identity(n, n);
  const MatrixXd& k = tissue.exact_stiffness;
  const MatrixXd& c = tissue.damping;
  MatrixXd slope(2 * n, 2 * n);
  slope << MatrixXd::Zero(n, n), identity, -k, -c;
  const MatrixXd one = MatrixXd::Identity(2 * n, 2 * n), h = dt * slope;
  switch (integrator) {
    case Integrator::explicit_euler:
      return one + h;
    case Integrator::midpoint:
      return one + h + h * h / 2.0;
    case Integrator::runge_kutta_4:
      return one + h + h * h / 2.0 + h * h * h / 6.0 + h * h * h * h / 24.0;
    case Integrator::implicit_midpoint:
      return (one - h / 2.0).partialPivLu().solve(one + h / 2.0);
    case Integrator::symplectic_euler: {
      MatrixXd step(2 * n, 2 * n);
      step << identity - dt * dt * k, dt * (identity - dt * c), -dt * k, identity - dt * c;
      return step;
    }
    case Integrator::symplectic_euler_implicit_damping: {
      const MatrixXd damped = (identity + dt * c).partialPivLu().inverse();
      MatrixXd step(2 * n, 2 * n);
      step << identity - dt * dt * damped * k, dt * damped, -dt * damped * k, damped;
      return step;
    }
    default:
      return (one - h).partialPivLu().solve(one);
  }
}

inline double compute_spectral_radius(const MatrixXd& matrix) {
  return Eigen::EigenSolver<MatrixXd>(matrix, false).eigenvalues().cwiseAbs().maxCoeff();
}

/// Rounding turns the double eigenvalue 1 of a free body into 1 ± 1e-8.
constexpr double kNoGrowth = 1.0 + 1e-6;

/// Where the spectral radius of the step matrix first exceeds 1, by halving an interval.
inline double find_limit(const LinearTissue& tissue, Integrator integrator, double unstable) {
  double stable = 0.0;
  for (int halving = 0; halving < 30; ++halving) {
    const double dt = 0.5 * (stable + unstable);
    const double radius = compute_spectral_radius(build_step_matrix(tissue, integrator, dt));
    (radius <= kNoGrowth ? stable : unstable) = dt;
  }
  return stable;
}

}  // namespace palpate::laws
