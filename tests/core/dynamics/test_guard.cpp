// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/dynamics/step.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

namespace {

/// Checks a tissue that `change` has done something to since the last check.
template <class Change>
Alarm check_after(const TissueModel& model, Change change, int steps = 1) {
  State state(model);
  state.time = 0.25;
  Guard guard(model, Vec3::Zero(), state);
  change(state);
  return check(model, Vec3::Zero(), state, 0.0, guard, steps);
}

/// What the last of `checks` says of a tissue that stays as `change` has made it.
template <class Change>
Alarm check_again(const TissueModel& model, Change change, int checks) {
  State state(model);
  Guard guard(model, Vec3::Zero(), state);
  change(state);
  Alarm alarm;
  for (int i = 0; i < checks; ++i) alarm = check(model, Vec3::Zero(), state, 0.0, guard, 100);
  return alarm;
}

}  // namespace

TEST_CASE("a tissue at rest raises no alarm, and none is false") {
  const TissueModel model = scenes::make_molecular_organ(1);

  const Alarm alarm = check_after(model, [](State&) {});

  CHECK_FALSE(alarm);
  CHECK(alarm.kind == AlarmKind::none);
}

TEST_CASE("what is not finite is found in positions and in velocities, with its particle") {
  const TissueModel model = scenes::make_chain_model(5);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), double(INFINITY)}) {
    const Alarm position = check_after(model, [&](State& s) { s.position[3].y() = bad; });
    const Alarm velocity = check_after(model, [&](State& s) { s.velocity[2].z() = bad; });

    CHECK(position.kind == AlarmKind::not_finite);
    CHECK(position.index == 3);
    CHECK(position.time == 0.25);
    CHECK(velocity.kind == AlarmKind::not_finite);
    CHECK(velocity.index == 2);
  }
}

TEST_CASE("a particle may move 0.3 of the shortest rest length in a step, farther with energy") {
  TissueModel model = scenes::make_chain_model(3);
  model.springs.rest_length[1] = 0.008;
  model.springs.stiffness = {1e-9, 1e-9};  // no energy worth an alarm
  // with a fifth more energy than was given: no alarm of energy, and none was given
  const auto check_move = [&](double by, double part, int steps = 1) {
    State state(model);
    state.velocity[1] = {0.1, 0, 0};  // 5 microjoules
    Guard guard(model, Vec3::Zero(), state);
    state.position[1].y() += by;
    state.velocity[1] *= std::sqrt(part);
    return check(model, Vec3::Zero(), state, 0.0, guard, steps);
  };

  CHECK_FALSE(check_move(0.0023, 1.2));
  const Alarm alarm = check_move(0.0025, 1.2);
  CHECK(alarm.kind == AlarmKind::moved_far);
  CHECK(alarm.index == 1);
  CHECK(alarm.value == Approx(0.0025));
  CHECK(alarm.limit == Approx(0.0024));
  CHECK_FALSE(check_move(0.0025, 1.2, 2));  // two steps between checks
  CHECK_FALSE(check_move(0.0025, 1.0));     // it snapped, with the energy it had
  CHECK_FALSE(check_move(0.1, 1.0));
}

TEST_CASE("a link may be strained by 9 and pressed to a twentieth, springs counted before bonds") {
  TissueModel model = scenes::make_chain_model(4);
  model.springs.stiffness.assign(3, 1e-9);
  model.bonds = {{{0, 3}}, {0.02}, {1e-9}, {0.0}};
  const auto stretch = [](double part) {
    return [part](State& s) { s.position[3].x() = s.position[2].x() + 0.01 * part; };
  };

  CHECK_FALSE(check_again(model, stretch(9.9), 30));
  const Alarm far = check_again(model, stretch(10.1), 10);
  CHECK(far.kind == AlarmKind::overstretched);
  CHECK(far.index == 2);
  CHECK(far.value == Approx(9.1));
  CHECK(far.limit == 9.0);

  CHECK_FALSE(check_again(model, stretch(0.06), 10));
  const Alarm near = check_again(model, stretch(0.04), 10);
  CHECK(near.kind == AlarmKind::collapsed);
  CHECK(near.index == 2);
  CHECK(near.value == Approx(0.04));

  const auto stretch_all = [](State& s) {
    for (int i = 1; i < 4; ++i) s.position[i].x() *= 7.0;
  };
  const Alarm bond = check_again(model, stretch_all, 10);
  CHECK(bond.kind == AlarmKind::overstretched);
  CHECK(bond.index == 3);
}

