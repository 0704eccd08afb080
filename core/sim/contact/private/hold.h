// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/contact/private/touched_surface.h"

namespace palpate {

/// [m] How far the hand has gone on since its spring could pull no harder: by so much a tool that
/// is held has slid in its grip.
double measure_slip(const Coupling& coupling, const Vec3& hand_position,
                    const ToolState& state) noexcept;

/// [N] What all holds together carry, each whatever its direction; the loads of the surfaces are
/// what they did in the last substep.
double measure_held_load(const ToolState& state, std::span<const TouchedSurface> surfaces) noexcept;

/// [J] No less than what the hand's spring, contacts and holds can give before the hand moves
/// again; the loads of the surfaces are what they did in the last substep.
double bound_stored_energy(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                           const ToolState& state,
                           std::span<const TouchedSurface> surfaces) noexcept;

/// bound_contact_stiffness() of one part of a tool; what the tool holds counts with one of them.
double bound_shape_stiffness(const Shape& shape, bool with_holds, const Candidates& candidates,
                             std::span<const Triangle> triangles, std::span<const Vec3> x,
                             std::span<const double> mass, const ToolState& state,
                             std::span<double> scratch, int body, const NearField* near,
                             double coupling) noexcept;

}  // namespace palpate
