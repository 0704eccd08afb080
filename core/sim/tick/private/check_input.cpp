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
bool belong_together(const Scene& scene, const World& world) noexcept {
  const TissueModel& tissue = scene.tissue;
  return scene.identity == world.scene_identity &&
         tissue.rest_position.size() == world.tissue.position.size() &&
         tissue.skin.corners.size() == world.skin.size() &&
         tissue.triangles.size() == world.tree.triangles().size() &&
         scene.rest_areas.size() == tissue.triangles.size();
}

Alarm check_scene(const Scene& scene, const World& world) noexcept {
  if (!belong_together(scene, world)) {
    return find_invalid(TickInput::scene, double(scene.identity), double(world.scene_identity));
  }
  for (const auto& [input, value] : {
           std::pair(TickInput::tool_radius, scene.tool.radius),
           std::pair(TickInput::tool_stiffness, scene.tool.stiffness),
           std::pair(TickInput::coupling_stiffness, scene.coupling.stiffness),
           std::pair(TickInput::coupling_force_max, scene.coupling.force_max),
           std::pair(TickInput::hold_stiffness, scene.hold_stiffness),
       }) {
    if (!is_positive(value)) return find_invalid(input, value, 0.0);
  }
  const double gravity = find_worst(scene.gravity);
  if (!std::isfinite(gravity)) return find_invalid(TickInput::gravity, gravity, kLargest);
  if (scene.substeps < 1) return find_invalid(TickInput::substeps, scene.substeps, 1.0);
  if (scene.substeps_max < scene.substeps) {
    return find_invalid(TickInput::substeps_max, scene.substeps_max, scene.substeps);
  }
  return {};
}

}  // namespace

Alarm check_input(const Scene& scene, const HapticSample& sample, double dt,
                  const World& world) noexcept {
  Alarm alarm = check_scene(scene, world);
  if (!alarm && !is_positive(dt)) alarm = find_invalid(TickInput::dt, dt, 0.0);
  if (!alarm) alarm = check_sample(sample);
  if (alarm) alarm.time = world.tissue.time;
  return alarm;
}

}  // namespace palpate
