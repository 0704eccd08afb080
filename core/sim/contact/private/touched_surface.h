// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/contact/contact_law.h"

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
};

/// The pushes of all surfaces cancel the hand's spring, and each gets its own into its load.
Vec3 balance_tool(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                  std::span<const TouchedSurface> surfaces, ToolState& state) noexcept;

/// Fastens the tool to what it touches of all surfaces, whose loads have its contacts.
bool attach_tool(std::span<const TouchedSurface> surfaces, double stiffness,
                 ToolState& state) noexcept;

}  // namespace palpate
