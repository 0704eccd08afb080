// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "palpate/sim/arm/plant.h"

using namespace palpate;

namespace {

Plant frictionless() {
  Plant plant;
  plant.dry_friction.setZero();
  plant.viscous_friction.setZero();
  return plant;
}

/// Kinetic energy [J] of the arm cut into many point masses: what the mass matrix must say.
double add_up_kinetic_energy(const Plant& plant, const Vec3& q, const Vec3& v) {
  const Arm arm = find_arm(plant);
  const auto along = [&](double upper, double forearm) {
    Arm part = arm;
    part.upper_length = upper;
    part.forearm_length = forearm;
    return Vec3(compute_jacobian(part, q) * v).squaredNorm();
  };
  constexpr int kPieces = 2000;
  double energy = 0.5 * plant.masses.gimbal * along(arm.upper_length, arm.forearm_length);
  for (int i = 0; i < kPieces; ++i) {
    const double part = (i + 0.5) / kPieces;
    energy += 0.5 * plant.masses.upper / kPieces * along(part * arm.upper_length, 0.0);
    energy +=
        0.5 * plant.masses.forearm / kPieces * along(arm.upper_length, part * arm.forearm_length);
  }
  return energy + 0.5 * plant.masses.motor * v.squaredNorm();
}

}  // namespace

TEST_CASE("the mass matrix has the kinetic energy of the arm cut into small pieces") {
  const Plant plant;
  const Vec3 v(1.1, -0.7, 0.4);

  for (const Vec3& q : {Vec3(0.2, 0.5, 0.5), Vec3(-0.4, 1.2, 0.3), Vec3(0.9, 0.1, 1.1)}) {
    const Mat3 mass = compute_mass(plant, q, false);
    CHECK(0.5 * v.dot(mass * v) == doctest::Approx(add_up_kinetic_energy(plant, q, v)));
    CHECK((mass - mass.transpose()).norm() == 0.0);
  }
}

TEST_CASE("the tip is felt with a mass of 55 to 210 g along every axis of the workspace") {
  const Plant plant;
  const Arm arm = find_arm(plant);

  for (const double x : {-0.1, 0.0, 0.1}) {
    const Vec3 q = *find_joints(arm, Workspace{}.center + Vec3(x, 0.0, 0.0));
    const Mat3 jacobian = compute_jacobian(arm, q);
    const Mat3 mobility = jacobian * compute_mass(plant, q, false).inverse() * jacobian.transpose();
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(1.0 / mobility(axis, axis) > 0.055);
      CHECK(1.0 / mobility(axis, axis) < 0.21);
    }
  }
}

TEST_CASE("springs carry 80 % of 143 mN m: what is left is what kinematics are told") {
  Plant plant;
  CHECK(find_arm(plant).upper_weight == doctest::Approx(0.2 * 0.1434).epsilon(1e-3));

  plant.masses.balance = 0.0;
  CHECK(find_arm(plant).upper_weight == doctest::Approx(0.1434).epsilon(1e-3));  // [N m]
  CHECK(find_arm(plant).forearm_weight == doctest::Approx(0.0883).epsilon(1e-3));
}

TEST_CASE("an arm thrown without friction keeps its energy, swinging through its dynamics") {
  Plant plant = frictionless();
  plant.masses.balance = 0.0;
  PlantState state(plant);
  state.rates = {2.0, 1.0, -1.0};
  const double before = compute_energy(plant, state);
  double worst = 0.0;

  for (int k = 0; k < 120; ++k) {  // until it meets a stop
    move_plant(plant, {}, {}, 1e-3, state);
    worst = std::max(worst, std::abs(compute_energy(plant, state) - before));
  }

  CHECK((state.joints - PlantState(plant).joints).norm() > 0.1);
  CHECK(worst < 1e-3 * std::abs(before) + 2e-5);
}

TEST_CASE("halving the step halves what the dynamics get wrong") {
  const auto error = [](double step) {
    Plant plant = frictionless(), fine = frictionless();
    plant.step = step;
    fine.step = 1e-6;
    PlantState state(plant), exact(fine);
    state.rates = exact.rates = {2.0, 1.0, -1.0};
    move_plant(plant, {}, {}, 0.1, state);
    move_plant(fine, {}, {}, 0.1, exact);
    return (state.joints - exact.joints).norm();
  };

  const double coarse = error(100e-6), halved = error(50e-6);

  CHECK(halved / coarse == doctest::Approx(0.5).epsilon(0.05));
}

TEST_CASE("dry friction holds the arm exactly until a torque exceeds it") {
  Plant plant;
  plant.masses.balance = 1.0;
  PlantState state(plant);
  const Vec3 rest = state.joints;
  const double below = 0.011 / compute_stall_torque(plant.motor) * 255.0;

  move_plant(plant, {{below, -below, below}, true}, {}, 0.5, state);
  CHECK((state.joints - rest).norm() < 1e-9);

  move_plant(plant, {{3 * below, 0, 0}, true}, {}, 0.1, state);
  CHECK(state.joints[0] - rest[0] > 0.01);
}

