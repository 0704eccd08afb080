// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>

#include "core/arm/plants.h"

using namespace palpate;

// How stiff a sampled spring may be that comes late by d [Colgate97]: K < b / (T/2 + d).

namespace {

constexpr double kTick = 1e-3;  // [s]

/// [N/m] that the rule allows for a delay of `ticks`, in the direction of the least damping.
double predict_stiffness(const Plant& plant, int ticks) {
  const Mat3 jacobian = compute_jacobian(find_arm(plant), kHome);
  double least = 1e9;
  for (int j = 0; j < 3; ++j) {
    const double damping = compute_motor_damping(plant.motor) + plant.viscous_friction[j];
    least = std::min(least, damping / jacobian.col(j).squaredNorm());
  }
  return least / (0.5 * kTick + ticks * kTick);
}

/// How far the tip swings, in the first and in the last of the seconds [m].
struct Swing {
  double early = 0.0, late = 0.0;
  bool grows() const { return late > 1.3 * early; }
  bool fades() const { return late < 0.7 * early; }
};

/// A spring in every direction to where the tip was, sampled and held for a tick, `ticks` late; the
/// tip is let go a millimetre beside.
Swing swing(const Plant& plant, double stiffness, int ticks, double seconds,
            const HandTarget& hand = {}) {
  const Arm arm = find_arm(plant);
  PlantState state(plant);
  state.joints = kHome + Vec3(5e-3, 3e-3, -3e-3);
  const Vec3 rest = compute_tip(arm, kHome);
  const double per_torque = 255.0 / compute_stall_torque(plant.motor);
  std::deque<Vec3> late(static_cast<std::size_t>(ticks), Vec3::Zero());
  Swing swing;
  for (int k = 0; k < seconds / kTick; ++k) {
    const Vec3 offset = rest - compute_tip(arm, state.joints);
    late.push_back(per_torque * (compute_jacobian(arm, state.joints).transpose() * offset) *
                   stiffness);
    move_plant(plant, {late.front(), true}, hand, kTick, state);
    late.pop_front();
    if (k * kTick < 1.0) swing.early = std::max(swing.early, offset.norm());
    if (k * kTick >= seconds - 1.0) swing.late = std::max(swing.late, offset.norm());
    if (offset.norm() > 0.03) return {swing.early, 1.0};  // gone
  }
  return swing;
}

}  // namespace

TEST_CASE("a spring of 0.7 of the predicted stiffness calms, one of 1.5 grows: 0 to 5 ms late") {
  const Plant plant = bare_plant();
  CHECK(predict_stiffness(plant, 0) == doctest::Approx(308.0).epsilon(0.01));  // [N/m]

  for (int ticks = 0; ticks <= 5; ++ticks) {
    CAPTURE(ticks);
    const double most = predict_stiffness(plant, ticks);
    CHECK(swing(plant, 0.7 * most, ticks, 12.0).fades());
    CHECK(swing(plant, 1.5 * most, ticks, 12.0).grows());
  }
}

TEST_CASE("friction stands far more than the rule allows: there the rule is careful, not sharp") {
  Plant plant = bare_plant();
  plant.dry_friction.setConstant(0.015);  // [N m] 0.1 N at the tip

  for (int ticks = 0; ticks <= 2; ++ticks) {
    CAPTURE(ticks);
    CHECK(swing(plant, 3.0 * predict_stiffness(plant, ticks), ticks, 6.0).fades());
  }
}

TEST_CASE("held by a hand and with friction the arm stands several times what the rule allows") {
  const Plant plant;
  const HandTarget hand{compute_tip(find_arm(plant), kHome), Vec3::Zero(), true};
  for (int ticks : {0, 2, 5}) {
    double least = predict_stiffness(plant, ticks), most = 3e4;
    REQUIRE(swing(plant, least, ticks, 2.0, hand).fades());
    for (int i = 0; i < 6; ++i) {
      const double middle = std::sqrt(least * most);
      (swing(plant, middle, ticks, 2.0, hand).fades() ? least : most) = middle;
    }
    const double margin = least / predict_stiffness(plant, ticks);
    std::printf("%d ms late, held: stable up to %.0f N/m, %.1f times the rule\n", ticks, least,
                margin);
    CHECK(margin > 3.0);
  }
}
