// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>

#include "palpate/sim/contact/find_candidates.h"
#include "palpate/sim/contact/tool.h"

namespace palpate {

// The capsules of a tool as it is held: in the directions of the scene, about its position.

/// The axis of a capsule off the tool's position [m], in the scene's directions.
struct Axes {
  Axes() = default;
  /// `jaw_angle` [rad] of a tool with jaws, by which each is open.
  Axes(const Tool& tool, const Quaternion& orientation, double jaw_angle = 0.0) noexcept;

  std::span<const Capsule> list() const noexcept {
    return std::span(capsules).first(static_cast<std::size_t>(count));
  }

  std::array<Capsule, kMostCapsules> capsules;
  int count = 0;  ///< 0 of a ball
};

/// [m] A capsule of a tool in the tool's frame: of one with jaws, which are open by that [rad].
Capsule open_jaw(const Tool& tool, std::size_t capsule, double angle) noexcept;

/// What touches, as it is held.
struct Shape {
  const Tool& tool;
  Axes axes;
};

/// [m] The point of the axes of a shape at p [m] that is nearest to another; of a ball p itself.
Vec3 find_nearest_on_axes(const Axes& axes, const Vec3& p, const Vec3& point) noexcept;

/// How a triangle of an open surface is touched; of a closed one, as it is without.
struct Openness {
  double side = 1.0;         ///< [-] -1 where the tool is behind the surface
  unsigned char border = 0;  ///< bit k where the edge opposite corner k is a border of it
};

/// The contact of a shape at p [m] with a triangle: of the capsule whose axis is nearest to it.
bool find_shape_contact(const Shape& shape, double rest_area, const Vec3& p, const Vec3& a,
                        const Vec3& b, const Vec3& c, Contact& contact,
                        const Openness& open = {}) noexcept;

/// A jaw on a wall of springs presses where it lies on a triangle, on the mean of the ends of that
/// line by their depths, and not on the closer end alone [contact: spread].
inline bool spreads(const Shape& shape, bool springs) noexcept {
  return springs && shape.tool.jaws && shape.axes.count == 1;
}

/// Moves the point of the contact of a shape at p [m] that spreads; how hard it presses, and in
/// which direction, stays that of the closest point.
void spread_contact(const Shape& shape, const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c,
                    Contact& contact) noexcept;

/// The point of a triangle that is closest to a shape at p [m], and the arm from there to its axis,
/// a ball's centre.
struct ClosestArm {
  Vec3 weights = Vec3::Zero();  ///< barycentric
  Vec3 arm = Vec3::Zero();      ///< [m]
};

ClosestArm find_closest_arm(const Shape& shape, const Vec3& p, const Vec3& a, const Vec3& b,
                            const Vec3& c) noexcept;

/// All that a part of a tool may come near to on a path.
struct SweptPart {
  Vec3 from = Vec3::Zero();  ///< [m] the ends of a segment
  Vec3 to = Vec3::Zero();    ///< [m]
  double radius = 0.0;       ///< [m] about it
};

/// What a tool sweeps that goes straight from one position to another: of a ball the path itself,
/// of a capsule its axis halfway, with half of the path about it.
struct Sweep {
  Sweep(const Tool& tool, const Axes& axes, const Vec3& tool_position,
        const Vec3& hand_position) noexcept;

  std::span<const SweptPart> list() const noexcept {
    return std::span(parts).first(static_cast<std::size_t>(count));
  }

  std::array<SweptPart, kMostCapsules> parts;
  int count = 0;
};

}  // namespace palpate
