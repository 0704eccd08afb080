// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/arm/plant.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/random.h"
#include "palpate/sim/base/private/refuse.h"

namespace palpate {
namespace {

constexpr double kGravity = 9.80665;   // [m/s²]
constexpr double kStop = 40.0;         // [N·m/rad] of the stops at the ends of a joint
constexpr double kStopDamping = 0.15;  // [N·m·s/rad]
constexpr int kFrictionSweeps = 8;

void require(bool good, const char* field, double value, const char* expected) {
  if (!good || !std::isfinite(value)) {
    refuse(std::string("plant: ") + field, write_text(value), expected);
  }
}

/// First moments about the two link axes [kg·m], and second moments [kg·m²]: rods and the gimbal.
struct Moments {
  double upper, forearm;
  double upper_square, forearm_square, coupling, at_elbow;
};

Moments find_moments(const Plant& plant, double at_tip) noexcept {
  const ArmMasses& m = plant.masses;
  const double upper = plant.upper_length, forearm = plant.forearm_length;
  const double tip = m.gimbal + at_tip, at_elbow = m.forearm + tip;
  const double forearm_first = forearm * (0.5 * m.forearm + tip);
  return {.upper = upper * (0.5 * m.upper + at_elbow),
          .forearm = forearm_first,
          .upper_square = upper * upper * (m.upper / 3.0 + at_elbow),
          .forearm_square = forearm * forearm * (m.forearm / 3.0 + tip),
          .coupling = upper * forearm_first,
          .at_elbow = at_elbow};
}

/// How the mass matrix changes with elevation and forearm, as far as it is not symmetric zeros.
struct MassSlopes {
  Mat3 by_elevation, by_forearm;
};

MassSlopes find_mass_slopes(const Moments& a, const Vec3& q) noexcept {
  const double s1 = std::sin(q[1]), c1 = std::cos(q[1]), s2 = std::sin(q[2]), c2 = std::cos(q[2]);
  MassSlopes slopes{Mat3::Zero(), Mat3::Zero()};
  slopes.by_elevation(0, 0) = -2.0 * a.upper_square * c1 * s1 - 2.0 * a.coupling * s1 * s2;
  slopes.by_forearm(0, 0) = 2.0 * a.forearm_square * s2 * c2 + 2.0 * a.coupling * c1 * c2;
  const double turn = a.coupling * std::cos(q[2] - q[1]);
  slopes.by_elevation(1, 2) = slopes.by_elevation(2, 1) = -turn;
  slopes.by_forearm(1, 2) = slopes.by_forearm(2, 1) = turn;
  return slopes;
}

Mat3 find_mass(const Plant& plant, const Moments& a, const Vec3& q) noexcept {
  const double c1 = std::cos(q[1]), s2 = std::sin(q[2]);
  Mat3 mass = plant.masses.motor * Mat3::Identity();
  mass(0, 0) += a.upper_square * c1 * c1 + 2.0 * a.coupling * c1 * s2 + a.forearm_square * s2 * s2;
  mass(1, 1) += a.upper_square;
  mass(2, 2) += a.forearm_square;
  mass(1, 2) = mass(2, 1) = a.coupling * std::sin(q[2] - q[1]);
  return mass;
}

/// What turning joints push each other with: c = dM/dt v - 1/2 d(v.Mv)/dq, Lagrange's equations.
Vec3 find_turning(const Moments& a, const Vec3& q, const Vec3& v) noexcept {
  const auto [by_elevation, by_forearm] = find_mass_slopes(a, q);
  const Vec3 change = (by_elevation * v[1] + by_forearm * v[2]) * v;
  return change - 0.5 * Vec3(0.0, v.dot(by_elevation * v), v.dot(by_forearm * v));
}

Vec3 find_stops(const Plant& plant, const Vec3& q, const Vec3& v) noexcept {
  Vec3 torque = Vec3::Zero();
  for (int j = 0; j < 3; ++j) {
    const double over = std::max(0.0, q[j] - plant.joint_max[j]);
    const double under = std::max(0.0, plant.joint_min[j] - q[j]);
    if (over > 0.0) torque[j] = std::min(0.0, -kStop * over - kStopDamping * v[j]);
    if (under > 0.0) torque[j] = std::max(0.0, kStop * under - kStopDamping * v[j]);
  }
  return torque;
}

/// Dry friction as impulses p that stop the joints and are no larger than it can hold,
/// |p_j| <= t_j dt: Gauss-Seidel, projected after each joint. A joint that is held stays put.
void hold_by_friction(const Vec3& most, const Mat3& mobility, Vec3& v) noexcept {
  Vec3 impulse = Vec3::Zero();
  for (int sweep = 0; sweep < kFrictionSweeps; ++sweep) {
    for (int j = 0; j < 3; ++j) {
      const double wanted = std::clamp(impulse[j] - v[j] / mobility(j, j), -most[j], most[j]);
      v += mobility.col(j) * (wanted - impulse[j]);
      impulse[j] = wanted;
    }
  }
}

/// One step dt [s], the velocity first and the joints by the new one (symplectic Euler).
void step_plant(const Plant& plant, const Drive& drive, const HandTarget& hand, double dt,
                PlantState& state) noexcept {
  const Arm arm = find_arm(plant);
  const Moments moments = find_moments(plant, hand.holding ? plant.hand.mass : 0.0);
  const Mat3 mobility = find_mass(plant, moments, state.joints).inverse();
  const Mat3 jacobian = compute_jacobian(arm, state.joints);

  state.hand_force.setZero();
  if (hand.holding) {
    state.hand_force = plant.hand.stiffness * (hand.position - compute_tip(arm, state.joints)) +
                       plant.hand.damping * (hand.velocity - jacobian * state.rates);
  }
  const Vec3 torque =
      compute_motor_torque(plant, drive, state.rates) +
      find_stops(plant, state.joints, state.rates) + jacobian.transpose() * state.hand_force -
      plant.viscous_friction.cwiseProduct(state.rates) - compute_weight_torque(arm, state.joints) -
      find_turning(moments, state.joints, state.rates);
  state.rates += dt * (mobility * torque);
  hold_by_friction(dt * plant.dry_friction, mobility, state.rates);
  state.joints += dt * state.rates;
  state.time += dt;
}

}  // namespace

void validate(const Plant& plant) {
  const ArmMasses& masses = plant.masses;
  require(plant.upper_length > 0.0, "upper_length [m]", plant.upper_length, "more than 0");
  require(plant.forearm_length > 0.0, "forearm_length [m]", plant.forearm_length, "more than 0");
  require(masses.upper > 0.0, "masses.upper [kg]", masses.upper, "more than 0");
  require(masses.forearm > 0.0, "masses.forearm [kg]", masses.forearm, "more than 0");
  require(masses.gimbal > 0.0, "masses.gimbal [kg]", masses.gimbal, "more than 0");
  require(masses.motor > 0.0, "masses.motor [kg m^2]", masses.motor, "more than 0");
  require(masses.balance >= 0.0 && masses.balance <= 1.0, "masses.balance", masses.balance,
          "0 to 1");
  const Motor& motor = plant.motor;
  require(motor.supply > 0.0, "motor.supply [V]", motor.supply, "more than 0");
  require(motor.resistance > 0.0, "motor.resistance [Ohm]", motor.resistance, "more than 0");
  require(motor.torque_constant > 0.0, "motor.torque_constant [N m/A]", motor.torque_constant,
          "more than 0");
  require(motor.gear > 0.0, "motor.gear", motor.gear, "more than 0");
  require(motor.efficiency > 0.0 && motor.efficiency <= 1.0, "motor.efficiency", motor.efficiency,
          "more than 0, at most 1");
  for (int j = 0; j < 3; ++j) {
    require(plant.joint_min[j] < plant.joint_max[j], "joint_min [rad]", plant.joint_min[j],
            "less than joint_max");
    require(plant.dry_friction[j] >= 0.0, "dry_friction [N m]", plant.dry_friction[j], "0 or more");
    require(plant.viscous_friction[j] >= 0.0, "viscous_friction [N m s/rad]",
            plant.viscous_friction[j], "0 or more");
  }
  const Hand& hand = plant.hand;
  require(hand.mass >= 0.0, "hand.mass [kg]", hand.mass, "0 or more");
  require(hand.stiffness >= 0.0, "hand.stiffness [N/m]", hand.stiffness, "0 or more");
  require(hand.damping >= 0.0, "hand.damping [N s/m]", hand.damping, "0 or more");
  require(plant.count > 0.0, "count [rad]", plant.count, "more than 0");
  require(plant.gimbal_count > 0.0, "gimbal_count [rad]", plant.gimbal_count, "more than 0");
  require(plant.noise >= 0.0, "noise [counts]", plant.noise, "0 or more");
  require(plant.step > 0.0 && plant.step <= 1e-3, "step [s]", plant.step,
          "more than 0, at most 0.001");
}

PlantState::PlantState(const Plant& plant) : random(plant.seed) {
  const Arm arm = find_arm(plant);
  joints = find_joints(arm, Workspace{}.center).value_or(0.5 * (arm.joint_min + arm.joint_max));
}

Arm find_arm(const Plant& plant) noexcept {
  const Moments moments = find_moments(plant, 0.0);
  const double left = kGravity * (1.0 - plant.masses.balance);
  Arm arm;
  arm.upper_length = plant.upper_length;
  arm.forearm_length = plant.forearm_length;
  arm.upper_weight = left * moments.upper;
  arm.forearm_weight = left * moments.forearm;
  arm.joint_min = plant.joint_min;
  arm.joint_max = plant.joint_max;
  return arm;
}

/// With rods as they turn and the gimbal (and hand) as a point: S_1, S_2 their second moments about
/// shoulder and elbow, C = L1 times the first moment of what hangs on the elbow,
///
///     M_00 = S_1 cos^2 q1 + 2 C cos q1 sin q2 + S_2 sin^2 q2,
///     M_11 = S_1,   M_22 = S_2,   M_12 = C sin(q2 - q1),   and each motor's own inertia.
Mat3 compute_mass(const Plant& plant, const Vec3& joints, bool holding) noexcept {
  return find_mass(plant, find_moments(plant, holding ? plant.hand.mass : 0.0), joints);
}

double compute_energy(const Plant& plant, const PlantState& state) noexcept {
  const Arm arm = find_arm(plant);
  const double kinetic =
      0.5 * state.rates.dot(compute_mass(plant, state.joints, false) * state.rates);
  return kinetic + arm.upper_weight * std::sin(state.joints[1]) -
         arm.forearm_weight * std::cos(state.joints[2]);
}

double compute_stall_torque(const Motor& motor) noexcept {
  return motor.gear * motor.efficiency * motor.torque_constant * motor.supply / motor.resistance;
}

double compute_motor_damping(const Motor& motor) noexcept {
  return motor.efficiency * std::pow(motor.gear * motor.torque_constant, 2) / motor.resistance;
}

/// tau = e N k (u U - k N v) / R: the current is what is left of the voltage by the motor's own.
Vec3 compute_motor_torque(const Plant& plant, const Drive& drive, const Vec3& rates) noexcept {
  if (!drive.enabled) return Vec3::Zero();
  return compute_stall_torque(plant.motor) / 255.0 * drive.duty -
         compute_motor_damping(plant.motor) * rates;
}

void move_plant(const Plant& plant, const Drive& drive, const HandTarget& hand, double dt,
                PlantState& state) noexcept {
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / plant.step - 1e-9)));
  HandTarget now = hand;
  for (int s = 0; s < steps; ++s) {
    step_plant(plant, drive, now, dt / steps, state);
    now.position += now.velocity * (dt / steps);
  }
}

std::array<std::uint16_t, 6> read_sensors(const Plant& plant, PlantState& state) noexcept {
  std::array<std::uint16_t, 6> counts{};
  for (int j = 0; j < 6; ++j) {
    const double middle = j < 3 ? 0.5 * (plant.joint_min[j] + plant.joint_max[j]) : 0.0;
    const double angle = j < 3 ? state.joints[j] : state.gimbal[j - 3];
    double reading = (angle - middle) / (j < 3 ? plant.count : plant.gimbal_count);
    if (plant.noise > 0.0) reading += plant.noise * draw_normal(state.random);
    const double count = std::clamp(std::round(reading) + kSensorMiddle, 0.0, double(kSensorEnd));
    counts[static_cast<std::size_t>(j)] = static_cast<std::uint16_t>(count);
  }
  return counts;
}

Vec3 find_tip(const Plant& plant, const PlantState& state) noexcept {
  return compute_tip(find_arm(plant), state.joints);
}

}  // namespace palpate
