// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "palpate/sim/base/private/limit.h"
#include "palpate/sim/contact/private/broad_phase.h"
#include "palpate/sim/contact/private/friction.h"
#include "palpate/sim/contact/private/touched_surface.h"
#include "palpate/sim/grasp/private/jaw_touch.h"

namespace palpate {
namespace {

constexpr int kNewtonSteps = 3;
constexpr int kNewtonStepsAtLimit = 6;  // as of a tool without jaws (balance_tool.cpp)
constexpr int kNewtonStepsNear = 4;     // each has a footprint of all that either jaw touches

// [m] and [rad] of a step that is left out: contacts are costly to find, and jaws that hold are
// still
constexpr double kShortestStep = 1e-8, kShortestTurn = 1e-6;

/// [m] No point of a jaw goes farther as it turns by 1 rad.
double find_reach(const Tool& tool) noexcept {
  double reach = 0.0;
  for (const Capsule& jaw : tool.capsules) {
    reach =
        std::max({reach, (jaw.from - tool.jaws->hinge).norm(), (jaw.to - tool.jaws->hinge).norm()});
  }
  return reach;
}

/// The torque that closes both jaws, up to twice the grip at their middles, and how it falls.
struct Drive {
  double torque = 0.0;  // [N m] that opens them
  double slope = 0.0;   // [N m/rad]
};

Drive find_drive(const JawSurroundings& around, double angle) noexcept {
  const double most = 2.0 * around.grip * around.arm, slope = most / kGripRise;
  const double torque = slope * (around.wanted - angle);
  if (std::abs(torque) >= most) return {std::clamp(torque, -most, most), 0.0};
  return {torque, slope};
}

/// A step of tool and jaws.
struct Step {
  Vec3 move = Vec3::Zero();  // [m]
  double turn = 0.0;         // [rad]
};

/// What is known of the step before: Newton's matrix leaves out how directions turn and how
/// contacts fade, which deep in a narrow dent is more than it has, so that its steps go to and fro
/// between two places. Two of them tell how it errs along the way between: of the steps g as a
/// function of the place x,
///
///     dx = g_k - c (dx_before + dg),   c = dg . g_k/|dg|²,   dg = g_k - g_before
///
/// is where the line through both is nearest to 0 (Anderson's acceleration, of depth one).
class Memory {
 public:
  explicit Memory(double reach) noexcept : reach_(reach) {}

  Step improve(const Step& step) noexcept {
    const Step before = std::exchange(step_, step);
    if (!std::exchange(known_, true)) return step;
    const Step change{step.move - before.move, step.turn - before.turn};
    const double size = dot(change, change);
    if (!(size > kLeastChange * dot(step, step))) return step;
    const double part = std::clamp(dot(change, step) / size, -kMostPart, kMostPart);
    return {step.move - part * (taken_.move + change.move),
            step.turn - part * (taken_.turn + change.turn)};
  }

  void take(const Step& step) noexcept { taken_ = step; }

 private:
  static constexpr double kLeastChange = 0.01, kMostPart = 1.0;

  double dot(const Step& a, const Step& b) const noexcept {
    return a.move.dot(b.move) + reach_ * reach_ * a.turn * b.turn;
  }

