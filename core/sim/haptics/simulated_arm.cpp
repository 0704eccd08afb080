// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/haptics/simulated_arm.h"

namespace palpate {

SimulatedArm::SimulatedArm(HapticDevice& hand, const Vec3& origin, const Plant& plant,
                           const NativeCoreOptions& options)
    : hand_(hand), origin_(origin), core_(plant, options), driver_(core_, origin) {}

/// A hand that wants to be outside stays at the edge: it would only bend the arm's stops.
Vec3 SimulatedArm::to_arm(const Vec3& position) const noexcept {
  const Workspace box;
  const Vec3 half = 0.5 * box.size;
  return box.center + (position - origin_).cwiseMax(-half).cwiseMin(half);
}

void SimulatedArm::open() {
  const Vec3 begin = to_arm(hand_.read(0.0).position);
  if (const auto joints = find_joints(find_arm(core_.plant()), begin)) {
    core_.state().joints = *joints;
    core_.state().rates.setZero();
  }
  core_.hold({begin, Vec3::Zero(), true});
  driver_.open();
}

HapticSample SimulatedArm::read(double time) noexcept {
  const HapticSample wanted = hand_.read(time);
  const Vec3 place = to_arm(wanted.position);
  const bool inside = place.isApprox(wanted.position - origin_ + Workspace{}.center, 1e-12);
  core_.hold({place, inside ? wanted.velocity : Vec3::Zero(), true});
  core_.press_buttons(wanted.buttons);
  HapticSample sample = driver_.read(time);
  // turned by the hand as it likes: the mouse has no gimbal
  sample.orientation = wanted.orientation;
  return sample;
}

void SimulatedArm::write(const HapticCommand& command) noexcept {
  driver_.write(command);
  hand_.write(command);
}

}  // namespace palpate
