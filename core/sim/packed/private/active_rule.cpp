// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/sim/dynamics/private/free_particles.h"
#include "palpate/sim/model/private/law_tables.h"
#include "palpate/sim/packed/private/follow_motion.h"

namespace palpate {
namespace {

/// What lies nearer than this many decay lengths always moves: frozen at half of one, 40 to 100 %
/// of the force is wrong [motion: active set].
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

/// [m] By how much the mover of a ring may be off, over how much the ring itself has moved and how
/// deep the tool is. Where what sleeps begins, at r, it holds the tissue on both sides of it by
///
///     S = 2 pi h l² / (I0(r/l) K0(r/l)) < 4 pi h l r     [N/m]
///
/// of what it stands off by. A tool that has moved the ring by u when it has moved by d moves it by
/// 2 u/d at most when it moves by 1 more: the pull along a wall grows as the square of a dent. So
/// by Betti's theorem an U too much or too little there is felt as S U 2 u/d, and what may sleep is
///
///     U u < force_error d / (2 S).
///
/// r is where this ends at U = u. With the field K0(r/l)/K0(radius/l) = u/d around a tool, and
/// K0/I0 < pi exp(-2r/l), it is l/2 log(4 pi² h l² d / (force_error K0²(radius/l))). Deeper than l
/// no dent is small, and a tool counts as that deep.
double derive_product_limit(const ActiveRule& rule, double home_of_area, double radius,
                            double force_error) {
  constexpr double kPi = std::numbers::pi;
  const double pull = home_of_area * rule.decay * rule.decay;  // [N/m]
  const double at_tool = std::cyl_bessel_k(0.0, radius / rule.decay);
  const double ring =
      0.5 * std::log(4.0 * kPi * kPi * pull * rule.decay / (force_error * at_tool * at_tool));
  return force_error / (8.0 * kPi * pull * std::max(rule.reach / rule.decay, ring));
}

}  // namespace

/// Let everything outside a ring of radius r stand off from where it belongs by at most u. It takes
///
///     S = 2 pi r l h K1(r/l)/K0(r/l)      [N/m], h the home springs of an area [N/m³]
///
/// to move the ring, and a tool moved by 1 moves the ring by less than exp(-2) where that is two
/// decay lengths away. By Betti's theorem the tool then feels at most S u exp(-2) too much or too
/// little: u = force_error exp(2) / S. Farther out r exp(-r/l) only falls. That is for any tool,
/// and far too careful for one whose dent can be seen: derive_product_limit().
ActiveRule derive_active_rule(const TissueModel& model, double radius, double force_error) {
  const std::string where = "scene: force_error [N]";
  laws::for_each_law([&](const auto& law) {
    if (law.whole.got == nullptr || !laws::is_present(model, law)) return;
    refuse(where, law.whole.got, law.whole.expected);
  });
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
  const double home_of_area = find_home_of_area(model);
  const double ring = 2.0 * std::numbers::pi * rule.reach * rule.decay * home_of_area * kSteepness;
  rule.threshold = force_error * std::exp(kDecayLengths) / ring;
  rule.product_limit_per_depth = derive_product_limit(rule, home_of_area, radius, force_error);
  return rule;
}

}  // namespace palpate