  double reach_;
  bool known_ = false;
  Step step_, taken_;
};

/// The part of a step that may be taken, as of a tool without jaws: none goes more than half the
/// way to any surface (balance_tool.cpp).
Step shorten(const JawSurroundings& around, const JawPlace& place, const JawTouch& touch,
             Step step) noexcept {
  const double radius = around.tool.radius;
  const double far = step.move.norm() + around.reach * std::abs(step.turn);
  if (far <= 0.5 * (touch.smallest_distance - kClearance * radius)) return step;
  double part = std::min(1.0, 0.5 * radius / far);
  for_each_closest_of_jaws(around, place,
                           [&](int jaw, int body, int t, const Contact& contact) noexcept {
                             const Vec3 at = find_at(around, place, jaw, body, t, contact);
                             const Vec3 moved = step.move + step.turn * place.jaws.move(jaw, at);
                             const double approach = -moved.dot(contact.direction);
                             const double room = 0.5 * (contact.distance - kClearance * radius);
                             if (approach > 0.0)
                               part = std::min(part, std::max(0.0, room) / approach);
                           });
  return {part * step.move, part * step.turn};
}

/// Jaws that may turn no farther leave the tool where it balances with them as they are then: the
/// way that belongs to a turn which they do not make would end anywhere.
Step solve(const Eigen::Matrix4d& jacobian, const Eigen::Vector4d& residual,
           const JawPlace& place) noexcept {
  const Eigen::Vector4d whole = jacobian.ldlt().solve(residual);
  const double angle = place.jaws.angle(), wanted = angle + whole[3];
  const double turn = std::clamp(wanted, place.least, place.most) - angle;
  if (place.least <= wanted && wanted <= place.most) return {whole.head<3>(), turn};
  return {jacobian.topLeftCorner<3, 3>().ldlt().solve(residual.head<3>() -
                                                      turn * jacobian.topRightCorner<3, 1>()),
          turn};
}

/// One Newton step of
///
///     K (h - p) + sum f_t n_t + anchors(p, a) = 0
///     drive(a) + sum f_t n_t.v_t + layer(a) + anchors(p, a) = drag max(0, a - a_start)
///
/// with v = dy/da of a jaw's point, in place and angle together.
Step find_step(const JawSurroundings& around, const AnchorSprings& anchors, const JawPlace& start,
               const JawPlace& place, const JawTouch& touch) noexcept {
  const Vec3 to_hand = around.hand - place.position;
  const double turned = place.jaws.angle() - start.jaws.angle();
  const Vec3 moved = place.position - start.position;
  const Drive drive = find_drive(around, place.jaws.angle());
  const Squeeze layer = find_squeeze(around.tool, place.jaws, touch.pressed);
  Eigen::Vector4d residual;
  residual.head<3>() = limit(around.coupling.stiffness * to_hand, around.coupling.force_max) +
                       touch.force + anchors.force - anchors.stiffness * moved -
                       anchors.mixed * turned;
  residual[3] = drive.torque + touch.torque + layer.torque + anchors.torque -
                anchors.mixed.dot(moved) - anchors.angular * turned;
  const bool opens = turned > 0.0 || (turned == 0.0 && residual[3] > 0.0);
  const double drag = opens ? around.drag : 0.0;
  residual[3] -= drag * turned;
  Eigen::Matrix4d jacobian;
  jacobian.topLeftCorner<3, 3>() =
      find_pull_slope(around.coupling, to_hand, touch.force, residual.head<3>()) + touch.stiffness +
      anchors.stiffness;
  jacobian.topRightCorner<3, 1>() = touch.mixed + anchors.mixed;
  jacobian.bottomLeftCorner<1, 3>() = (touch.mixed + anchors.mixed).transpose();
  // jaws that nothing resists turn as far as they may
  const double least = 1e-3 * around.grip * around.arm / kGripRise;
  jacobian(3, 3) = std::max(drive.slope + touch.angular + layer.slope + anchors.angular + drag,
                            std::max(least, 1e-12));
  const Step step = solve(jacobian, residual, place);
  if (!is_at_limit(around.coupling, to_hand)) return step;
  const double stiffness = around.coupling.stiffness;
  residual.head<3>() += stiffness * to_hand - limit(stiffness * to_hand, around.coupling.force_max);
  jacobian.topLeftCorner<3, 3>() =
      stiffness * Mat3::Identity() + touch.stiffness + anchors.stiffness;
  const Step unlimited = solve(jacobian, residual, place);
  return comes_within_limit(around.coupling, to_hand, unlimited.move) ? unlimited : step;
}

/// Of open surfaces each jaw may be on another side.
void follow_sides(const JawSurroundings& around, const JawPlace& place) noexcept {
  for (int j = 0; j < 2; ++j) {
    for (const TouchedSurface& surface : around.surfaces[static_cast<std::size_t>(j)]) {
      follow_side(place.jaws.shape(j), surface, place.position);
    }
  }
}

/// Newton's steps, from where the substep begins.
void settle(const JawSurroundings& around, const AnchorSprings& anchors, bool soft,
            JawPlace& place) noexcept {
  const JawPlace start = place;
  const Candidates& path = *around.surfaces[0].front().candidates;
  Memory memory(around.reach);
  for (int i = 0; i < kNewtonStepsAtLimit; ++i) {
    // one at its limit that has lost the surface goes far beyond it first
    const bool last = i == (soft ? kNewtonStepsNear : kNewtonSteps);
    if (last && !is_at_limit(around.coupling, around.hand - place.position)) break;
    follow_sides(around, place);
    const JawTouch touch = compute_touch(around, place);
    Step step;
    if (!touch.touches && anchors.stiffness.isZero(0.0)) {
      const double angle = std::clamp(around.wanted, place.least, place.most);
      step = {limit(around.hand - place.position, 0.5 * around.tool.radius),
              angle - place.jaws.angle()};
    } else {
      step = find_step(around, anchors, start, place, touch);
      const bool at_limit = is_at_limit(around.coupling, around.hand - place.position);
      if (soft && !at_limit) step = memory.improve(step);
      const double angle = place.jaws.angle();
      step.turn = std::clamp(angle + step.turn, place.least, place.most) - angle;
    }
    step = shorten(around, place, touch, step);
    // the other half of the margin is for jaws that turn
    step.move = keep_near_path(path, place.position, step.move, 0.5 * kCandidateMargin);
    const bool short_step = step.move.norm() < kShortestStep && std::abs(step.turn) < kShortestTurn;
    if (short_step && touch.touches) break;
    const bool arrives = step.move == around.hand - place.position;
    place.position = arrives ? around.hand : Vec3(place.position + step.move);
    memory.take(step);
    turn_to(around, place.jaws.angle() + step.turn, place);
  }
}

/// While jaws let go what is felt changes by no more than it may, and of jaws that are closed it
/// falls by no more: the tool goes that part of its way, and what this leaves unbalanced is lost as
/// of any step that is cut short (balance_tool.cpp). Of |F_0 + s dF| <= c the largest s, with F_0
/// what is felt at the start less what was felt before; where there is none, the s that comes
/// nearest. A hand at its limit feels no more than that, and a tool that has not moved has no way
/// to go a part of.
bool hold_back(const JawSurroundings& around, const ToolState& state, double most_fall,
               const Vec3& start, JawPlace& place) noexcept {
  const double stiffness = around.coupling.stiffness;
  const bool changes = state.felt_change > 0.0;
  const double most = changes ? state.felt_change : most_fall;
  const Vec3 from = stiffness * (start - around.hand) - state.felt_before;
  const Vec3 change = stiffness * (place.position - start);
  const Vec3 felt = limit(stiffness * (place.position - around.hand), around.coupling.force_max);
  if (!((felt - state.felt_before).squaredNorm() > most * most)) return false;
  if (!changes && !(felt.squaredNorm() < state.felt_before.squaredNorm())) return false;
  const double a = change.squaredNorm(), b = from.dot(change);
  if (!(a > 0.0)) return false;
  const double root = b * b - a * (from.squaredNorm() - most * most);
  const double part = (std::sqrt(std::max(0.0, root)) - b) / a;
  place.position = start + std::clamp(part, 0.0, 1.0) * (place.position - start);
  return true;
}

/// A tool that is held back has gone straight, where Newton's steps may have gone around a fold,
/// and its jaws have turned as if it had gone all of its way. So all of that is one step from where
/// the substep begins, and goes no farther than a step may.
void go_straight(const JawSurroundings& around, const JawPlace& start, JawPlace& place) noexcept {
  const Vec3 position = std::exchange(place.position, start.position);
  const double angle = place.jaws.angle(), from = start.jaws.angle();
  turn_to(around, from, place);
  follow_sides(around, place);
  const Step whole{position - start.position, angle - from};
  const Step step = shorten(around, place, compute_touch(around, place), whole);
  const bool arrives = step.move == whole.move && step.turn == whole.turn;
  place.position = arrives ? position : Vec3(start.position + step.move);
  turn_to(around, arrives ? angle : from + step.turn, place);
}

/// Writes what the jaws do to the surfaces; returns the sum of forces on the tool [N].
Vec3 write_pushes(const JawSurroundings& around, const JawPlace& place, ToolState& state) noexcept {
  const JawTouch touch = compute_touch(around, place);
  const Squeeze layer = find_squeeze(around.tool, place.jaws, touch.pressed);
  const auto bodies = around.surfaces[0];
  const int sorted = state.anchor_count;
  double nearest = std::numeric_limits<double>::infinity();
  Vec3 sum = Vec3::Zero();
  std::array<double, 2> extents{};  // [N m²]
  std::array<Vec3, 2> along;
  for (std::size_t j = 0; j < 2; ++j) {
    const Capsule& axis = place.jaws.axis_of(static_cast<int>(j));
    along[j] = (axis.to - axis.from).normalized();
  }
  state.carrier.triangle = -1;
  state.touching = false;
  unpress_anchors(state);
  for_each_of_jaws(around, place, [&](int jaw, int body, int t, const Contact& contact) noexcept {
    if (contact.distance < nearest) {
      const Vec3 at = find_at(around, place, jaw, body, t, contact) + place.position;
      nearest = contact.distance;
      state.carrier = {t, contact.weights, at, contact.direction, body};
    }
    if (!(contact.force > 0.0)) return;
    const Vec3 force = contact.force * contact.direction;
    if (!surface_of(around, jaw, body).load->add({t, contact.weights, -force})) return;
    sum += force;
    state.touching = true;
    const auto j = static_cast<std::size_t>(jaw);
    const TouchedSurface& surface = surface_of(around, jaw, body);
    extents[j] += contact.force * find_extent(triangle_at(surface, t), surface.x, along[j]);
    const double mu = find_friction(around.tool, bodies, body);
    if (!(mu > 0.0)) return;
    const double whole = touch.pressed[j].force;
    const Vec3 move = place.jaws.move(jaw, find_at(around, place, jaw, body, t, contact));
    const double opens = contact.direction.dot(move) / move.norm();
    const double pressed = contact.force * (1.0 + layer.force / whole) *
                           find_grip(mu, touch.pressed, layer.force, jaw, opens);
    press_anchor(around.tool, place.jaws, bodies, {jaw, body, t, contact.weights, pressed}, sorted,
                 state);
  });
  sum += pull_anchors(around.tool, place.jaws, bodies, sorted, state);
  state.pinch = 0.5 * (touch.pressed[0].force + touch.pressed[1].force) + layer.force;
  state.pad_pressure = 0.0;
  for (std::size_t j = 0; j < 2; ++j) {
    const Pressed& pressed = touch.pressed[j];
    const double area = find_covered(around.tool, pressed, extents[j]);
    if (!(area > 0.0)) continue;
    state.pad_pressure = std::max(state.pad_pressure, (pressed.force + layer.force) / area);
  }
  return sum;
}

/// [N m] On the tool about its position, of all that the loads have.
Vec3 compute_torque(std::span<const TouchedSurface> surfaces, const Vec3& p) noexcept {
  Vec3 torque = Vec3::Zero();
  for (const TouchedSurface& surface : surfaces) {
    for (const Push& push : surface.load->pushes()) {
      const Vec3 at = compute_point(triangle_at(surface, push.triangle), push.weights, surface.x);
      torque -= (at - p).cross(push.force);
    }
  }
  return torque;
}

/// Begins a substep with the surfaces of both jaws; false where nothing is anywhere near them.
bool begin(const JawSurroundings& around, ToolState& state) noexcept {
  bool near = state.anchor_count > 0;
  for (const auto& surfaces : around.surfaces) {
    for (const TouchedSurface& surface : surfaces) {
      Candidates& candidates = *surface.candidates;
      NearContacts& contacts = candidates.near;
      candidates.lanes.reach = -1.0;
      const bool known = contacts.centre == state.position + contacts.lift;
      contacts.lift = known ? contacts.next_lift : Vec3::Zero();
      contacts.found = false;
      surface.load->clear();
      near = near || candidates.count > 0;
    }
  }
  return near;
}

}  // namespace

Vec3 balance_jaws(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                  const JawSurfaces& surfaces, double dt, ToolState& state,
                  double most_fall) noexcept {
  const double arm = measure_arm(tool);
  const bool closes = state.jaw_wanted < state.jaw_angle;
  const JawSurroundings around{
      .tool = tool,
      .coupling = coupling,
      .hand = hand_position,
      .surfaces = surfaces,
      .wanted = state.jaw_wanted,
      .grip = state.grip_limit,
      .arm = arm,
      .reach = find_reach(tool),
      .drag = closes ? 2.0 * state.grip_limit * arm / (kHingeRate * dt) : 0.0};
  const Vec3 before = state.position;
  const bool near = begin(around, state);
  if (!near) {
    state.position = hand_position;
    state.jaw_angle = state.jaw_wanted;
  }
  JawPlace place{state.position, OpenJaws(tool, state.orientation, state.jaw_angle),
                 std::max(0.0, state.jaw_angle - kMostTurn),
                 std::min(tool.jaws->open, state.jaw_angle + kMostTurn)};
  const AnchorSprings anchors = find_anchor_springs(tool, place.jaws, surfaces[0], state);
  bool soft = false;
  for (const TouchedSurface& surface : surfaces[0]) soft = soft || surface.near;
  const JawPlace start = place;
  settle(around, anchors, soft, place);
  const bool limited = state.felt_change > 0.0 || most_fall > 0.0;
  if (limited && hold_back(around, state, most_fall, before, place) && near) {
    go_straight(around, start, place);
  }
  state.position = place.position;
  state.jaw_angle = place.jaws.angle();
  const Vec3 sum = write_pushes(around, place, state);
  const Vec3 felt =
      limit(coupling.stiffness * (state.position - hand_position), coupling.force_max);
  state.residual = sum - felt;
  state.torque = compute_torque(surfaces[0], state.position);
  return felt;
}

}  // namespace palpate
