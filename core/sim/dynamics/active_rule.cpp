// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/sim/base/refuse.h"
#include "palpate/sim/dynamics/follow_motion.h"
#include "palpate/sim/dynamics/free_particles.h"

namespace palpate {
namespace {

/// What lies nearer than this many decay lengths always moves: frozen at half of one, 40 to 100 %
/// of the force is wrong (PERFORMANCE 1.6).
constexpr double kDecayLengths = 2.0;

/// K1(2)/K0(2), modified Bessel functions of the second kind: how steeply a displacement falls off
/// around a ring two decay lengths out, in 1/decay length.
constexpr double kSteepness = 1.228;

/// [m] The longest decay length of any particle with its neighbours. A pull u along a surface with
/// links falls off as the screened equation l² Δu = u says. A particle's links give it
///
///     h l² = sum k L² / 8,
///
/// the mean over all directions of link and of pull of k (n·e)² L² / 2, for home springs h.
double find_decay(const TissueModel& model) {
  std::vector<double> spread(model.mass.size(), 0.0);  // [N·m]
  const auto for_each_end = [&](auto action) {
    for (const Links* links : {&model.springs, &model.bonds}) {
      for (std::size_t l = 0; l < links->ends.size(); ++l) {
        const auto [i, j] = links->ends[l];
        action(static_cast<std::size_t>(i), static_cast<std::size_t>(j), *links, l);
        action(static_cast<std::size_t>(j), static_cast<std::size_t>(i), *links, l);
      }
    }
  };
  for_each_end([&](std::size_t i, std::size_t, const Links& links, std::size_t l) {
    const double length = links.rest_length[l];
    spread[i] += std::max(0.0, links.stiffness[l]) * length * length / 8.0;
  });
  // one particle alone has as many neighbours, and as much area, as chance gave it
  std::vector<double> around = spread, home = model.home;
  for_each_end([&](std::size_t i, std::size_t j, const Links&, std::size_t) {
    around[i] += spread[j];
    home[i] += model.home[j];
  });
  double decay = 0.0;
  for_each_free(model, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    decay = std::max(decay, std::sqrt(around[at] / home[at]));
  });
  return decay;
}

/// [N/m³] of the tissue's surface; where it is held, home springs do no work.
double find_home_of_area(const TissueModel& model) {
  double home = 0.0, area = 0.0;
  for (const double h : model.home) home += h;
  for (const auto& [i, j, k] : model.triangles) {
    const Vec3Array& x = model.rest_position;
    area += 0.5 * (x[static_cast<std::size_t>(j)] - x[static_cast<std::size_t>(i)])
                      .cross(x[static_cast<std::size_t>(k)] - x[static_cast<std::size_t>(i)])
                      .norm();
  }
  return home / area;
}

}  // namespace

/// Let everything outside a ring of radius r stand off from where it belongs by at most u. It takes
///
///     S = 2 pi r l h K1(r/l)/K0(r/l)      [N/m], h the home springs of an area [N/m³]
///
/// to move the ring, and a tool moved by 1 moves the ring by less than exp(-2) where that is two
/// decay lengths away. By Betti's theorem the tool then feels at most S u exp(-2) too much or too
/// little: u = force_error exp(2) / S. Farther out r exp(-r/l) only falls.
ActiveRule derive_active_rule(const TissueModel& model, double radius, double force_error) {
  const std::string where = "scene: force_error [N]";
  if (!model.volumes.corners.empty()) {
    refuse(where, "a tissue with volumes",
           "0: solids are moved whole, for they have no home springs, and without those a push is "
           "felt with one over its distance");
  }
  if (!model.prisms.corners.empty()) {
    refuse(where, "a tissue with prisms",
           "0: walls of prisms are moved whole, for what may sleep follows from how far springs "
           "carry a pull, which is not how far a wall bends");
  }
  if (!model.elastic.corners.empty()) {
    refuse(where, "a linear solid",
           "0: it costs what is touched, so there is nothing to let sleep");
  }
  bool has_home = !model.home.empty() && !model.triangles.empty();
  for_each_free(
      model, [&](int i) { has_home = has_home && model.home[static_cast<std::size_t>(i)] > 0.0; });
  if (!has_home) {
    refuse(where, "a tissue with particles that have no home springs",
           "0, or home springs everywhere: without them a push is felt at any distance");
  }
  ActiveRule rule;
  rule.decay = find_decay(model);
  rule.reach = radius + kDecayLengths * rule.decay;
  const double ring =
      2.0 * std::numbers::pi * rule.reach * rule.decay * find_home_of_area(model) * kSteepness;
  rule.threshold = force_error * std::exp(kDecayLengths) / ring;
  return rule;
}

}  // namespace palpate
