// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "palpate/sim/collision/private/surface_contacts.h"

/// Contacts that are held, four at a time. All of it does the operations of plain code in its
/// order: the answers are the same bits on every machine.
namespace palpate::held_kernels {

/// What four contacts do to their vertices, one per lane.
struct FourForces {
  alignas(32) double force[4];  ///< [N] along the normal
  unsigned stopped = 0;         ///< bits of those whose closing speed is too much for the step
};

/// The kernels, compiled for one kind of vector.
struct Kernels {
  const char* target = nullptr;

  /// Sets the gaps of the contacts of the active vertices at these `places`, by the points that
  /// were nearest, and writes into `lapsed` the places of those that have slid too far; how many.
  std::size_t (*follow)(std::span<const Vec3> x_v, std::span<const Triangle> triangles,
                        std::span<const Vec3> x_t, std::span<const int> places,
                        SurfaceContacts& contacts, std::span<int> lapsed) noexcept = nullptr;
  /// The forces of the contacts at four places, for a step of dt [s], of surfaces that are their
  /// own particles. SurfaceContacts::resistance of them is known.
  FourForces (*push)(double dt, const TouchingSurface& vertices, const TouchingSurface& triangles,
                     const SurfaceContacts& contacts,
                     std::span<const int, 4> places) noexcept = nullptr;
};

/// Those this machine can run, the best first; plain code is always the last.
std::span<const Kernels* const> available() noexcept;

const Kernels& best() noexcept;
const Kernels& plain() noexcept;

}  // namespace palpate::held_kernels
