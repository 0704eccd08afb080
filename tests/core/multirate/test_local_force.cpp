// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "palpate/sim/multirate/private/local_force.h"

using namespace palpate;
using doctest::Approx;

namespace {

constexpr double kInterval = 0.01;  // [s]

/// Tissue of 100 N/m below z = 0, pressed 1 mm at `time`.
LocalModel make_model(double time, double force = 0.1) {
  LocalModel model;
  model.time = time;
  model.position = {0.0, 0.0, -0.001};
  model.force = {0.0, 0.0, force};
  model.normal = Vec3::UnitZ();
  model.stiffness = 100.0 * Vec3::UnitZ() * Vec3::UnitZ().transpose();
  return model;
}

LocalForce make_force(LocalForceMode mode = LocalForceMode::local_stiffness) {
  return {Coupling{.stiffness = 400.0, .force_max = 5.0}, mode, kInterval};
}

}  // namespace

TEST_CASE("before a first model nothing is felt") {
  LocalForce force = make_force();
  CHECK(force.render({0.0, 0.0, -1.0}, 0.0) == Vec3::Zero());
  CHECK_FALSE(force.is_stale(1e3));
}

TEST_CASE("the hand's spring and the tissue are in series: 400 and 100 N/m are 80") {
  LocalForce force = make_force();
  force.take(make_model(0.0), 0.0);

  // the tool is 1 mm deep where the hand is 1.25 mm deep
  CHECK(force.render({0.0, 0.0, -0.00125}, 0.0).z() == Approx(0.1));
  CHECK(force.render({0.0, 0.0, -0.00225}, 0.0).z() == Approx(0.1 + 80.0 * 0.001));
}

TEST_CASE("tissue does not pull: out of it and beside it the hand is free") {
  LocalForce force = make_force();
  force.take(make_model(0.0), 0.0);

  CHECK(force.render({0.0, 0.0, 0.0}, 0.0).norm() < 1e-15);
  CHECK(force.render({0.0, 0.0, 0.005}, 0.0) == Vec3::Zero());
}

TEST_CASE("attached, it pulls") {
  LocalForce force = make_force();
  LocalModel model = make_model(0.0);
  model.held = true;
  force.take(model, 0.0);

  CHECK(force.render({0.0, 0.0, 0.005}, 0.0).z() == Approx(-80.0 * 0.005));
}

TEST_CASE("sideways no model pushes harder than outwards") {
  LocalForce force = make_force();
  LocalModel model = make_model(0.0);
  model.stiffness = 100.0 * Mat3::Identity();
  force.take(model, 0.0);

  const Vec3 felt = force.render({0.05, 0.0, -0.00125}, 0.0);

  CHECK(felt.z() == Approx(0.1));
  CHECK(felt.x() == Approx(-0.1));
}

TEST_CASE("a new model comes in over half an interval, without a jump") {
  LocalForce force = make_force();
  const Vec3 hand(0.0, 0.0, -0.00125);
  force.take(make_model(0.0), 0.0);
  force.render(hand, 0.009);

  force.take(make_model(0.01, 0.3), 0.01);

  const double after = 0.8 * 0.3 + 80.0 * (0.00125 - 0.001);
  CHECK(force.render(hand, 0.01).z() == Approx(0.1));
  CHECK(force.render(hand, 0.0125).z() == Approx(0.5 * (0.1 + after)));
  CHECK(force.render(hand, 0.015).z() == Approx(after));
}

TEST_CASE("what is left of a contact fades where the new model has none") {
  LocalForce force = make_force();
  const Vec3 hand(0.0, 0.0, -0.00125);
  force.take(make_model(0.0), 0.0);
  force.render(hand, 0.009);

  force.take({.time = 0.01}, 0.01);

  CHECK(force.render(hand, 0.0125).z() == Approx(0.05));
  CHECK(force.render(hand, 0.015).norm() < 1e-12);
}

TEST_CASE("a model older than three intervals is let go of in 20 ms") {
  LocalForce force = make_force();
  const Vec3 hand(0.0, 0.0, -0.00125);
  force.take(make_model(0.0), 0.01);
  for (int t = 10; t <= 30; ++t) CHECK(force.render(hand, 1e-3 * t).z() == Approx(0.1));

  double last = 0.1;
  for (int t = 31; t <= 51; ++t) {
    const double now = force.render(hand, 1e-3 * t).z();
    CHECK(force.is_stale(1e-3 * t));
    CHECK(last - now < 0.1 / 20.0 + 1e-9);
    last = now;
  }
  CHECK(last == Approx(0.0));

  // and taken up again without a jump
  force.take(make_model(0.052), 0.052);
  CHECK(force.render(hand, 0.052).z() < 1e-9);
  CHECK(force.render(hand, 0.057).z() == Approx(0.1));
}

TEST_CASE("held, the force is the last one told; extrapolated, on the line through two") {
  LocalForce held = make_force(LocalForceMode::hold);
  LocalForce line = make_force(LocalForceMode::extrapolation);
  for (LocalForce* force : {&held, &line}) {
    force->take(make_model(0.00, 0.1), 0.01);
    CHECK(force->render({0, 0, 0}, 0.015).z() == Approx(0.1));
    force->take(make_model(0.01, 0.2), 0.02);
  }

  CHECK(held.render({0, 0, 0}, 0.025).z() == Approx(0.2));
  CHECK(line.render({0, 0, 0}, 0.025).z() == Approx(0.2 + 10.0 * 0.015));
}

TEST_CASE("no force is above that of the coupling, nor anything but a number") {
  LocalForce force = make_force();
  force.take(make_model(0.0), 0.0);

  CHECK(force.render({0.0, 0.0, -10.0}, 0.001).z() == Approx(5.0));
  CHECK(force.render(Vec3::Constant(std::nan("")), 0.002).z() == Approx(5.0));
}
