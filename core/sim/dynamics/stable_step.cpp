// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>
#include <cmath>
#include <limits>

#include "palpate/sim/dynamics/private/free_particles.h"
#include "palpate/sim/dynamics/private/lanczos.h"
#include "palpate/sim/dynamics/private/step_limit.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/dynamics/tangent.h"

namespace palpate {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The part of K = -df/dx [N/m] that a pressure adds; with f_a = f_b = f_c =
/// p/6 (a × b + b × c + c × a),
///
///     df/da = p/6 [c - b]×,   df/db = p/6 [a - c]×,   df/dc = p/6 [b - a]×
SparseMatrix compute_pressure_stiffness(const TissueModel& model) {
  const Vec3Array& x = model.rest_position;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(54 * model.triangles.size());
  for (const Triangle& corners : model.triangles) {
    for (int q = 0; q < 3; ++q) {
      const Vec3 across =
          (-model.pressure / 6.0) * (x[corners[(q + 2) % 3]] - x[corners[(q + 1) % 3]]);
      Mat3 cross;
      cross << 0, -across.z(), across.y(), across.z(), 0, -across.x(), -across.y(), across.x(), 0;
      for (const int p : corners) {
        for (int row = 0; row < 3; ++row) {
          for (int column = 0; column < 3; ++column) {
            entries.emplace_back(3 * p + row, 3 * corners[q] + column, cross(row, column));
          }
        }
      }
    }
  }
  const Eigen::Index size = 3 * particle_count(model);
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The tangents at rest in coordinates in which every mass is 1, fixed particles left out:
/// M^-1/2 K M^-1/2 [1/s²] and M^-1/2 C M^-1/2 [1/s]. Eq 10 and the pressure on an open surface
/// have no symmetric K; its symmetric part has no smaller a largest eigenvalue, so it bounds the
/// true one from above.
struct Tangents {
  explicit Tangents(const TissueModel& model)
      : scale(Eigen::VectorXd::Zero(3 * particle_count(model))) {
    for_each_free(model, [&](int i) {
      scale.segment<3>(3 * i).setConstant(1.0 / std::sqrt(model.mass[static_cast<std::size_t>(i)]));
    });
    SparseMatrix k = compute_stiffness(model, model.rest_position, Projection::none);
    if (model.pressure != 0.0) k += compute_pressure_stiffness(model);
    const SparseMatrix transposed = k.transpose();
    stiffness = scale.asDiagonal() * SparseMatrix(0.5 * (k + transposed)) * scale.asDiagonal();
    damping = scale.asDiagonal() * compute_damping(model, model.rest_position) * scale.asDiagonal();
  }

  Largest find_largest(double stiffness_share, double damping_share) const {
    return find_largest_eigenvalue(scale.size(), [&](const auto& v) -> Eigen::VectorXd {
      return stiffness_share * (stiffness * v) + damping_share * (damping * v);
    });
  }

  Eigen::VectorXd scale;  ///< [1/sqrt(kg)] m^-1/2, 0 for coordinates of fixed particles
  SparseMatrix stiffness, damping;
};

/// The largest eigenvalue of the 3x3 block of particle i.
double find_largest_of_block(const SparseMatrix& matrix, int i) {
  Mat3 block;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      block(row, column) = matrix.coeff(3 * i + row, 3 * i + column);
    }
  }
  return Eigen::SelfAdjointEigenSolver<Mat3>(block, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

/// A bound on the largest eigenvalue of G + k E_i, where G is positive semidefinite with largest
/// eigenvalue g, E_i picks the three coordinates of one particle, and h is the largest eigenvalue
/// of E_i G E_i. For mu > g, 1/(mu - t) is convex in t, so on [0, g] it lies below its chord:
///
///     E_i (mu - G)^-1 E_i <= 1/mu + h/(mu (mu - g))
///
/// mu exceeds every eigenvalue of the sum once k times that is below 1, that is, beyond
///
///     mu = ((g + k) + sqrt((g - k)² + 4 k h)) / 2
double bound_with_coupling(double g, double h, double k) {
  return 0.5 * ((g + k) + std::sqrt((g - k) * (g - k) + 4.0 * k * h));
}

/// The same over every particle that a coupling [N/m] may hold.
template <class OfBlock>
double bound_with_any_coupling(const TissueModel& model, double g, double coupling,
                               OfBlock of_block) {
  double bound = g;
  for_each_free(model, [&](int i) {
    const double k = coupling / model.mass[static_cast<std::size_t>(i)];
    bound = std::max(bound, bound_with_coupling(g, of_block(i), k));
  });
  return bound;
}

/// The positive root of dt² k + 2 dt c = 4.
double solve_limit(double k, double c) {
  if (!(k > 0.0) && !(c > 0.0)) return kInfinity;
  return 4.0 / (c + std::sqrt(c * c + 4.0 * std::max(k, 0.0)));
}

/// The positive root of dt² k - 2 dt c = 4.
double solve_damped_limit(double k, double c) {
  return k > 0.0 ? (c + std::sqrt(c * c + 4.0 * k)) / k : kInfinity;
}

double upper(const Largest& largest) { return largest.value + largest.residual; }

/// The dt at which the largest eigenvalue of dt² K + 2 dt C is 4. The top vector at a dt gives two
/// Rayleigh quotients and with them the next dt; these come down on the limit quadratically, as
/// the quotients are right to second order.
double find_limit(const Tangents& tangents, double k, double c) {
  constexpr int kMostRounds = 8;
  constexpr double kSettled = 1e-3;
  double dt = solve_limit(k, c);
  if (!(c > 0.0) || !(k > 0.0)) return dt;
  for (int round = 0; round < kMostRounds; ++round) {
    const Eigen::VectorXd top = tangents.find_largest(dt * dt, 2.0 * dt).vector;
    const double next =
        solve_limit(top.dot(tangents.stiffness * top), top.dot(tangents.damping * top));
    const bool settled = std::abs(next - dt) <= kSettled * dt;
    dt = next;
    if (settled) break;
  }
  return dt;
}

/// The largest part s of the limit dt0 without coupling that is a limit with it. With
/// A = dt0² K and B = 2 dt0 C, G(s dt0) = s (s A + B), and the largest eigenvalue of s A + B is
/// convex in s: 4 at s = 1, b = that of B at s = 0, so that of G is at most s (4 s + b (1 - s)).
double find_part_with_coupling(const TissueModel& model, const Tangents& tangents, double dt0,
                               double damping, double coupling) {
  constexpr int kHalvings = 40;
  std::vector<double> block_stiffness(model.mass.size()), block_damping(model.mass.size());
  for_each_free(model, [&](int i) {
    block_stiffness[static_cast<std::size_t>(i)] = find_largest_of_block(tangents.stiffness, i);
    block_damping[static_cast<std::size_t>(i)] = find_largest_of_block(tangents.damping, i);
  });
  const auto bound = [&](double s) {
    const double dt = s * dt0;
    const double g = s * (4.0 * s + 2.0 * dt0 * damping * (1.0 - s));
    return bound_with_any_coupling(model, g, dt * dt * coupling, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      return std::min(g, dt * dt * block_stiffness[at] + 2.0 * dt * block_damping[at]);
    });
  };
  double stable = 0.0, unstable = 1.0;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = 0.5 * (stable + unstable);
    (bound(middle) < 4.0 ? stable : unstable) = middle;
  }
  return stable;
}

