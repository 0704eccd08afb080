// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/free_particles.h"
#include "palpate/sim/dynamics/private/law.h"
#include "palpate/sim/implicit/private/projective_weights.h"
#include "palpate/sim/implicit/private/step_solver.h"

namespace palpate {
namespace {

/// As Newton's (newton_step.cpp): a residual that is this part of the momenta is none.
constexpr double kResidual = 1e-11;

/// Projective dynamics [Bouaziz14]: implicit Euler, r(x) = f(x, v) - M (x - x0 - dt v0)/dt² = 0
/// with v = (x - x0)/dt, by
///
///     A x+ = A x + r(x)
///
/// where A is constant (projective_weights.h). Of energies that are squared distances w |G x -
/// p|²/2 to a set, f = -w Gᵀ(G x - p) with p the nearest point of it, so that this is their local
/// step, which finds p, and their global step A x+ = M (x0 + dt v0)/dt² + w Gᵀ p; of any other
/// energy it is the same iteration [Liu17]. A step that does not lower rᵀA⁻¹r is halved.
///
/// It starts from x0 and not, as the paper does, from where loads and inertia alone would go.
/// However few iterations there are, what is at rest under a load then stays there, and of laws
/// that A bounds the energy only falls: what has not converged is drag [laws: projective].
class Projective final : public StepSolver {
 public:
  Projective(const TissueModel& model, int iterations)
      : model_(model),
        iterations_(iterations),
        position_(model.rest_position),
        velocity_(model.rest_position.size(), Vec3::Zero()) {}

  int step(const Load& load, double dt, State& state) override;

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;
  using Factor = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
  struct Factorised {
    double dt = 0.0;
    std::unique_ptr<Factor> factor;
  };

  const Factor* find_factor(double dt);
  bool evaluate(const Load& load, double dt, State& state);
  void move(double part) noexcept;

  const TissueModel& model_;
  int iterations_;
  std::vector<Factorised> factors_;
  Vec3Array position_, velocity_;
  Rows residual_, change_;
};

/// The factor of a step. Contact asks for other steps, mostly a few: those of the last are kept.
const Projective::Factor* Projective::find_factor(double dt) {
  constexpr std::size_t kMostKept = 8;
  const auto kept = std::ranges::find(factors_, dt, &Factorised::dt);
  if (kept != factors_.end()) return kept->factor.get();
  if (factors_.size() == kMostKept) factors_.erase(factors_.begin());
  auto factor = std::make_unique<Factor>(compute_projective_matrix(model_, dt));
  if (factor->info() != Eigen::Success) return nullptr;
  factors_.push_back({dt, std::move(factor)});
  return factors_.back().factor.get();
}

/// Sets the residual at x; false where it is no more than rounding.
bool Projective::evaluate(const Load& load, double dt, State& state) {
  for (std::size_t i = 0; i < position_.size(); ++i) {
    velocity_[i] = (position_[i] - state.position[i]) / dt;
  }
  compute_forces(model_, load, position_, velocity_, state.force, state.internal);
  residual_.setZero(particle_count(model_), 3);
  double error = 0.0, change = 0.0, momentum = 0.0;
  for_each_free(model_, [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    const Vec3 gained = model_.mass[i] * (velocity_[i] - state.velocity[i]);
    const Vec3 row = state.force[i] - gained / dt;
    residual_.row(index) = row.transpose();
    error += row.squaredNorm();
    change += gained.squaredNorm();
    momentum += (model_.mass[i] * state.velocity[i]).squaredNorm();
  });
  return !(dt * std::sqrt(error) <= kResidual * (std::sqrt(change) + std::sqrt(momentum)));
}

void Projective::move(double part) noexcept {
  for_each_free(model_, [&](int i) {
    position_[static_cast<std::size_t>(i)] += part * change_.row(i).transpose();
  });
}

int Projective::step(const Load& load, double dt, State& state) {
  for (const int i : model_.fixed) state.velocity[static_cast<std::size_t>(i)].setZero();
  const Factor* factor = find_factor(dt);
  if (!factor) return 0;
  position_ = state.position;
  double least = std::numeric_limits<double>::infinity(), part = 1.0;
  int iterations = 0;
  for (; iterations < iterations_ && evaluate(load, dt, state); ++iterations) {
    const Rows direction = factor->solve(residual_);
    const double left = residual_.cwiseProduct(direction).sum();
    if (!std::isfinite(left)) return 0;
    if (left > least) {
      part *= 0.5;
      move(-part);  // half of the last move remains
      continue;
    }
    least = left;
    change_ = direction;
    move(part);
  }
  for (const Vec3& x : position_) {
    if (!x.allFinite()) return 0;
  }
  for_each_free(model_, [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    state.velocity[i] = (position_[i] - state.position[i]) / dt;
    state.position[i] = position_[i];
  });
  compute_forces(model_, load, state.position, state.velocity, state.force, state.internal);
  advance_internal(model_, dt, state);
  state.time += dt;
  return std::max(iterations, 1);
}

}  // namespace

std::unique_ptr<StepSolver> make_projective_dynamics(const TissueModel& model, int iterations) {
  return std::make_unique<Projective>(model, iterations);
}

}  // namespace palpate
