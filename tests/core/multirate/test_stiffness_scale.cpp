// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "palpate/sim/multirate/private/stiffness_scale.h"

// What a tissue shows of its stiffness from exchange to exchange [stability: slow tissue].

using namespace palpate;
using doctest::Approx;

namespace {

constexpr double kTrue = 40.0, kCoupling = 1000.0;  // [N/m] of a tissue with its surface at z = 0

/// What is measured of it where a tool is pressed so deep [m].
LocalModel measure(double depth, double told) {
  LocalModel model;
  model.position = {0.0, 0.0, -depth};
  model.normal = Vec3::UnitZ();
  model.force = kTrue * depth * model.normal;
  model.stiffness = told * model.normal * model.normal.transpose();
  return model;
}

void follow(StiffnessScale& scale, LocalModel& model) {
  scale.follow(model.position - model.force / kCoupling, kCoupling, model);
}

/// [N/m] What is told at the end of a press to 3 mm.
double press(StiffnessScale& scale, double wrong) {
  double found = 0.0;
  for (int i = 1; i <= 12; ++i) {
    LocalModel model = measure(2.5e-4 * i, wrong * kTrue);
    follow(scale, model);
    found = model.stiffness(2, 2);
  }
  return found;
}

}  // namespace

TEST_CASE("a stiffness that is told wrong comes right in the course of a press") {
  for (const double wrong : {0.6, 1.0, 2.0, 3.0}) {
    CAPTURE(wrong);
    StiffnessScale scale;

    CHECK(press(scale, wrong) == Approx(kTrue).epsilon(0.12));
  }
}

TEST_CASE("under a hand that rests a tissue that swings teaches nothing") {
  StiffnessScale scale;
  press(scale, 2.0);
  const double learned = scale.value();
  const LocalModel pressed = measure(3e-3, 2.0 * kTrue);
  const Vec3 hand = pressed.position - pressed.force / kCoupling;
  LocalModel first = pressed;
  scale.follow(hand, kCoupling, first);
  const double rested = scale.value();

  for (int i = 0; i < 1000; ++i) {
    LocalModel model = pressed;
    model.force *= 1.0 + 0.5 * std::cos(3.0 * i);
    model.position = hand + model.force / kCoupling;
    scale.follow(hand, kCoupling, model);
  }

  CHECK(rested == learned);
  CHECK(scale.value() == learned);
}

TEST_CASE("a hand that strikes, touches, lets go or takes hold teaches nothing") {
  StiffnessScale scale;
  press(scale, 2.0);
  const double learned = scale.value();

  LocalModel away = measure(0.0, 3.0 * kTrue);  // of a trial: no force
  follow(scale, away);
  CHECK(away.stiffness(2, 2) == Approx(3.0 * kTrue * learned));
  LocalModel touching = measure(5e-4, 2.0 * kTrue);
  follow(scale, touching);
  LocalModel struck = measure(5e-3, 2.0 * kTrue);
  struck.force *= 0.3;  // the tissue has not yet answered
  follow(scale, struck);
  LocalModel attached = measure(1e-3, 2.0 * kTrue);
  attached.held = true;
  follow(scale, attached);

  CHECK(scale.value() == learned);
}

TEST_CASE("along the surface, where K says nothing, a force that changes teaches nothing") {
  StiffnessScale scale;
  const LocalModel model = measure(2e-3, kTrue);
  const Vec3 hand = model.position - model.force / kCoupling;
  for (int i = 0; i < 100; ++i) {
    LocalModel slipping = model;
    slipping.force *= 1.0 + 0.003 * i;
    scale.follow(hand + Vec3(1e-4 * i, 0.0, 0.0), kCoupling, slipping);
  }

  CHECK(scale.value() == 1.0);
}

TEST_CASE("whatever a tissue shows, a stiffness is between a fifth and twice what was measured") {
  StiffnessScale soft, hard;
  const auto move = [](StiffnessScale& scale, int i, double told) {
    LocalModel model = measure(3e-3 + 1e-4 * (i % 2), told);
    follow(scale, model);
  };
  for (int i = 0; i <= 200; ++i) {
    move(soft, i, 10.0 * kTrue);
    move(hard, i, 0.2 * kTrue);
  }

  CHECK(soft.value() == 0.2);
  CHECK(hard.value() == 2.0);
}