/// [s] The quotient's minimum [Dinkelbach67]: where the largest eigenvalue of t K - C is positive,
/// its vector has a smaller quotient than t.
double find_least_damping_time(const Tangents& tangents) {
  constexpr int kMostRounds = 30;
  // more than rounding leaves of motions that nothing resists
  constexpr double kRounding = 1e-9;
  const Largest stiffest = tangents.find_largest(1.0, 0.0);
  if (!(stiffest.value > 0.0)) return kInfinity;
  Eigen::VectorXd v = stiffest.vector;
  double least = kInfinity;
  for (int round = 0; round < kMostRounds; ++round) {
    const double k = v.dot(tangents.stiffness * v), c = v.dot(tangents.damping * v);
    const double next = std::max(0.0, c) / k;
    if (std::isfinite(least) && !(least * k - c > kRounding * least * stiffest.value)) break;
    if (!(next < least) || next == 0.0) return std::min(next, least);
    least = next;
    v = tangents.find_largest(least, -1.0).vector;
  }
  return least;
}

/// Explicit midpoint is stable for a mode with z = dt mu where |1 + z + z²/2| <= 1. For a pair of
/// complex mu, with k = |mu|² and c = -2 Re mu, that is
///
///     dt⁴ k²/4 - dt c (1 - dt c/2) - dt³ c k/2 <= 0,
///
/// convex in c and in k. With c from t k to the largest, and k up to the largest, it holds
/// everywhere if it does at c = t k, where it is dt k ((dt - t)² + t²) <= 4 t, and at the largest
/// of both; real mu are stable up to dt c = 2.
double find_midpoint_limit(double k, double c, double t) noexcept {
  constexpr int kHalvings = 60;
  if (!(k > 0.0)) return c > 0.0 ? 2.0 / c : kInfinity;
  if (!(t > 0.0) || !(c > 0.0)) return 0.0;
  const auto is_stable = [&](double dt) noexcept {
    if (dt * k * ((dt - t) * (dt - t) + t * t) > 4.0 * t) return false;
    const double dk = dt * dt * k, dc = dt * c;
    return c * c >= 4.0 * k || 0.25 * dk * dk - dc * (1.0 - 0.5 * dc) - 0.5 * dc * dk <= 0.0;
  };
  double stable = 0.0, unstable = 2.0 / c;
  if (is_stable(unstable)) return unstable;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = 0.5 * (stable + unstable);
    (is_stable(middle) ? stable : unstable) = middle;
  }
  return stable;
}

}  // namespace

