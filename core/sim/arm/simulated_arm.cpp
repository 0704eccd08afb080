// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/arm/simulated_arm.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/sim/arm/private/gimbal.h"

namespace palpate {
namespace {

/// [m/s] A hand that says it is elsewhere, as a pointer does when it first shows up, goes there at
/// this speed: its spring would fling the arm otherwise.
constexpr double kFastestHand = 1.0;
constexpr double kFastestTurn = 10.0;  // [rad/s] likewise, of the stylus in it
constexpr double kLongestTick = 2e-3;  // [s] that it may make up at once

}  // namespace

SimulatedArm::SimulatedArm(HapticDevice& hand, const Vec3& origin, const Plant& plant,
                           const NativeCoreOptions& options)
    : hand_(hand), origin_(origin), core_(plant, options), driver_(core_, origin) {}

void SimulatedArm::cut_sensor(int joint, bool cut) noexcept {
  if (joint < 0 || joint >= 6) return;
  cut_[static_cast<std::size_t>(joint)].store(cut, std::memory_order_relaxed);
}

Vec3 SimulatedArm::hand_force() const noexcept {
  Vec3 force;
  for (int i = 0; i < 3; ++i) {
    force[i] = hand_force_[static_cast<std::size_t>(i)].load(std::memory_order_relaxed);
  }
  return force;
}

void SimulatedArm::follow_orders() noexcept {
  core_.press_stop(stopped_.load(std::memory_order_relaxed));
  for (int j = 0; j < 6; ++j) {
    core_.cut_sensor(j, cut_[static_cast<std::size_t>(j)].load(std::memory_order_relaxed));
  }
  if (unplugged_.load(std::memory_order_relaxed) && core_.is_open()) core_.pull_cable();
}

/// A hand that wants to be outside stays at the edge: it would only bend the arm's stops.
Vec3 SimulatedArm::to_arm(const Vec3& position) const noexcept {
  const Workspace box;
  if (wide_.load(std::memory_order_relaxed)) return box.center + (position - origin_);
  const Vec3 half = 0.5 * box.size;
  return box.center + (position - origin_).cwiseMax(-half).cwiseMin(half);
}

/// Turns the hand towards what is wanted by `most` [rad]. What is no orientation turns nothing.
void SimulatedArm::turn_hand(const Quaternion& wanted, double most) noexcept {
  const double norm = wanted.norm();
  if (!(norm > 0.0 && std::isfinite(norm))) return;
  const Quaternion goal(Eigen::Vector4d(wanted.coeffs() / norm));
  const Quaternion before = turn_;
  const double angle = before.angularDistance(goal);
  turn_ = goal;
  if (angle > most) turn_ = before.slerp(most / angle, goal).normalized();
}

/// The gimbal has neither mass nor friction: it is where the hand turns it.
void SimulatedArm::turn_gimbal() noexcept {
  const double most = kGimbalReach * core_.plant().gimbal_count;
  core_.state().gimbal = compute_gimbal(core_.state().joints, turn_, most);
}

void SimulatedArm::open() {
  const HapticSample wanted = hand_.read(0.0);
  place_ = to_arm(wanted.position);
  if (const auto joints = find_joints(find_arm(core_.plant()), place_)) {
    core_.state().joints = *joints;
    core_.state().rates.setZero();
  }
  turn_hand(wanted.orientation, std::numbers::pi);
  turn_gimbal();
  core_.hold({place_, Vec3::Zero(), true});
  driver_.open();
  time_ = 0.0;
}

HapticSample SimulatedArm::read(double time) noexcept {
  follow_orders();
  const HapticSample wanted = hand_.read(time);
  const double dt = std::clamp(time - time_, 0.0, kLongestTick);
  time_ = time;
  const Vec3 displacement = to_arm(wanted.position) - place_;
  const double most = kFastestHand * dt;
  const Vec3 step =
      displacement.norm() > most ? Vec3(displacement * (most / displacement.norm())) : displacement;
  // it has come to place_ by this tick, and goes on as it came until the next
  place_ += step;
  core_.hold({place_, dt > 0.0 ? Vec3(step / dt) : Vec3(Vec3::Zero()), true});
  turn_hand(wanted.orientation, kFastestTurn * dt);
  turn_gimbal();
  core_.press_buttons(wanted.buttons);
  const HapticSample sample = driver_.read(time);
  tell_hand_force();
  return sample;
}

/// The hand stays where it is, and so does what moves it.
void SimulatedArm::rest(double seconds) noexcept {
  follow_orders();
  core_.hold({place_, Vec3::Zero(), true});
  turn_gimbal();
  driver_.rest(seconds);
  tell_hand_force();
  hand_.write({});
}

void SimulatedArm::tell_hand_force() noexcept {
  for (int i = 0; i < 3; ++i) {
    hand_force_[static_cast<std::size_t>(i)].store(core_.state().hand_force[i],
                                                   std::memory_order_relaxed);
  }
}

void SimulatedArm::write(const HapticCommand& command) noexcept {
  driver_.write(command);
  hand_.write(command);
}

}  // namespace palpate
