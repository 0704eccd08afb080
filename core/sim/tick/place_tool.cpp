// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "palpate/sim/tick/tick.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {
namespace {

/// Of the radius. A tool may begin by touching, but not so deep that it throws the surface.
constexpr double kClear = 0.4;

}  // namespace

/// The sum of signed solid angles over 4 pi [Jacobson13], each from [VanOosteromStrackee83]:
///
///     tan(omega / 2) = a·(b x c) / (abc + (a·b) c + (b·c) a + (c·a) b)
///
/// with a, b, c the corners seen from p. Unlike a ray it has no direction to choose, no edge to
/// hit by bad luck, and a hole changes it by no more than the hole is wide.
double compute_winding_number(std::span<const Triangle> triangles, std::span<const Vec3> x,
                              const Vec3& p) noexcept {
  double half_angles = 0.0;
  for (const auto& [i, j, k] : triangles) {
    const Vec3 a = x[i] - p, b = x[j] - p, c = x[k] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    half_angles +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return half_angles / (2.0 * std::numbers::pi);
}

bool has_room(const AabbTree& tree, std::span<const Vec3> x, const Vec3& hand_position,
              double radius) noexcept {
  if (find_closest_point(tree, x, hand_position, kClear * radius)) return false;
  const bool in_box = (hand_position.array() >= tree.low().array()).all() &&
                      (hand_position.array() <= tree.high().array()).all();
  return !in_box || compute_winding_number(tree.triangles(), x, hand_position) < 0.5;
}

bool place_tool(const AabbTree& tree, std::span<const Vec3> x, const Vec3& hand_position,
                double radius, ToolState& tool) noexcept {
  if (tool.placed) return true;
  tool.position = hand_position;
  tool.placed = has_room(tree, x, hand_position, radius);
  return tool.placed;
}

}  // namespace palpate