TEST_CASE("a link out of its bounds for nine checks has been flung, for ten it has blown up") {
  TissueModel model = scenes::make_chain_model(3);
  model.springs.stiffness.assign(2, 1e-9);
  const auto fling = [](State& s) { s.position[2].x() = s.position[1].x() + 0.11; };
  State state(model);
  Guard guard(model, Vec3::Zero(), state);
  const auto check_next = [&] { return check(model, Vec3::Zero(), state, 0.0, guard, 100); };

  CHECK_FALSE(check_again(model, fling, 9));
  CHECK(check_again(model, fling, 10).kind == AlarmKind::overstretched);

  fling(state);
  for (int i = 0; i < 9; ++i) CHECK_FALSE(check_next());
  state.position[2] = model.rest_position[2];
  CHECK_FALSE(check_next());
  fling(state);
  for (int i = 0; i < 9; ++i) CHECK_FALSE(check_next());  // counted from zero
}

TEST_CASE("a link strained by more than 2 is an alarm where there is more energy than was given") {
  TissueModel model = scenes::make_chain_model(3);
  model.springs.stiffness.assign(2, 1e-9);
  const auto stretch = [&](double strain, double part) {
    State state(model);
    state.velocity[1] = {0.1, 0, 0};  // 5 microjoules
    Guard guard(model, Vec3::Zero(), state);
    state.position[2].x() = state.position[1].x() + 0.01 * (1.0 + strain);
    state.velocity[1] *= std::sqrt(part);
    Alarm alarm;
    for (int i = 0; i < 10; ++i) alarm = check(model, Vec3::Zero(), state, 0.0, guard, 100);
    return alarm;
  };

  CHECK_FALSE(stretch(2.1, 1.0));
  CHECK_FALSE(stretch(1.9, 1.2));
  const Alarm alarm = stretch(2.1, 1.2);
  CHECK(alarm.kind == AlarmKind::overstretched);
  CHECK(alarm.limit == 2.0);
}

TEST_CASE("energy from nowhere is an alarm at once when it is half as much again") {
  const TissueModel model = scenes::make_chain_model(3);
  State state(model);
  state.velocity[1] = {0.1, 0, 0};  // 5 microjoules
  Guard guard(model, Vec3::Zero(), state);
  CHECK(guard.start_energy == Approx(5e-6));
  CHECK(guard.reference_energy == Approx(5e-6));

  state.velocity[1] *= std::sqrt(1.45);
  CHECK_FALSE(check(model, Vec3::Zero(), state, 0.0, guard));
  state.velocity[1] = {0.1 * std::sqrt(1.55), 0, 0};
  const Alarm alarm = check(model, Vec3::Zero(), state, 0.0, guard);

  CHECK(alarm.kind == AlarmKind::energy);
  CHECK(alarm.index == -1);
  CHECK(alarm.value == Approx(7.75e-6));
  CHECK(alarm.limit == Approx(7.5e-6));
}

