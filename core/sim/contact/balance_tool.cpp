// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>

#include "palpate/sim/base/private/limit.h"
#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/contact/private/broad_phase.h"
#include "palpate/sim/contact/private/friction.h"
#include "palpate/sim/contact/private/list_contacts.h"
#include "palpate/sim/contact/private/near_contact.h"
#include "palpate/sim/contact/private/touched_surface.h"

namespace palpate {
namespace {

constexpr int kNewtonSteps = 3;

// where contacts are soft until a barrier: a step that ends in it is followed by some that come out
constexpr int kNewtonStepsNear = 6;

// [m] a step that is left out where contacts are costly to find: 5e-6 N of the hand's spring
constexpr double kShortestStep = 1e-8;

/// What the tissue does to the tool at one position.
struct Touch {
  Vec3 force = Vec3::Zero();      ///< [N] on the tool
  Mat3 stiffness = Mat3::Zero();  ///< [N/m] of contacts along their directions, and of holds
  Vec3 contact = Vec3::Zero();    ///< [N] the part of contacts in the force
  double hold_stiffness = 0.0;    ///< [N/m] the part of holds in the stiffness
  double friction_part = 1.0;     ///< [-] mu of what is touched over Tool::friction
  double smallest_distance =
      0.0;  ///< [m] from the tool's centre to the surface, at most its radius
};

/// All that balance_tool only reads.
struct Surroundings {
  Shape shape;
  std::span<const TouchedSurface> surfaces;
  std::span<const ToolState::Hold> holds;
};

/// [m] The point of a triangle of one of the surfaces.
Vec3 compute_point_of(const Surroundings& around, int body, int t, const Vec3& weights) noexcept {
  const TouchedSurface& surface = around.surfaces[static_cast<std::size_t>(body)];
  return compute_point(triangle_at(surface, t), weights, surface.x);
}

/// Calls `take(body, triangle, contact)` for those of all surfaces, one surface after the other.
template <class Take>
void for_each_closest(const Surroundings& around, const Vec3& p, Take take) noexcept {
  for (std::size_t b = 0; b < around.surfaces.size(); ++b) {
    for_each_closest(
        around.shape, around.surfaces[b], lift(around.surfaces[b], p),
        [&](int t, const Contact& contact) noexcept { take(static_cast<int>(b), t, contact); });
  }
}

template <class Take>
void for_each_contact(const Surroundings& around, const Vec3& p, Take take) noexcept {
  for (std::size_t b = 0; b < around.surfaces.size(); ++b) {
    for_each_contact(
        around.shape, around.surfaces[b], p,
        [&](int t, const Contact& contact) noexcept { take(static_cast<int>(b), t, contact); });
  }
}

/// [N] on the tool, with y the patch's point: k (y + offset - p), or as the tissue under it.
Vec3 compute_pull(const Surroundings& around, const ToolState::Hold& hold, const Vec3& p) noexcept {
  const Vec3 y = compute_point_of(around, hold.body, hold.triangle, hold.weights);
  return hold.pull(y + hold.offset - p);
}

Touch compute_touch(const Surroundings& around, const Vec3& p) noexcept {
  Touch touch;
  touch.smallest_distance = around.shape.tool.radius;
  double pressed = 0.0, rubbed = 0.0;
  for_each_contact(around, p, [&](int body, int, const Contact& contact) noexcept {
    const Vec3& n = contact.direction;
    pressed += contact.force;
    rubbed += around.surfaces[static_cast<std::size_t>(body)].friction_part * contact.force;
    touch.force += contact.force * n;
    touch.stiffness += contact.stiffness * (n * n.transpose());
    touch.smallest_distance = std::min(touch.smallest_distance, contact.distance);
  });
  touch.contact = touch.force;
  if (pressed > 0.0) touch.friction_part = rubbed / pressed;
  for (const ToolState::Hold& hold : around.holds) {
    touch.force += compute_pull(around, hold, p);
    const double across = hold.is_tied() ? hold.sideways : hold.stiffness;
    touch.stiffness += across * Mat3::Identity();
    if (hold.is_tied()) {
      touch.stiffness += (hold.stiffness - across) * (hold.normal * hold.normal.transpose());
    }
    touch.hold_stiffness += across;
  }
  return touch;
}

/// The part of a step from p that may be taken. A contact's triangle lies beyond the plane through
/// its closest point, all that is not in contact at least a radius away: a step of half a radius
/// that goes at most half the way to any of those planes cannot end behind the surface.
Vec3 shorten(const Surroundings& around, const Vec3& p, const Touch& touch, Vec3 step) noexcept {
  if (step.norm() <= 0.5 * (touch.smallest_distance - kClearance * around.shape.tool.radius))
    return step;
  step = limit(step, 0.5 * around.shape.tool.radius);
  double part = 1.0;
  for_each_closest(around, p, [&](int, int, const Contact& contact) noexcept {
    const double approach = -step.dot(contact.direction);
    const double room = 0.5 * (contact.distance - kClearance * around.shape.tool.radius);
    if (approach > 0.0) part = std::min(part, std::max(0.0, room) / approach);
  });
  return part * step;
}

/// One Newton step of R(p) = pull of the hand + touch = 0. What touches nothing is where the hand
/// is, to the bit, so that it feels exactly 0 N. `stuck` [m] is where friction would keep it.
Vec3 take_newton_step(const Surroundings& around, const Coupling& coupling, const Vec3& hand,
                      const Vec3& stuck, const Vec3& p) noexcept {
  for (const TouchedSurface& surface : around.surfaces) follow_side(around.shape, surface, p);
  const Touch touch = compute_touch(around, p);
  const Vec3 to_hand = hand - p;
  if (touch.stiffness.isZero(0.0)) {
    const double most = 0.5 * around.shape.tool.radius;
    return to_hand.norm() <= most ? hand : Vec3(p + limit(to_hand, most));
  }
  const Vec3 unlimited = coupling.stiffness * to_hand + touch.force;
  const Mat3 stiff = coupling.stiffness * Mat3::Identity() + touch.stiffness;
  const bool at_limit = is_at_limit(coupling, to_hand) &&
                        !comes_within_limit(coupling, to_hand, stiff.llt().solve(unlimited));
  const Vec3 residual =
      at_limit ? limit(coupling.stiffness * to_hand, coupling.force_max) + touch.force : unlimited;
  const Mat3 jacobian =
      at_limit ? find_pull_slope(coupling, to_hand, touch.contact, residual) + touch.stiffness
               : stiff;
  const double mu = around.shape.tool.friction * touch.friction_part;
  const bool rubs = mu > 0.0 && !touch.contact.isZero(0.0);
  const Vec3 whole =
      rubs ? find_friction_step({residual - touch.contact, touch.contact,
                                 coupling.stiffness + touch.hold_stiffness,
                                 touch.stiffness - touch.hold_stiffness * Mat3::Identity()},
                                stuck - p, mu)
           : Vec3(jacobian.llt().solve(residual));
  const Vec3 step = shorten(around, p, touch, whole);
  // all surfaces were searched along the same path
  return p + keep_near_path(*around.surfaces.front().candidates, p, step, kCandidateMargin);
}

/// Footprints cost ten times what closest points do.
bool has_near_field(const Surroundings& around) noexcept {
  return std::ranges::any_of(around.surfaces, [](const TouchedSurface& surface) noexcept {
    return surface.near && surface.candidates->count > 0;
  });
}

/// The step of a tool that rides on the motion of the nearest surface, along their common normal:
/// since the last substep the tissue has moved and the tool has not. Left behind, it would be
/// passed over by any surface faster than distance per substep, which is not fast for an impact.
Vec3 ride(const Surroundings& around, const ToolState& state) noexcept {
  const ToolState::Carrier& carrier = state.carrier;
  if (carrier.triangle < 0) return Vec3::Zero();
  const Vec3 now = compute_point_of(around, carrier.body, carrier.triangle, carrier.weights);
  return carrier.direction * std::max(0.0, (now - carrier.point).dot(carrier.direction));
}

/// The lift off triangles that the last substep has found for a tool that is still there.
void follow_dent(const Vec3& position, NearContacts& contacts) noexcept {
  contacts.lift = contacts.centre == position + contacts.lift ? contacts.next_lift : Vec3::Zero();
  contacts.found = false;
}

/// What the holds of a body push in place of the pressures that they have taken over.
void follow_grip(const Surroundings& around, std::size_t body, const Vec3& p) noexcept {
  if (!around.surfaces[body].near) return;
  Grip& grip = around.surfaces[body].candidates->near.grip;
  if (around.holds.empty()) grip = {};
  if (!(grip.force > 0.0)) return;
  grip.pushed = grip.stiffness = 0.0;
  grip.place = p;
  for (const ToolState::Hold& hold : around.holds) {
    if (hold.body != static_cast<int>(body)) continue;
    grip.pushed += grip.share * compute_pull(around, hold, p).dot(grip.normal);
    grip.stiffness += grip.share * hold.stiffness;
  }
}

/// [N m] On the tool about p, of all that the loads have.
Vec3 compute_torque(const Surroundings& around, const Vec3& p) noexcept {
  Vec3 torque = Vec3::Zero();
  for (std::size_t b = 0; b < around.surfaces.size(); ++b) {
    for (const Push& push : around.surfaces[b].load->pushes()) {
      const Vec3 at = compute_point_of(around, static_cast<int>(b), push.triangle, push.weights);
      torque -= (at - p).cross(push.force);
    }
  }
  return torque;
}

/// Writes what the tool does to the surfaces under the pull of the hand's spring [N]; returns the
/// sum of forces on the tool.
Vec3 write_pushes(const Surroundings& around, const Vec3& pull, ToolState& state) noexcept {
  Vec3 sum = Vec3::Zero();
  double nearest = std::numeric_limits<double>::infinity();
  state.carrier.triangle = -1;
  state.touching = false;
  for_each_contact(around, state.position, [&](int body, int t, const Contact& contact) noexcept {
    if (!(contact.force > 0.0)) return;
    const Vec3 force = contact.force * contact.direction;
    Load& load = *around.surfaces[static_cast<std::size_t>(body)].load;
    if (load.add({t, contact.weights, -force})) {
      sum += force;
      state.touching = true;
    }
  });
  for_each_closest(around, state.position, [&](int body, int t, const Contact& contact) noexcept {
    if (contact.distance >= nearest) return;
    nearest = contact.distance;
    state.carrier = {t, contact.weights, compute_point_of(around, body, t, contact.weights),
                     contact.direction, body};
  });
  if (around.shape.tool.friction > 0.0) {
    Vec3 applied = pull;
    for (const ToolState::Hold& hold : around.holds) {
      applied += compute_pull(around, hold, state.position);
    }
    sum += add_friction(around.surfaces, applied, sum, around.shape.tool.friction, state);
  }
  for (const ToolState::Hold& hold : around.holds) {
    const Vec3 force = compute_pull(around, hold, state.position);
    Load& load = *around.surfaces[static_cast<std::size_t>(hold.body)].load;
    if (load.add({hold.triangle, hold.weights, -force})) sum += force;
  }
  if (around.shape.axes.count > 0) state.torque = compute_torque(around, state.position);
  return sum;
}

}  // namespace

/// The tool has no mass, so the hand's spring and the pushes balance at its position p:
///
///     R(p) = clamp(K (h - p)) + sum f_t n_t + sum k_h (y_h + o_h - p) = 0
///     J = K I + sum f_t' n n^T + sum k_h I,   dp = J^-1 R,   shortened before the surface
///
/// (god-object [ZillesSalisbury95] without constraint planes [contact: balance]). J leaves out how
/// n turns, the only part that could make it indefinite: steps come out short, never wild, and what
/// three of them leave over goes on in the next substep, from where the tool is then. Convergence
/// is linear; a tool at rest reaches R = 0 to rounding.
///
/// The force on the hand is K (p - h) also while R is not yet zero, not the sum of the pushes:
/// hand and tissue then act on the two ends of springs that store what they are given, and the
/// difference R does the work R·dp = R·J^-1 R >= 0 on the tool, which is lost. A force read off
/// the pushes instead would belong to no stored energy, and would jump whenever a triangle comes
/// into contact. ToolState::residual is that difference.
Vec3 balance_tool(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                  std::span<const TouchedSurface> surfaces, ToolState& state) noexcept {
  const Surroundings around{{tool, Axes(tool, state.orientation, state.jaw_angle)},
                            surfaces,
                            {state.holds.data(), static_cast<std::size_t>(state.hold_count)}};
  bool near = state.hold_count > 0;
  for (const TouchedSurface& surface : surfaces) {
    surface.candidates->lanes.reach = -1.0;  // the tissue has moved since they were filled
    follow_dent(state.position, surface.candidates->near);
    surface.load->clear();
    near = near || surface.candidates->count > 0;
  }
  if (!state.placed) {
    state.position = hand_position;
    state.placed = true;
    state.patch_count = 0;
  }
  // nothing anywhere near the path: no need to go it in steps
  if (!near) {
    state.position = hand_position;
    state.patch_count = 0;
  }
  for (std::size_t b = 0; b < surfaces.size(); ++b) follow_grip(around, b, state.position);
  const Vec3 carry = measure_carry(surfaces, state);
  const Vec3 stuck = state.position + carry;
  state.position += ride(around, state);
  if (state.patch_count > 0) state.position += carry;
  const bool soft = has_near_field(around);
  const double shortest = soft ? kShortestStep : 0.0;
  for (int i = 0; i < kNewtonStepsNear; ++i) {
    // one at its limit that has lost the surface goes far beyond it first
    const bool last = i == kNewtonSteps && !soft;
    if (last && !is_at_limit(coupling, hand_position - state.position)) break;
    const Vec3 next = take_newton_step(around, coupling, hand_position, stuck, state.position);
    // contacts stay those of where it is
    if (next != hand_position && (next - state.position).norm() < shortest) break;
    state.position = next;
  }
  const Vec3 felt =
      limit(coupling.stiffness * (state.position - hand_position), coupling.force_max);
  const Vec3 touch = write_pushes(around, -felt, state);
  state.residual = touch - felt;
  return felt;
}

Vec3 balance_tool(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                  Candidates& candidates, std::span<const Triangle> triangles,
                  std::span<const Vec3> x, ToolState& state, Load& load) noexcept {
  const TouchedSurface surface{&candidates, triangles, x, &load};
  return balance_tool(tool, coupling, hand_position, {&surface, 1}, state);
}

}  // namespace palpate
