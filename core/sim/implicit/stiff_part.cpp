// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/implicit/private/stiff_part.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/free_particles.h"
#include "palpate/sim/dynamics/private/lanczos.h"
#include "palpate/sim/dynamics/tangent.h"

namespace palpate {
namespace {

using Vector = Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Largest eigenvalue of dt² M⁻¹K + 2 dt M⁻¹C that is left to explicit steps, of the 4 at which
/// they would swing with the period of two steps [motion: step].
constexpr double kMostLeft = 3.2;

/// Asked for first; then twice as many each time.
constexpr std::size_t kFewest = 8;

/// M^(-1/2) (dt² (K + contact) + 2 dt C) M^(-1/2) of the whole model.
SparseMatrix scale(const TissueModel& model, std::span<const Vec3> x, double dt,
                   std::span<const double> contact) {
  SparseMatrix whole = dt * dt * compute_stiffness(model, x, Projection::positive_semidefinite) +
                       2.0 * dt * compute_damping(model, x);
  Vector root(whole.rows()), added(Vector::Zero(whole.rows()));
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(3 * i);
    root.segment<3>(at).setConstant(1.0 / std::sqrt(model.mass[i]));
    if (!contact.empty()) added.segment<3>(at).setConstant(dt * dt * contact[i]);
  }
  for (const int i : model.fixed) added.segment<3>(3 * i).setZero();
  return SparseMatrix(root.asDiagonal() * whole * root.asDiagonal()) +
         SparseMatrix(added.asDiagonal());
}

/// The sum of a particle's rows: no eigenvalue of those that are left is larger than the largest
/// among them (Gershgorin).
std::vector<double> sum_rows(const SparseMatrix& scaled) {
  std::vector<double> sums(static_cast<std::size_t>(scaled.cols() / 3), 0.0);
  for (int column = 0; column < scaled.outerSize(); ++column) {
    double sum = 0.0;
    for (SparseMatrix::InnerIterator entry(scaled, column); entry; ++entry) {
      sum += std::abs(entry.value());
    }
    double& largest = sums[static_cast<std::size_t>(column / 3)];
    largest = std::max(largest, sum);
  }
  return sums;
}

/// The largest eigenvalue of what is left to explicit steps.
double find_largest_left(const SparseMatrix& scaled, std::span<const char> is_inside) {
  Vector left(scaled.rows());
  for (std::size_t i = 0; i < is_inside.size(); ++i) {
    left.segment<3>(static_cast<Eigen::Index>(3 * i)).setConstant(is_inside[i] ? 0.0 : 1.0);
  }
  return find_largest_eigenvalue(scaled.rows(),
                                 [&](const auto& v) {
                                   return Vector(left.cwiseProduct(scaled * left.cwiseProduct(v)));
                                 })
      .value;
}

}  // namespace

/// The particles of the largest sums of rows, 8, 16, 32 ... of them, until the rest is stable.
StiffPart::StiffPart(const TissueModel& model, std::span<const Vec3> x, double dt,
                     std::span<const double> contact)
    : dt_(dt), is_inside_(model.mass.size(), 0), contact_(contact.begin(), contact.end()) {
  const SparseMatrix scaled = scale(model, x, dt, contact);
  const std::vector<double> sums = sum_rows(scaled);
  std::vector<int> order;
  for_each_free(model, [&](int i) { order.push_back(i); });
  const auto sum_of = [&](int i) { return sums[static_cast<std::size_t>(i)]; };
  if (!std::ranges::all_of(order, [&](int i) { return std::isfinite(sum_of(i)); })) return;
  std::ranges::stable_sort(order, std::greater<>{}, sum_of);
  const std::size_t most = std::min(kMost, order.size());
  std::size_t count = 0;
  for (std::size_t wanted = 0;; wanted = std::min(most, std::max(kFewest, 2 * wanted))) {
    for (; count < wanted; ++count) is_inside_[static_cast<std::size_t>(order[count])] = 1;
    holds_ = count == order.size() || find_largest_left(scaled, is_inside_) < kMostLeft;
    if (holds_ || count == most) break;
  }
  if (!holds_) return;
  particles_.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
  std::ranges::sort(particles_);
  if (particles_.empty()) return;
  cut_ = cut_out(model, x, Vec3::Zero(), 0, particles_);
  for (const int i : particles_) {
    number_.push_back(
        static_cast<int>(std::ranges::lower_bound(cut_.particle, i) - cut_.particle.begin()));
  }
}

