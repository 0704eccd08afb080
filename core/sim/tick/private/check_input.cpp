// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/check_input.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

Alarm find_invalid(TickInput input, double value, double limit) noexcept {
  return {AlarmKind::invalid_input, static_cast<int>(input), value, limit};
}

bool is_positive(double value) noexcept { return value > 0.0 && std::isfinite(value); }

/// The coordinate that is no finite number, or else the largest.
template <class Vector>
double find_worst(const Vector& vector) noexcept {
  double worst = 0.0;
  for (Eigen::Index i = 0; i < vector.size(); ++i) {
    if (!std::isfinite(vector[i])) return std::abs(vector[i]);
    worst = std::max(worst, std::abs(vector[i]));
  }
  return worst;
}

Alarm check_sample(const HapticSample& sample) noexcept {
  const double position = find_worst(sample.position);
  const double orientation = find_worst(sample.orientation.coeffs());
  const double velocity = find_worst(sample.velocity);
  if (!std::isfinite(sample.time)) return find_invalid(TickInput::time, sample.time, kLargest);
  if (!(position <= kFarthestHand)) {
    return find_invalid(TickInput::position, position, kFarthestHand);
  }
  if (!std::isfinite(orientation)) {
    return find_invalid(TickInput::orientation, orientation, kLargest);
  }
  if (!std::isfinite(velocity)) return find_invalid(TickInput::velocity, velocity, kLargest);
  if (!std::isfinite(sample.grip)) return find_invalid(TickInput::grip, sample.grip, kLargest);
  return {};
}

/// The world was made for this scene: its arrays have the lengths that kernels index by.
bool belong_together(const SoftBody& body, const SoftState& state) noexcept {
  const TissueModel& tissue = body.tissue;
  return tissue.rest_position.size() == state.tissue.position.size() &&
         tissue.skin.corners.size() == state.skin.size() &&
         tissue.triangles.size() == state.tree.triangles().size() &&
         body.rest_areas.size() == tissue.triangles.size();
}

bool belong_together(const Scene& scene, const World& world) noexcept {
  return scene.identity == world.scene_identity && scene.bodies.size() == world.bodies.size() &&
         scene.instruments.size() == world.instruments.size() &&
         std::ranges::equal(scene.bodies, world.bodies,
                            [](const SoftBody& body, const SoftState& state) noexcept {
                              return belong_together(body, state);
                            });
}

Alarm check_instrument(const Instrument& instrument) noexcept {
  for (const auto& [input, value] : {
           std::pair(TickInput::tool_radius, instrument.tool.radius),
           std::pair(TickInput::tool_stiffness, instrument.tool.stiffness),
           std::pair(TickInput::coupling_stiffness, instrument.coupling.stiffness),
           std::pair(TickInput::coupling_force_max, instrument.coupling.force_max),
           std::pair(TickInput::hold_stiffness, instrument.hold_stiffness),
       }) {
    if (!is_positive(value)) return find_invalid(input, value, 0.0);
  }
  const double friction = instrument.tool.friction;
  if (!(friction >= 0.0) || !std::isfinite(friction)) {
    return find_invalid(TickInput::tool_friction, friction, 0.0);
  }
  for (const double mu : instrument.pair_friction) {
    if (!(mu >= 0.0) || !std::isfinite(mu)) return find_invalid(TickInput::tool_friction, mu, 0.0);
  }
  return {};
}

Alarm check_body(const SoftBody& body) noexcept {
  if (body.substeps < 1) return find_invalid(TickInput::substeps, body.substeps, 1.0);
  if (body.substeps_max < body.substeps) {
    return find_invalid(TickInput::substeps_max, body.substeps_max, body.substeps);
  }
  return {};
}

Alarm check_scene(const Scene& scene, const World& world) noexcept {
  if (!belong_together(scene, world)) {
    return find_invalid(TickInput::scene, double(scene.identity), double(world.scene_identity));
  }
  for (const Instrument& instrument : scene.instruments) {
    if (const Alarm alarm = check_instrument(instrument)) return alarm;
  }
  const double gravity = find_worst(scene.gravity);
  if (!std::isfinite(gravity)) return find_invalid(TickInput::gravity, gravity, kLargest);
  for (const SoftBody& body : scene.bodies) {
    if (const Alarm alarm = check_body(body)) return alarm;
  }
  return {};
}

}  // namespace

Alarm check_input(const Scene& scene, std::span<const HapticSample> samples,
                  std::size_t command_count, double dt, const World& world) noexcept {
  Alarm alarm = check_scene(scene, world);
  if (!alarm && !is_positive(dt)) alarm = find_invalid(TickInput::dt, dt, 0.0);
  for (const std::size_t count : {samples.size(), command_count}) {
    if (alarm || count == world.instruments.size()) continue;
    alarm = find_invalid(TickInput::samples, double(count), double(world.instruments.size()));
  }
  for (std::size_t i = 0; i < samples.size() && !alarm; ++i) alarm = check_sample(samples[i]);
  if (alarm) alarm.time = world.bodies.front().tissue.time;
  return alarm;
}

}  // namespace palpate
