// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/task/task.h"

// What judge() measures of an instrument in a tick. Nothing here reads where a tissue is, which
// under World::follows_all off is not known: only what the tool does to it, and where that is.

namespace palpate {

/// Where a tool touches or holds, by the force or the stiffness that is there.
struct Grounding {
  double weight = 0.0;          ///< [N] or [N/m] in all; 0 for nowhere
  Vec3 at_rest = Vec3::Zero();  ///< [m] the mean of the points of the surface, at rest
  Vec3 normal = Vec3::Zero();   ///< unit, outwards there, at rest
  int body = 0;                 ///< that has most of it
};

/// An instrument as the tick has left it.
struct Measures {
  double force = 0.0;  ///< [N]
  Grounding contact, hold;
  double depth = 0.0;                    ///< [m] of the tip below the surface at rest
  Vec3 displacement = Vec3::Zero();      ///< [m] of what is held
  double force_rate = 0.0, speed = 0.0;  ///< [N/s], [m/s]
  bool clicked = false;                  ///< a button has gone down
};

/// What an instrument did to a body in the last substep: contacts first, then a push of each hold.
struct Pushes {
  std::span<const Push> contacts, holds;
};
Pushes list_pushes(const World& world, std::size_t instrument, std::size_t body) noexcept;

/// Holds of a tool, and where tissue sticks to its jaws, of all bodies.
inline std::span<const ToolState::Hold> list_holds(const ToolState& tool) noexcept {
  return {tool.holds.data(), static_cast<std::size_t>(tool.hold_count)};
}
inline std::span<const ToolState::Anchor> list_anchors(const ToolState& tool) noexcept {
  return {tool.anchors.data(), static_cast<std::size_t>(tool.anchor_count)};
}

/// What is true of an instrument after a tick; moves its history on.
Measures measure_instrument(const Task& task, const World& world, std::size_t instrument,
                            const HapticSample& sample, const HapticCommand& command, double radius,
                            double dt, JudgeSignals& signals) noexcept;

/// [-] The part of the contact force, or [-] of a hold's stiffness, that is at a place.
double find_contact_share(const Task& task, const World& world, std::size_t instrument,
                          const TaskPlace& place, const Measures& measures) noexcept;
double find_hold_share(const Task& task, const World& world, std::size_t instrument,
                       const TaskPlace& place, const Measures& measures) noexcept;

/// [-] The largest principal strain of the triangles that the tool touches or holds, of those at a
/// place where one is given: of the surface within its plane, as a stretch less 1. 0 for none. At
/// an object of all that is pushed next to it.
double find_strain(const Task& task, const World& world, std::size_t instrument,
                   const TaskPlace* place) noexcept;

/// [-] of a triangle with its corners at `now` that has them `at_rest`; never below 0.
double find_strain(const Triangle& t, std::span<const Vec3> at_rest,
                   std::span<const Vec3> now) noexcept;

/// [m] From a point to a place: to the surface of a ball or a space, or a path, 0 on it or inside.
/// Infinite for a region or an object, which have no such distance.
double find_distance(const TaskPlace& place, const Vec3& at_rest) noexcept;

/// The nearest point of a path between two arc lengths [m].
struct OnPath {
  double arc_length = 0.0;  ///< [m]
  double distance = 0.0;    ///< [m]
};
OnPath find_on_path(const TaskPlace& path, const Vec3& at_rest, double from, double to) noexcept;

}  // namespace palpate