TEST_CASE("energy that rises three checks in a row without work is an alarm, twice is not") {
  const TissueModel model = scenes::make_chain_model(3);
  State state(model);
  state.velocity[1] = {0.1, 0, 0};
  Guard guard(model, Vec3::Zero(), state);
  const auto look_at_energy = [&](double part) {
    state.velocity[1] = {0.1 * std::sqrt(part), 0, 0};
    return check(model, Vec3::Zero(), state, 0.0, guard).kind;
  };

  CHECK(look_at_energy(1.06) == AlarmKind::none);
  CHECK(look_at_energy(1.12) == AlarmKind::none);
  CHECK(look_at_energy(1.10) == AlarmKind::none);  // it fell: the count starts again
  CHECK(look_at_energy(1.16) == AlarmKind::none);
  CHECK(look_at_energy(1.22) == AlarmKind::none);
  CHECK(look_at_energy(1.28) == AlarmKind::energy);
}

TEST_CASE("energy that work, gravity or pressure has brought is no alarm") {
  const TissueModel model = scenes::make_chain_model(3);
  State state(model);
  Guard guard(model, Vec3::Zero(), state);
  state.velocity[1] = {0.1, 0, 0};
  CHECK_FALSE(check(model, Vec3::Zero(), state, 5e-6, guard));
  CHECK(guard.work == Approx(5e-6));

  // falling free by 1 mm
  TissueModel ball;
  ball.rest_position = {{0, 0, 0}};
  ball.mass = {2.0};
  State falling(ball);
  const Vec3 gravity(0, 0, -10.0);
  Guard witness(ball, gravity, falling);
  falling.position[0].z() -= 1e-3;
  falling.velocity[0].z() = -std::sqrt(2.0 * 10.0 * 1e-3);
  CHECK_FALSE(check(ball, gravity, falling, 0.0, witness));
  CHECK(witness.work == Approx(0.02));
  CHECK(witness.last_energy == Approx(0.02));

  // blown up by 1 % in every direction; energy as much as p dV
  TissueModel bladder = scenes::make_hollow_tissue();
  bladder.home = {};
  bladder.springs = {};
  State blown(bladder);
  const double before = compute_energy(bladder, Vec3::Zero(), blown).pressure;
  Guard keeper(bladder, Vec3::Zero(), blown);
  for (Vec3& x : blown.position) x *= 1.01;
  const double given = before - compute_energy(bladder, Vec3::Zero(), blown).pressure;
  blown.velocity[0].z() = std::sqrt(2.0 * given / bladder.mass[0]);
  CHECK_FALSE(check(bladder, Vec3::Zero(), blown, 0.0, keeper));
  CHECK(keeper.work == Approx(given).epsilon(1e-4));
}

TEST_CASE("work that damping has long taken does not make the alarm deaf") {
  const TissueModel model = scenes::make_chain_model(3);
  State state(model);
  Guard guard(model, Vec3::Zero(), state);
  for (int second = 0; second < 20; ++second) {  // a joule goes in and is gone again, every second
    state.time += 1.0;
    REQUIRE_FALSE(check(model, Vec3::Zero(), state, 1.0, guard));
  }
  CHECK(guard.work == Approx(20.0));

  state.time += 1.0;
  state.velocity[1] = {std::sqrt(2.0 * 1.6 / 1e-3), 0, 0};  // 1.6 J, and none given

  CHECK(check(model, Vec3::Zero(), state, 0.0, guard).kind == AlarmKind::energy);
}

TEST_CASE("trembling below 1 mm/s of the whole tissue is no alarm") {
  const TissueModel model = scenes::make_chain_model(3);
  const auto tremble = [&](double speed) {
    return check_after(model, [speed](State& s) {
      for (int i = 1; i < 3; ++i) s.velocity[i] = {speed, 0, 0};
    });
  };

  CHECK_FALSE(tremble(5e-4));
  CHECK(tremble(1e-2).kind == AlarmKind::energy);
}

TEST_CASE("under Eq 10, which has no energy, geometry alone is checked") {
  const TissueModel model = scenes::make_molecular_organ(1, {}, AngleLaw::eq10);

  CHECK_FALSE(check_after(model, [](State& s) { s.velocity[30] = {5.0, 0, 0}; }));
  CHECK(check_after(model, [](State& s) { s.position[30] *= 1.5; }).kind == AlarmKind::moved_far);
}
