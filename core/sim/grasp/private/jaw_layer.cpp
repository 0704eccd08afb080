// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "palpate/sim/grasp/private/jaws.h"

namespace palpate {
namespace {

/// Where along a jaw it is touched, from its first end [m]: a line evenly pressed goes sqrt(3)
/// standard deviations to either side of its middle, and as far as the capsule's radius beyond.
struct Touched {
  double low = 0.0, high = 0.0;
};

Touched find_touched(const Tool& tool, double length, const Pressed& pressed,
                     double extent = 0.0) noexcept {
  if (!(pressed.force > 0.0)) return {};
  const double middle = pressed.at / pressed.force;
  const double variance =
      std::max(0.0, (pressed.spread + extent) / pressed.force - middle * middle);
  const double half = std::sqrt(3.0 * variance) + tool.radius;
  return {std::clamp(middle - half, 0.0, length), std::clamp(middle + half, 0.0, length)};
}

double measure_length(const Tool& tool) noexcept {
  return (tool.capsules[0].to - tool.capsules[0].from).norm();
}

}  // namespace

OpenJaws::OpenJaws(const Tool& tool, const Quaternion& orientation, double angle) noexcept
    : tool_(tool),
      orientation_(orientation),
      shapes_{Shape{tool, {}}, Shape{tool, {}}},
      hinge_(orientation * tool.jaws->hinge),
      axis_(orientation * tool.jaws->axis) {
  open(angle);
}

void OpenJaws::open(double angle) noexcept {
  angle_ = angle;
  for (std::size_t j = 0; j < 2; ++j) {
    turns_[j] = Eigen::AngleAxisd(j == 0 ? angle : -angle, tool_.jaws->axis);
    const Capsule jaw = open_jaw(tool_, j, angle);
    shapes_[j].axes.capsules[0] = {orientation_ * jaw.from, orientation_ * jaw.to};
    shapes_[j].axes.count = 1;
  }
}

Vec3 OpenJaws::to_scene(int jaw, const Vec3& place) const noexcept {
  const Quaternion& turn = turns_[static_cast<std::size_t>(jaw)];
  return hinge_ + orientation_ * (turn * (place - tool_.jaws->hinge));
}

Vec3 OpenJaws::to_jaw(int jaw, const Vec3& at) const noexcept {
  const Quaternion& turn = turns_[static_cast<std::size_t>(jaw)];
  return tool_.jaws->hinge + turn.conjugate() * (orientation_.conjugate() * (at - hinge_));
}

double measure_arm(const Tool& tool) noexcept {
  return (0.5 * (tool.capsules[0].from + tool.capsules[0].to) - tool.jaws->hinge).norm();
}

/// That of a triangle about its middle m is sum over corners of (c - m)²/12.
double find_extent(const Triangle& t, std::span<const Vec3> x, const Vec3& along) noexcept {
  Vec3 at;
  for (int c = 0; c < 3; ++c) {
    at[c] = along.dot(x[static_cast<std::size_t>(t[static_cast<std::size_t>(c)])]);
  }
  return (at.array() - at.mean()).matrix().squaredNorm() / 12.0;
}

double find_covered(const Tool& tool, const Pressed& pressed, double extent) noexcept {
  const double length = measure_length(tool);
  const Touched touched = find_touched(tool, length, pressed, extent);
  return tool.jaws->pad_area * (touched.high - touched.low) / length;
}

double find_grip(double mu, const std::array<Pressed, 2>& pressed, double layer, int jaw,
                 double opens) noexcept {
  const double smooth = std::min(1.0, kSmoothFriction / mu);
  const double own = pressed[static_cast<std::size_t>(jaw)].pad + layer;
  const double other = pressed[static_cast<std::size_t>(1 - jaw)].pad + layer;
  const double between = own > 0.0 ? std::min(1.0, other / own) : 0.0;
  return smooth + (1.0 - smooth) * between * find_pad_part(opens);
}

/// Where both jaws touch, at the distance s from the hinge, they are g = 2 s sin(angle) apart, and
/// what is between them, L thick at rest, is pressed by
///
///     p = P (L/g - 1),   g >= L/10
///
/// the barrier of [contact: law] for walls that meet. It pushes one wall as it does the other,
/// which the jaw pushes back: on the walls nothing of it is left, but on the jaws all, and friction
/// has it.
Squeeze find_squeeze(const Tool& tool, const OpenJaws& jaws,
                     const std::array<Pressed, 2>& pressed) noexcept {
  if (!(pressed[0].force > 0.0 && pressed[1].force > 0.0)) return {};
  const double length = measure_length(tool);
  const Touched a = find_touched(tool, length, pressed[0]);
  const Touched b = find_touched(tool, length, pressed[1]);
  const double low = std::max(a.low, b.low), high = std::min(a.high, b.high);
  if (!(high > low)) return {};
  const double force = pressed[0].force + pressed[1].force;
  const double modulus = (pressed[0].modulus + pressed[1].modulus) / force;
  const double thickness = (pressed[0].thickness + pressed[1].thickness) / force;
  const Vec3 along = tool.capsules[0].to - tool.capsules[0].from;
  const Vec3 middle = tool.capsules[0].from + (0.5 * (low + high) / length) * along;
  const double s = (middle - tool.jaws->hinge).norm();
  const double gap = 2.0 * s * std::sin(jaws.angle()), opens = 2.0 * s * std::cos(jaws.angle());
  if (!(gap < thickness)) return {};
  const double area = tool.jaws->pad_area * (high - low) / length;
  const double pressed_to = std::max(gap, kLayerFloor * thickness);
  Squeeze squeeze;
  squeeze.force = modulus * area * (thickness / pressed_to - 1.0);
  squeeze.torque = squeeze.force * opens;
  squeeze.slope = modulus * area * thickness / (pressed_to * pressed_to) * opens * opens;
  return squeeze;
}

void add_jaw_rows(const Tool& tool, int jaw, const TouchableSurface& surface,
                  const ToolState& state, double coupling, ContactRows& rows) noexcept {
  const OpenJaws jaws(tool, state.orientation, state.jaw_angle);
  add_shape_rows(jaws.shape(jaw), jaw == 0, surface, state, coupling, rows);
}

}  // namespace palpate
