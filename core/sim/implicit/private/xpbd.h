// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/LU>
#include <memory>
#include <span>
#include <vector>

#include "palpate/sim/model/tissue_model.h"

namespace palpate::xpbd {

/// The particles in a step of XPBD [Macklin16].
struct Particles {
  std::span<const Vec3> start;         ///< [m] at the start of the step
  std::span<const double> internal;    ///< State::internal there
  Vec3Array position;                  ///< [m] as the constraints leave them
  std::vector<double> inverse_weight;  ///< [1/kg] of what moves, 0 where held
  double dt = 0.0;                     ///< [s]
};

/// What one law pulls with, a constraint for each of its rows.
class Constraints {
 public:
  virtual ~Constraints() = default;
  /// Forgets all multipliers, as a step begins.
  virtual void reset() = 0;
  /// Goes over all of its rows once, in order.
  virtual void sweep(Particles& particles) = 0;
};

using ConstraintList = std::vector<std::unique_ptr<Constraints>>;

/// Springs, bonds, angles, prisms and home springs; the model must outlive them.
void add_length_constraints(const TissueModel& model, ConstraintList& list);
/// Volumes and solids of every law.
void add_solid_constraints(const TissueModel& model, ConstraintList& list);

/// M measures q of N particles, with an energy U(q) and a dissipation q'ᵀ C q'/2.
template <int M, std::size_t N>
struct Block {
  using Column = Eigen::Matrix<double, M, 1>;
  using Square = Eigen::Matrix<double, M, M>;

  std::array<int, N> corners;
  std::array<Eigen::Matrix<double, M, 3>, N> gradient;  ///< dq/dx of each
  Column slope = Column::Zero();                        ///< dU/dq
  Square curvature = Square::Zero();  ///< d²U/dq², positive semidefinite, as near as may be
  Square damping = Square::Zero();    ///< C, likewise
};

/// One step of Gauss and Seidel. The multiplier is lambda = -dt² (dU/dq + C q'), which XPBD writes
/// as C + alpha lambda = 0 with the compliance alpha; multiplied by the curvature H = 1/alpha it
/// holds for any energy, and for measures without stiffness:
///
///     (1 + dt² H' J W Jᵀ) dlambda = -(lambda + dt² s'),   x += W Jᵀ dlambda
///     s' = dU/dq + C J (x - x0)/dt,   H' = H + C/dt
///
/// so that the rate is that of implicit Euler: the change in the step over dt [laws: xpbd].
template <int M, std::size_t N>
void project(const Block<M, N>& block, Particles& particles,
             typename Block<M, N>::Column& multiplier) noexcept {
  using Square = typename Block<M, N>::Square;
  typename Block<M, N>::Column rate = Block<M, N>::Column::Zero();
  Square mobility = Square::Zero();
  for (std::size_t k = 0; k < N; ++k) {
    const auto i = static_cast<std::size_t>(block.corners[k]);
    rate += block.gradient[k] * (particles.position[i] - particles.start[i]);
    mobility += particles.inverse_weight[i] * block.gradient[k] * block.gradient[k].transpose();
  }
  const double dt = particles.dt;
  const Square stiffness = dt * dt * block.curvature + dt * block.damping;
  const Square system = Square::Identity() + stiffness * mobility;
  const typename Block<M, N>::Column change = system.partialPivLu().solve(
      -(multiplier + dt * dt * block.slope + dt * block.damping * rate));
  multiplier += change;
  for (std::size_t k = 0; k < N; ++k) {
    const auto i = static_cast<std::size_t>(block.corners[k]);
    particles.position[i] += particles.inverse_weight[i] * block.gradient[k].transpose() * change;
  }
}

}  // namespace palpate::xpbd
