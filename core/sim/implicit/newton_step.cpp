// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <memory>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/free_particles.h"
#include "palpate/sim/dynamics/private/law.h"
#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/implicit/private/step_solver.h"

namespace palpate {
namespace {

/// Newton ends when the residual is this part of the momenta that it is the balance of.
constexpr double kResidual = 1e-11;
constexpr int kMostRounds = 50;
/// Shortest trial step along a Newton direction, 2^-10: a residual that even this does not lower
/// is rounding, or nothing that this tangent can improve.
constexpr int kMostHalvings = 10;

using Vector = Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

Eigen::Map<const Vector> flat(const Vec3Array& array) {
  return {array.data()->data(), static_cast<Eigen::Index>(3 * array.size())};
}

Eigen::Map<Vector> flat(Vec3Array& array) {
  return {array.data()->data(), static_cast<Eigen::Index>(3 * array.size())};
}

/// Both methods look for the change u of velocity that balances the forces at one point in time:
///
///     r(u) = M u - dt f(x', v') = 0,   v' = v + theta u,   x' = x + theta dt v'
///     A = M + theta dt C + theta² dt² K
///     v += u,   x += dt v'
///
/// with theta = 1 for implicit Euler [BaraffWitkin98] and 1/2 for the implicit midpoint rule
/// [HairerLubichWanner06].
struct Newton final : StepSolver {
  const TissueModel& model;
  Integrator integrator;
  double theta;
  Vector mass;  // of every coordinate
  Vector free;  // 1, or 0 for coordinates of fixed particles
  Eigen::SimplicialLDLT<SparseMatrix> factor;
  bool analysed = false;
  SparseMatrix stiffness;        // of the last factorisation
  Vec3Array position, velocity;  // x', v'
  Vector change, residual, direction;

  Newton(const TissueModel& its_model, Integrator its_integrator);
  int step(const Load& load, double dt, State& state) override;
  void place(double dt, const Vector& u, const State& state);
  double evaluate(const Load& load, double dt, const Vector& u, State& state);
  bool factorise(double dt, Projection projection);
  int iterate(const Load& load, double dt, State& state);
};

Newton::Newton(const TissueModel& its_model, Integrator its_integrator)
    : model(its_model),
      integrator(its_integrator),
      theta(its_integrator == Integrator::implicit_midpoint ? 0.5 : 1.0),
      mass(3 * particle_count(its_model)),
      free(Vector::Zero(3 * particle_count(its_model))),
      position(its_model.rest_position),
      velocity(its_model.rest_position.size(), Vec3::Zero()) {
  for (int i = 0; i < particle_count(model); ++i) {
    mass.segment<3>(3 * i).setConstant(model.mass[static_cast<std::size_t>(i)]);
  }
  for_each_free(model, [this](int i) { free.segment<3>(3 * i).setOnes(); });
}

/// Sets x' and v' for the change u of velocity.
void Newton::place(double dt, const Vector& u, const State& state) {
  flat(velocity) = flat(state.velocity) + theta * u;
  flat(position) = flat(state.position) + (theta * dt) * flat(velocity);
}

/// Sets the residual r(u), and returns its norm [N·s].
double Newton::evaluate(const Load& load, double dt, const Vector& u, State& state) {
  place(dt, u, state);
  compute_forces(model, load, position, velocity, state.force, state.internal);
  residual = free.cwiseProduct(mass.cwiseProduct(u) - dt * flat(state.force));
  return residual.norm();
}

/// Factorises A at x'. False where it is not positive definite, which the projected one always is.
bool Newton::factorise(double dt, Projection projection) {
  stiffness = compute_stiffness(model, position, projection);
  SparseMatrix a =
      (theta * dt) * compute_damping(model, position) + (theta * theta * dt * dt) * stiffness;
  a += SparseMatrix(mass.asDiagonal());
  if (!analysed) factor.analyzePattern(a);
  analysed = true;
  factor.factorize(a);
  return factor.info() == Eigen::Success && factor.vectorD().minCoeff() > 0.0;
}

/// The linearised step A u = dt (f(x, v) - theta dt K v), with K projected, is the first iterate.
/// Newton goes on from there with the exact tangent as long as that is positive definite (Eq 10
/// has none that is symmetric) and halves each direction until the residual falls.
int Newton::step(const Load& load, double dt, State& state) {
  for (const int i : model.fixed) state.velocity[static_cast<std::size_t>(i)].setZero();
  position = state.position;
  compute_forces(model, load, state.position, state.velocity, state.force, state.internal);
  // rounding may leave a soft mode of a stiff tissue a little below 0
  factorise(dt, Projection::positive_semidefinite);
  if (factor.info() != Eigen::Success) return 0;
  residual = flat(state.force) - (theta * dt) * (stiffness * flat(state.velocity));
  change = factor.solve(dt * free.cwiseProduct(residual));

  const int iterations =
      integrator == Integrator::implicit_euler_linear ? 1 : iterate(load, dt, state);
  if (iterations == 0 || !change.allFinite()) return 0;
  place(dt, change, state);
  flat(state.position) += dt * flat(velocity);
  flat(state.velocity) += change;
  advance_internal(model, dt, state);
  state.time += dt;
  return iterations;
}

int Newton::iterate(const Load& load, double dt, State& state) {
  bool exact = model.angle_law == AngleLaw::gradient || model.angles.corners.empty();
  double norm = evaluate(load, dt, change, state);
  int iterations = 1;
  for (; iterations < kMostRounds; ++iterations) {
    const double momentum =
        mass.cwiseProduct(change).norm() + mass.cwiseProduct(flat(state.velocity)).norm();
    if (norm <= kResidual * momentum) break;

    if (exact) exact = factorise(dt, Projection::none);
    if (!exact) factorise(dt, Projection::positive_semidefinite);
    if (factor.info() != Eigen::Success) return 0;
    direction = -factor.solve(residual);
    const Vector before = change;
    double trial = norm;
    for (int halving = 0; halving <= kMostHalvings; ++halving) {
      change = before + std::ldexp(1.0, -halving) * direction;
      trial = evaluate(load, dt, change, state);
      if (trial < norm) break;
    }
    if (!(trial < norm)) {
      change = before;
      break;
    }
    norm = trial;
  }
  return std::isfinite(norm) ? iterations : 0;
}

}  // namespace

std::unique_ptr<StepSolver> make_newton(const TissueModel& model, Integrator integrator) {
  return std::make_unique<Newton>(model, integrator);
}

}  // namespace palpate
