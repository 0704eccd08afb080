// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/tick/private/world_internals.h"
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

/// Capsules have room where both ends have, and no surface lies between them.
bool has_room(const AabbTree& tree, std::span<const Vec3> x, const Vec3& hand_position,
              const Tool& tool, const Quaternion& orientation, double jaw_angle) noexcept {
  if (tool.capsules.empty()) return has_room(tree, x, hand_position, tool.radius);
  const Axes axes(tool, orientation, jaw_angle);
  return std::ranges::all_of(axes.list(), [&](const Capsule& axis) noexcept {
    const Vec3 from = hand_position + axis.from, to = hand_position + axis.to;
    return !find_segment_hit(tree, x, from, to) && has_room(tree, x, from, tool.radius) &&
           has_room(tree, x, to, tool.radius);
  });
}

bool place_tool(const AabbTree& tree, std::span<const Vec3> x, const Vec3& hand_position,
                double radius, ToolState& tool) noexcept {
  if (tool.placed) return true;
  tool.position = hand_position;
  tool.placed = has_room(tree, x, hand_position, radius);
  return tool.placed;
}

namespace {

/// [rad/s] A tool that is turned against tissue with more than that torque [N m] does not turn
/// faster: the hand feels no torque, and would lever an organ for nothing.
constexpr double kFastestTurn = 3.0, kFreeTorque = 0.02;

/// Part of the radius by which the far end of a tool may be turned in a tick: it stays before the
/// surface.
constexpr double kTurnInRadii = 0.25;

/// [m] A tip that has come out this near to its trocar is turned no further: close to it the shaft
/// would swing round with every tremor.
constexpr double kLeastInserted = 0.005;

/// The part of a turn that is about z.
Quaternion take_roll(const Quaternion& turn) noexcept {
  const double length = std::hypot(turn.w(), turn.z());
  if (!(length > 0.0)) return Quaternion::Identity();
  return Quaternion(turn.w() / length, 0.0, 0.0, turn.z() / length);
}

/// z along the shaft, from the tip to the trocar, and the hand's roll about it [contact: trocar].
Quaternion point_through(const Vec3& trocar, const Quaternion& hand,
                         const ToolState& state) noexcept {
  const Vec3 shaft = trocar - state.position;
  if (!(shaft.norm() > kLeastInserted)) return state.orientation;
  const Quaternion swing(Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), shaft));
  return swing * take_roll(hand);
}

/// A turn by `wanted` [rad] about the axis on which tissue turns the tool with `torque` [N m], in a
/// tick in which none is more than `most`: against it the slower the nearer that is to `borne`, and
/// with it beyond [stability: what tissue bears].
double yield_to(double torque, double borne, double most, double wanted) noexcept {
  return std::max(wanted, std::clamp(most * (torque / borne - 1.0), -most, most));
}

/// [m] No farther from the position is a point of a capsule, however far jaws are open.
double bound_reach(const Tool& tool, const Vec3& point) noexcept {
  if (!tool.jaws) return point.norm();
  return tool.jaws->hinge.norm() + (point - tool.jaws->hinge).norm();
}

}  // namespace

void turn_tool(const Instrument& instrument, const Quaternion& hand, double dt, double bearable,
               ToolState& state) noexcept {
  const Tool& tool = instrument.tool;
  state.turn_limited = false;
  if (tool.capsules.empty()) return;
  const double norm = hand.norm();
  if (!(norm > 0.0)) return;
  Quaternion wanted(Eigen::Vector4d(hand.coeffs() / norm));
  if (instrument.trocar) wanted = point_through(*instrument.trocar, wanted, state);
  if (!state.placed) {
    state.orientation = wanted;
    return;
  }
  double reach = tool.radius;
  for (const Capsule& capsule : tool.capsules) {
    reach = std::max({reach, bound_reach(tool, capsule.from), bound_reach(tool, capsule.to)});
  }
  double most = kTurnInRadii * tool.radius / reach;
  const bool resisted = state.torque.norm() > kFreeTorque && kFastestTurn * dt < most;
  if (resisted) most = kFastestTurn * dt;
  const Quaternion before = state.orientation;
  const double angle = before.angularDistance(wanted);
  state.orientation = wanted;
  state.turn_limited = resisted && angle > most;
  if (angle > most) state.orientation = before.slerp(most / angle, wanted).normalized();
  if (!std::isfinite(bearable)) return;
  // about its shaft where that is led through a trocar, else about any axis
  const Vec3 shaft = state.orientation * Vec3::UnitZ();
  const Vec3 torque = instrument.trocar ? Vec3(state.torque.dot(shaft) * shaft) : state.torque;
  const double size = torque.norm();
  if (!(size > 0.0)) return;
  const Vec3 axis = torque / size;
  const Eigen::AngleAxisd turned(state.orientation * before.conjugate());
  const double about = turned.angle() * turned.axis().dot(axis);
  const double may = yield_to(size, bearable * reach, kFastestTurn * dt, about);
  if (may == about) return;
  state.turn_limited = true;
  state.orientation =
      (Quaternion(Eigen::AngleAxisd(may - about, axis)) * state.orientation).normalized();
}

}  // namespace palpate