/// Every eigenvector u of the motion has an eigenvalue mu with mu² m + mu c + k = 0, where m, c and
/// k are its u'Mu, u'Cu and u'Ku: |mu|² = k/m and Re mu = -c/2m where mu is complex, |mu| <= c/m
/// where it is real. Explicit Euler, |1 + dt mu| <= 1, asks for dt <= c/k of the one and dt <= 2/c
/// of the other [HairerLubichWanner06]. The stability region of Runge and Kutta's holds the left
/// half of a disk of radius 2.6.
double find_step_limit(Integrator integrator, const Spectrum& spectrum,
                       double least_damping_time) noexcept {
  constexpr double kRungeKuttaRadius = 2.6;
  const double k = spectrum.stiffness, c = spectrum.damping;
  if (is_implicit(integrator)) return kInfinity;
  switch (integrator) {
    case Integrator::explicit_euler: {
      const double damped = c > 0.0 ? 2.0 / c : kInfinity;
      return k > 0.0 ? std::min(damped, least_damping_time) : damped;
    }
    case Integrator::midpoint:
      return find_midpoint_limit(k, c, least_damping_time);
    case Integrator::runge_kutta_4: {
      const double fastest = std::max(std::sqrt(std::max(k, 0.0)), c);
      return fastest > 0.0 ? kRungeKuttaRadius / fastest : kInfinity;
    }
    // t k <= c, and the stiffest has the least room
    case Integrator::symplectic_euler_implicit_damping:
      return solve_damped_limit(k, least_damping_time * k);
    default:
      return solve_limit(k, c);
  }
}

/// The step matrix is that of the characteristic equation
///
///     M (x'' - 2 x' + x) + dt C (x'' - x') + dt² K x' = 0,
///
/// with an eigenvalue -1 where 4 M + 2 dt C - dt² K is singular, and none outside the unit circle
/// while that is positive definite. Every motion u is within that up to a dt of its own, so the
/// limit is the least of those. It comes down on it: at a dt beyond, the vector of the largest
/// eigenvalue of dt² K - 2 dt C has a lower one.
double find_damped_limit(const TissueModel& model) {
  constexpr int kMostRounds = 30;
  constexpr double kSettled = 1e-4;
  const Tangents tangents(model);
  Eigen::VectorXd v = tangents.find_largest(1.0, 0.0).vector;
  double dt = kInfinity;
  for (int round = 0; round < kMostRounds; ++round) {
    const double k = v.dot(tangents.stiffness * v), c = v.dot(tangents.damping * v);
    const double next = solve_damped_limit(k, std::max(c, 0.0));
    if (!(next < dt)) break;
    const bool settled = dt - next <= kSettled * next;
    dt = next;
    if (settled) break;
    v = tangents.find_largest(dt * dt, -2.0 * dt).vector;
  }
  return dt;
}

double estimate_least_damping_time(const TissueModel& model) {
  return find_least_damping_time(Tangents(model));
}

double stable_step(const TissueModel& model, Integrator integrator) {
  if (integrator == Integrator::symplectic_euler) return stable_step(model);
  if (integrator == Integrator::symplectic_euler_implicit_damping) {
    return kLimitShare * find_damped_limit(model);
  }
  const double least = needs_damping(integrator) ? estimate_least_damping_time(model) : 0.0;
  return kLimitShare * find_step_limit(integrator, estimate_spectrum(model), least);
}

Spectrum estimate_spectrum(const TissueModel& model, double coupling) {
  const Tangents tangents(model);
  Spectrum spectrum;
  spectrum.stiffness = upper(tangents.find_largest(1.0, 0.0));
  spectrum.damping = upper(tangents.find_largest(0.0, 1.0));
  if (coupling > 0.0) {
    spectrum.stiffness = bound_with_any_coupling(model, spectrum.stiffness, coupling, [&](int i) {
      return std::min(spectrum.stiffness, find_largest_of_block(tangents.stiffness, i));
    });
  }
  return spectrum;
}

/// The step matrix of symplectic Euler about rest, M (x'' - 2 x' + x) + dt C (x' - x) + dt² K x' =
/// 0, has an eigenvalue -1 where 4 M - 2 dt C - dt² K is singular, and none outside the unit circle
/// while that is positive definite: the limit, exactly, whether or not K and C share their modes.
double stable_step(const TissueModel& model, double coupling) {
  const Tangents tangents(model);
  const double k = upper(tangents.find_largest(1.0, 0.0));
  const double c = upper(tangents.find_largest(0.0, 1.0));
  const double dt0 = find_limit(tangents, k, c);
  if (!(coupling > 0.0)) return kLimitShare * dt0;
  // held particles without any spring of their own still swing against the coupling
  if (!std::isfinite(dt0)) {
    return kLimitShare *
           solve_limit(bound_with_any_coupling(model, 0.0, coupling, [](int) { return 0.0; }), 0.0);
  }
  return kLimitShare * dt0 * find_part_with_coupling(model, tangents, dt0, c, coupling);
}

}  // namespace palpate
