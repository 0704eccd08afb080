// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/dynamics/private/step_limit.h"
#include "palpate/sim/tick/private/choose_substeps.h"

namespace palpate {
namespace {

/// The integrator whose limit a body is given substeps by.
Integrator find_limiting(const SoftBody& body) noexcept {
  return body.integrator == Integrator::xpbd ? Integrator::symplectic_euler : body.integrator;
}

/// [s] A stable step by implicit damping of a tissue with this part p of its stiffness and damping.
/// Of dt0, the limit of all of it, s times leave
///
///     s p (dt0² K - 2 dt0 C) + s (s - 1) p dt0² K <= 4 s p + s (s - 1) a,   a = p dt0² lambda_K,
///
/// and 4 is enough [motion: implicit damping].
double find_damped_step(const SoftBody& body, double part) noexcept {
  const double dt0 = body.damped_limit, a = part * dt0 * dt0 * body.spectrum_stiffness;
  if (!std::isfinite(dt0) || !(a > 0.0)) return dt0;
  const double b = 4.0 * part - a;
  return dt0 * (std::sqrt(b * b + 16.0 * a) - b) / (2.0 * a);
}

/// [s] The stable step, reserve included, of a tissue with this part of its stiffness and damping:
/// both eigenvalues go with it, and the quotient of the two stays.
double find_stable_step(const SoftBody& body, double part) noexcept {
  const Spectrum spectrum{part * body.spectrum_stiffness, part * body.spectrum_damping};
  if (body.integrator == Integrator::symplectic_euler_implicit_damping) {
    return kLimitShare * find_damped_step(body, part);
  }
  return kLimitShare * find_step_limit(find_limiting(body), spectrum, body.least_damping_time);
}

double round_down(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return unit * std::floor(value / unit * (1.0 + 1e-12));
}

}  // namespace

double count_needed_substeps(double rate, const SoftBody& body) {
  if (find_limiting(body) == Integrator::symplectic_euler) {
    return 1.0 / (rate * stable_step(body.tissue));
  }
  return 1.0 / (rate * find_stable_step(body, 1.0));
}

double find_fitting_part(double rate, const SoftBody& body, double substeps) {
  constexpr double kLeast = 1e-12;
  constexpr int kHalvings = 60;
  const double step = 1.0 / (rate * substeps);
  const auto fits = [&](double part) { return step <= find_stable_step(body, part); };
  if (fits(1.0)) return 1.0;
  if (!fits(kLeast)) return 0.0;
  double good = std::log(kLeast), bad = 0.0;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = 0.5 * (good + bad);
    (fits(std::exp(middle)) ? good : bad) = middle;
  }
  return round_down(std::exp(good));
}

void require_enough_substeps(const std::string& where, double rate, const SoftBody& body) {
  constexpr double kRoom = 1.01;  // a spectrum is estimated to a hundredth at worst
  if (body.kernel == Kernel::response) return;
  const double needed = count_needed_substeps(rate, body);
  if (!(needed > kRoom * body.substeps)) return;
  const double given = 1e3 / (rate * body.substeps);  // [ms]
  const double stable = 1e3 / (rate * needed);        // [ms]
  const double part = find_fitting_part(rate, body, body.substeps);
  if (!(part > 0.0)) {
    refuse(where, write_text(body.substeps, ", steps of ", given, " ms"),
           write_text("at least ", std::ceil(needed), " (and a substeps_max of no less): the ",
                      "tissue at rest is stable up to ", stable, " ms"));
  }
  refuse(where, write_text(body.substeps, ", steps of ", given, " ms"),
         write_text("at least ", std::ceil(needed), " (and a substeps_max of no less): the ",
                    "tissue at rest is stable up to ", stable, " ms; or at most ", part,
                    " of all its stiffness and damping"));
}

}  // namespace palpate
