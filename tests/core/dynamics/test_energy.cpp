// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/state.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

namespace {

/// The largest difference between the forces and minus the slope of the energy, as a part of the
/// largest force.
double compare_with_slope(const TissueModel& model, const Vec3& gravity, const Vec3Array& x) {
  constexpr double kShift = 1e-7;  // [m]; the error is kShift² and 1e-16 energy / kShift
  State state(model);
  state.position = x;
  Load load;
  load.gravity = gravity;
  Vec3Array f(x.size(), Vec3::Zero());
  compute_forces(model, load, x, state.velocity, f);
  Vec3Array slope(x.size(), Vec3::Zero());
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      state.position[i][c] = x[i][c] + kShift;
      const double above = compute_energy(model, gravity, state).total();
      state.position[i][c] = x[i][c] - kShift;
      const double below = compute_energy(model, gravity, state).total();
      state.position[i][c] = x[i][c];
      slope[i][c] = -(above - below) / (2.0 * kShift);
    }
  }
  return scenes::max_difference(f, slope) / scenes::max_norm(f);
}

}  // namespace

TEST_CASE("kinetic energy is m v² / 2 and gravity's is -m g·x") {
  TissueModel model;
  model.rest_position = {{0, 0, 0.5}, {0, 0, 0}};
  model.mass = {2.0, 1.0};
  State state(model);
  state.velocity[0] = {3.0, 0, 0};

  const Energy energy = compute_energy(model, {0, 0, -10.0}, state);

  CHECK(energy.kinetic == Approx(9.0));
  CHECK(energy.gravity == Approx(10.0));
  CHECK(energy.total() == Approx(19.0));
  CHECK(energy.elastic() == 0.0);
}

TEST_CASE("a link of 200 N/m stretched by 1 mm holds 0.1 mJ") {
  const TissueModel model = scenes::make_oscillator_model(1e-3, 200.0);
  State state(model);
  state.position[1].x() += 1e-3;

  CHECK(compute_energy(model, Vec3::Zero(), state).links == Approx(1e-4));
}

TEST_CASE("a right angle opened to 120 degrees holds K / 8, with stretch-bend K S / -2 more") {
  TissueModel model;
  model.rest_position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  model.mass.assign(3, 1.0);
  model.angles = scenes::make_angles({{0, 1, 2}}, model.rest_position, 0.0, 0.0);
  model.angles.bend_stiffness[0] = {2.0, 0.0, 0.0};
  State state(model);
  state.position[2] = {-0.5, std::sqrt(3.0) / 2.0, 0};

  CHECK(compute_energy(model, Vec3::Zero(), state).angles == Approx(2.0 / 8.0));

  model.angles.stretch_coupling[0] = {3.0, 0.0, 0.0};
  state.position[1] = {1.1, 0, 0};  // S = 0.1 m, q = -1/2

  CHECK(compute_energy(model, Vec3::Zero(), state).angles == Approx(0.25 - 3.0 * 0.5 * 0.1));
}

TEST_CASE("Eq 10 counts no energy") {
  const TissueModel model = scenes::make_molecular_organ(1, {}, AngleLaw::eq10);
  State state(model);
  scenes::shake(model, 1e-3, 0.0, state);

  CHECK(compute_energy(model, Vec3::Zero(), state).angles == 0.0);
  CHECK(compute_energy(model, Vec3::Zero(), state).links > 0.0);
}

TEST_CASE("a home spring of 5 N/m 2 mm from home holds 10 microjoules") {
  TissueModel model;
  model.rest_position = {{0.1, 0, 0}};
  model.mass = {1.0};
  model.home = {5.0};
  State state(model);
  state.position[0].y() += 2e-3;

  CHECK(compute_energy(model, Vec3::Zero(), state).home == Approx(1e-5));
}

TEST_CASE("pressure's energy is -p V wherever the body is") {
  TissueModel model;
  model.rest_position = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  model.mass.assign(4, 1.0);
  model.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  model.pressure = 600.0;
  State state(model);
  for (Vec3& x : state.position) x += Vec3(3.0, -2.0, 1.0);

  CHECK(compute_energy(model, Vec3::Zero(), state).pressure == Approx(-600.0 * 1e-3 / 6.0));
}

TEST_CASE("every conservative force is minus the slope of its energy") {
  const Vec3 gravity(0.5, -1.0, -9.81);
  const auto at = [](const TissueModel& model, double offset) {
    State state(model);
    const Vec3Array dx = scenes::scatter_vectors(model.mass.size(), offset, 4);
    for (std::size_t i = 0; i < dx.size(); ++i) state.position[i] += dx[i];
    return state.position;
  };
  const TissueModel springs = scenes::make_spring_organ(1);
  const TissueModel molecular = scenes::make_molecular_organ(1);
  TissueModel bending = molecular;
  bending.bonds = {};
  bending.angles.stretch_coupling.assign(bending.angles.corners.size(), {0.0, 0.0, 0.0});
  TissueModel coupling = molecular;
  coupling.bonds = {};
  coupling.angles.bend_stiffness.assign(coupling.angles.corners.size(), {0.0, 0.0, 0.0});
  TissueModel home = scenes::make_sheet_tissue();
  home.springs = {};
  TissueModel pressure = scenes::make_hollow_tissue();
  pressure.springs = {};
  pressure.home = {};

  for (const double offset : {1e-4, 1e-3, 5e-3}) {
    CAPTURE(offset);
    CHECK(compare_with_slope(springs, Vec3::Zero(), at(springs, offset)) < 1e-6);
    CHECK(compare_with_slope(molecular, Vec3::Zero(), at(molecular, offset)) < 1e-6);
    CHECK(compare_with_slope(bending, Vec3::Zero(), at(bending, offset)) < 1e-6);
    CHECK(compare_with_slope(coupling, Vec3::Zero(), at(coupling, offset)) < 1e-6);
    CHECK(compare_with_slope(home, Vec3::Zero(), at(home, offset)) < 1e-6);
    CHECK(compare_with_slope(pressure, Vec3::Zero(), at(pressure, offset)) < 1e-6);
    CHECK(compare_with_slope(springs, gravity, at(springs, offset)) < 1e-6);
  }
}

TEST_CASE("turning and moving the body changes no elastic energy") {
  const TissueModel model = scenes::make_molecular_organ(1);
  State state(model);
  scenes::shake(model, 2e-3, 0.1, state);
  State turned = state;
  const Mat3 turn = Eigen::AngleAxisd(2.1, Vec3(0.3, 1, -0.2).normalized()).toRotationMatrix();
  for (Vec3& x : turned.position) x = turn * x + Vec3(1.0, 2.0, -3.0);
  for (Vec3& v : turned.velocity) v = turn * v;

  const Energy before = compute_energy(model, Vec3::Zero(), state);
  const Energy after = compute_energy(model, Vec3::Zero(), turned);

  CHECK(after.links == Approx(before.links).epsilon(1e-9));
  CHECK(after.angles == Approx(before.angles).epsilon(1e-9));
  CHECK(after.kinetic == Approx(before.kinetic).epsilon(1e-12));
}
