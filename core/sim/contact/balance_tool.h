// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/find_candidates.h"
#include "palpate/sim/contact/tool.h"
#include "palpate/sim/model/load.h"

namespace palpate {

/// The hand's spring: what pulls the tool to where the device is.
struct Coupling {
  double stiffness = 500.0;  ///< [N/m] K of Eq 12
  double force_max = 5.0;    ///< [N]
};

/// Moves the massless tool to where the hand's spring and the tissue's pushes cancel, and writes
/// those pushes into `load` (its pushes are replaced).
///
/// Contact t pushes with f = k_A A_t depth / max(0.1, 1 - depth/radius) along the line from its
/// closest point to the tool's centre; contacts whose centre lies behind their triangle are
/// dropped. Three Newton steps of a 3x3 system, each going at most half the way to any surface it
/// nears, so that the tool's own motion never takes it through. Returns the force on the hand, K
/// (tool - hand), limited to force_max: f = -K x, Eq 12. state.residual is what the steps leave:
/// the pushes on the tissue sum to -(force + residual). Where nothing touches the tool is at the
/// hand and the force is exactly zero.
Vec3 balance_tool(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                  Candidates& candidates, std::span<const Triangle> triangles,
                  std::span<const Vec3> x, ToolState& state, Load& load) noexcept;

/// Fastens the tool to the patch it touches, shares weighted by contact force; `stiffness` [N/m]
/// in all. Does nothing, and returns false, when it touches nothing. Offsets are chosen so that
/// the holds exert no force at the moment of attaching. A tool that is attached stays as it is.
bool attach_tool(const Load& contacts, std::span<const Triangle> triangles, std::span<const Vec3> x,
                 double stiffness, ToolState& state) noexcept;

void release_tool(ToolState& state) noexcept;

/// Largest extra eigenvalue [1/s²] that contacts and holds may add to M⁻¹K: the row-sum bound
/// max over particles of sum k_t w / m [contact: substeps]. For choosing this tick's substeps.
/// `body` tells which holds are on this surface.
double bound_contact_stiffness(const Tool& tool, const Candidates& candidates,
                               std::span<const Triangle> triangles, std::span<const Vec3> x,
                               std::span<const double> mass, const ToolState& state,
                               std::span<double> scratch, int body = 0) noexcept;

}  // namespace palpate
