// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/private/axes.h"

namespace palpate {

// balance_tool() and attach_tool() with several surfaces at once: the bodies of a scene.

/// One of the surfaces that a tool may touch, and where its pushes on that one are written.
struct TouchedSurface {
  Candidates* candidates = nullptr;
  std::span<const Triangle> triangles;
  std::span<const Vec3> x;  ///< [m]
  Load* load = nullptr;
  const NearField* near = nullptr;                   ///< null under the hard law alone
  std::span<const NearContacts* const> others = {};  ///< of other instruments, under the near field
  double wall_thickness = 0.0;                       ///< [m] of prisms; 0 of what has none
  double wall_modulus = 0.0;                         ///< [Pa] E* of such a wall
  bool springs = false;                              ///< of a wall that has nothing else
  double friction_part = 1.0;  ///< [-] mu of the tool on it over Tool::friction
};

/// The pushes of all surfaces cancel the hand's spring, and each gets its own into its load.
Vec3 balance_tool(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                  std::span<const TouchedSurface> surfaces, ToolState& state) noexcept;

/// Fastens the tool to what it touches of all surfaces, whose loads have its contacts.
bool attach_tool(std::span<const TouchedSurface> surfaces, double stiffness,
                 ToolState& state) noexcept;

// Open surfaces, which a tool may touch from both sides [contact: borders] (border.cpp).

/// Candidates::border of a surface.
std::vector<unsigned char> find_border(std::span<const Triangle> triangles);

/// How triangle t is touched.
inline Openness find_openness(const Candidates& candidates, int t) noexcept {
  if (candidates.border.empty()) return {};
  return {candidates.near.side < 0.0 ? -1.0 : 1.0, candidates.border[static_cast<std::size_t>(t)]};
}

/// Finds out, of an open surface, on which side of it a tool at p [m] is. A side that is known
/// changes only where nothing is touched, or the border is what is nearest: elsewhere contact keeps
/// a tool on the side by which it has come.
void follow_side(const Shape& shape, const TouchedSurface& surface, const Vec3& p) noexcept;

}  // namespace palpate