/// Those outside first, by what all did before. Those inside then find them where they have gone:
///
///     v' = v + dt f(x, v)/m,  x' = x + dt v'                            outside
///     (M + dt C + dt² (K + K_c)) u = dt (f(x, v) - dt (K + K_c) v)      inside
///     v' = v + u,  x' = x + dt v'
///
/// which is implicit Euler with one Newton step and the projected tangent [BaraffWitkin98]. What
/// contacts push with is in f, and grows less by K_c along its direction while the tissue gives
/// way.
bool StiffPart::step(const TissueModel& model, const Load& load, State& state) {
  for (const int i : model.fixed) state.velocity[static_cast<std::size_t>(i)].setZero();
  compute_forces(model, load, state.position, state.velocity, state.force);
  for_each_free(model, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    if (is_inside_[at]) return;
    state.velocity[at] += (dt_ / model.mass[at]) * state.force[at];
    state.position[at] += dt_ * state.velocity[at];
  });
  if (!particles_.empty() && !solve(model, load, state)) return false;
  state.time += dt_;
  return true;
}

/// Of each particle inside that is pushed, along the push.
SparseMatrix StiffPart::compute_contact(const TissueModel& model, const Load& load) {
  const auto size = static_cast<Eigen::Index>(3 * cut_.x.size());
  SparseMatrix contact(size, size);
  if (contact_.empty() || load.push_count == 0) return contact;
  Vec3Array pushed(model.mass.size(), Vec3::Zero());
  accumulate_push_forces(model.triangles, model.skin, load.pushes(), pushed);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < particles_.size(); ++k) {
    const auto i = static_cast<std::size_t>(particles_[k]);
    if (pushed[i].isZero(0.0)) continue;
    const Vec3 n = pushed[i].normalized();
    const Mat3 block = contact_[i] * model.mass[i] * n * n.transpose();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        entries.emplace_back(3 * number_[k] + row, 3 * number_[k] + column, block(row, column));
      }
    }
  }
  contact.setFromTriplets(entries.begin(), entries.end());
  return contact;
}

bool StiffPart::solve(const TissueModel& model, const Load& load, State& state) {
  for (std::size_t k = 0; k < cut_.x.size(); ++k) {
    cut_.x[k] = state.position[static_cast<std::size_t>(cut_.particle[k])];
  }
  const SparseMatrix stiffness =
      compute_stiffness(cut_.model, cut_.x, Projection::positive_semidefinite);
  Vector inertia(stiffness.rows()), velocity(Vector::Zero(stiffness.rows()));
  for (std::size_t k = 0; k < cut_.x.size(); ++k) {
    inertia.segment<3>(static_cast<Eigen::Index>(3 * k)).setConstant(cut_.model.mass[k]);
  }
  for (std::size_t k = 0; k < particles_.size(); ++k) {
    velocity.segment<3>(3 * number_[k]) = state.velocity[static_cast<std::size_t>(particles_[k])];
  }
  const SparseMatrix give = stiffness + compute_contact(model, load);
  const SparseMatrix matrix = SparseMatrix(inertia.asDiagonal()) +
                              dt_ * compute_damping(cut_.model, cut_.x) + dt_ * dt_ * give;
  factors_.compute(matrix);
  if (factors_.info() != Eigen::Success) return false;

  compute_forces(model, load, state.position, state.velocity, state.force);
  const Vector carried = dt_ * (give * velocity);
  Vector side = Vector::Zero(stiffness.rows());
  for (std::size_t k = 0; k < particles_.size(); ++k) {
    side.segment<3>(3 * number_[k]) = dt_ * (state.force[static_cast<std::size_t>(particles_[k])] -
                                             Vec3(carried.segment<3>(3 * number_[k])));
  }
  const Vector change = factors_.solve(side);
  if (!change.allFinite()) return false;
  for (std::size_t k = 0; k < particles_.size(); ++k) {
    const auto i = static_cast<std::size_t>(particles_[k]);
    state.velocity[i] += change.segment<3>(3 * number_[k]);
    state.position[i] += dt_ * state.velocity[i];
  }
  return true;
}

}  // namespace palpate
