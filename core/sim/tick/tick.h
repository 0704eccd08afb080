// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "palpate/sim/contact/tool.h"
#include "palpate/sim/device/device.h"
#include "palpate/sim/tick/tick_log.h"
#include "palpate/sim/tick/world.h"
#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

/// Puts a tool that is nowhere yet where the hand is, and returns whether it is in the scene.
///
/// A hand that begins inside the tissue has no tool: nothing is touched or felt until it has come
/// out, and as far as two fifths of the tool's `radius` [m]. Put inside, the tool would be
/// behind every triangle and be shot out where it breaks through; put deep in the surface, it would
/// tear that; put on the nearest outside, the hand would be struck with all the force there is.
bool place_tool(const AabbTree& tree, std::span<const Vec3> x, const Vec3& hand_position,
                double radius, ToolState& tool) noexcept;

/// Whether a tool may be put there: outside of the surface, and no deeper in it than that.
bool has_room(const AabbTree& tree, std::span<const Vec3> x, const Vec3& hand_position,
              double radius) noexcept;

/// The same for a tool of any shape that is held so, with jaws open by `jaw_angle` [rad].
bool has_room(const AabbTree& tree, std::span<const Vec3> x, const Vec3& hand_position,
              const Tool& tool, const Quaternion& orientation, double jaw_angle = 0.0) noexcept;

/// How often the surface goes round `p`: 1 inside of a closed surface, 0 outside, and for an open
/// one what is in between: the share of all directions from `p` that the surface covers.
double compute_winding_number(std::span<const Triangle> triangles, std::span<const Vec3> x,
                              const Vec3& p) noexcept;

/// One haptic tick of dt [s]: from where the hands are to the forces they must feel, the mean over
/// the substeps. `samples` and `commands` have one entry for each instrument. The live loop, the
/// replay of a record and the tests all call this function, so a recorded session gives back the
/// very same forces. Does not allocate, lock, log or throw.
///
/// A tool is drawn to its hand, which is followed at up to 3 m/s. It appears there with the first
/// sample outside all tissue (place_tool). Pressing the attach button fastens it to what it
/// touched last, letting go releases it; a tool with jaws closes them while it is pressed.
///
/// What cannot be used is an alarm too (check_input.h). After an alarm the tissue stands still as
/// it was before the tick that raised it, and the forces fade from those of the tick before to zero
/// within 20 ms.
void tick(const Scene& scene, std::span<const HapticSample> samples, double dt, World& world,
          std::span<HapticCommand> commands) noexcept;

/// The same for a scene of one instrument.
HapticCommand tick(const Scene& scene, const HapticSample& sample, double dt,
                   World& world) noexcept;

/// What a record keeps of a tick, lateness left at 0; `command` is that of the instrument.
Felt compute_felt(const HapticCommand& command, const World& world,
                  std::size_t instrument = 0) noexcept;

/// 128 bits over positions, velocities and the tools: equal worlds, equal hashes. Nothing of the
/// world may be behind (catch_up).
std::array<std::uint64_t, 2> compute_hash(const World& world) noexcept;

}  // namespace palpate