TEST_CASE("friction brings a moving arm to rest and takes no more than it can") {
  Plant plant;
  plant.masses.balance = 1.0;
  PlantState state(plant);
  state.rates = {0.5, 0.0, 0.0};
  const double inertia = compute_mass(plant, state.joints, false)(0, 0);

  move_plant(plant, {}, {}, 0.5 * 0.5 * inertia / 0.012, state);  // half of the time to stop
  CHECK(state.rates[0] > 0.2);
  CHECK(state.rates[0] < 0.25);
  move_plant(plant, {}, {}, 1.0, state);
  CHECK(state.rates.norm() < 1e-12);
}

TEST_CASE("a motor gives its stall torque at rest and none at the speed where its voltage is all") {
  const Plant plant;
  const double stall = compute_stall_torque(plant.motor);
  CHECK(stall == doctest::Approx(10 * 0.95 * 0.0165 * 3.0));  // 0.47 N m
  CHECK(compute_motor_damping(plant.motor) == doctest::Approx(6.47e-3).epsilon(1e-3));

  CHECK(compute_motor_torque(plant, {{255, -128, 0}, true}, Vec3::Zero()).x() ==
        doctest::Approx(stall));
  CHECK(compute_motor_torque(plant, {{255, -128, 0}, true}, Vec3::Zero()).y() ==
        doctest::Approx(-stall * 128 / 255));
  const double fastest = plant.motor.supply / (plant.motor.gear * plant.motor.torque_constant);
  CHECK(std::abs(compute_motor_torque(plant, {{255, 0, 0}, true}, {fastest, 0, 0}).x()) < 1e-12);
  CHECK(compute_motor_torque(plant, {{255, 255, 255}, false}, {1, 1, 1}) == Vec3::Zero());
}

TEST_CASE("a hand brings the stylus to where it wants to be, against the weight that is left") {
  Plant plant = frictionless();
  PlantState state(plant);
  const Vec3 wanted = Workspace{}.center + Vec3(0.03, -0.02, 0.01);

  move_plant(plant, {Vec3::Zero(), true}, {wanted, Vec3::Zero(), true}, 3.0, state);

  const Arm arm = find_arm(plant);
  const Vec3 weight = compute_tip_force(arm, state.joints, Vec3::Zero());
  CHECK((state.hand_force + weight).norm() < 1e-6);
  CHECK((find_tip(plant, state) - (wanted - state.hand_force / 400.0)).norm() < 1e-6);
}

TEST_CASE("sensors give whole counts, and noise the same again from the same seed") {
  Plant plant;
  PlantState state(plant);
  state.joints = {0.0, 0.6545, 0.30545};  // the middle of each range
  CHECK(read_sensors(plant, state) == std::array<std::uint16_t, 6>{512, 512, 512, 512, 512, 512});

  state.joints[0] += 10.4 * plant.count;
  state.joints[1] -= 10.6 * plant.count;
  CHECK(read_sensors(plant, state)[0] == 522);
  CHECK(read_sensors(plant, state)[1] == 501);
  state.joints[2] = 10.0;
  CHECK(read_sensors(plant, state)[2] == 1023);

  plant.noise = 0.7;
  PlantState a(plant), b(plant);
  double square = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const auto counts = read_sensors(plant, a);
    CHECK(counts == read_sensors(plant, b));
    square += std::pow(counts[4] - 512.0, 2) / 2000.0;
  }
  CHECK(std::sqrt(square) == doctest::Approx(std::sqrt(0.49 + 1.0 / 12.0)).epsilon(0.05));
}

TEST_CASE("the stops hold against all a motor has") {
  const Plant plant;
  PlantState state(plant);

  move_plant(plant, {{255, 0, 0}, true}, {}, 2.0, state);

  CHECK(state.joints[0] < plant.joint_max[0] + 0.02);
  CHECK(state.rates.norm() < 0.02);
}

TEST_CASE("a plant that cannot be is refused") {
  const auto refused = [](auto change) {
    Plant plant;
    change(plant);
    CHECK_THROWS_AS(validate(plant), std::invalid_argument);
  };

  CHECK_NOTHROW(validate(Plant{}));
  refused([](Plant& p) { p.upper_length = 0.0; });
  refused([](Plant& p) { p.masses.gimbal = -1.0; });
  refused([](Plant& p) { p.masses.balance = 1.5; });
  refused([](Plant& p) { p.motor.resistance = 0.0; });
  refused([](Plant& p) { p.motor.efficiency = 1.1; });
  refused([](Plant& p) { p.dry_friction[1] = -0.1; });
  refused([](Plant& p) { p.hand.mass = std::nan(""); });
  refused([](Plant& p) { p.count = 0.0; });
  refused([](Plant& p) { p.step = 0.0; });
}
