// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/dynamics/packed_model.h"

namespace palpate::packed_kernels {

/// What a tissue has done since the last look.
struct Change {
  bool moved_far = false;      ///< some particle beyond the limit, or nowhere
  double gravity_work = 0.0;   ///< [J]
  double pressure_work = 0.0;  ///< [J]
};

/// The kernels compiled for one vector target. Each works on models of its own width.
struct Kernels {
  const char* target = nullptr;
  int width = 0;  ///< lanes

  /// Adds the forces of bonds, angles and stretch-bend to the force rows; to `measure` their
  /// energy, unless it is null.
  void (*accumulate_triangles)(const PackedModel& model, PackedState& state,
                               PackedMeasure* measure) noexcept = nullptr;
  /// The same for what resists the shear of walls.
  void (*accumulate_prisms)(const PackedModel& model, PackedState& state,
                            PackedMeasure* measure) noexcept = nullptr;
  /// The same for what resists a change of volume.
  void (*accumulate_volumes)(const PackedModel& model, PackedState& state,
                             PackedMeasure* measure) noexcept = nullptr;
  /// Adds the forces of the pressure to the force rows.
  void (*accumulate_pressure)(const PackedModel& model, PackedState& state) noexcept = nullptr;
  /// Adds links, home springs, gravity [m/s²], drag and the force rows, moves every particle by
  /// one step of dt [s] into the other tables of rows, and leaves the force rows zero. Adds to
  /// `measure` the energies of all these, unless it is null.
  void (*advance)(const PackedModel& model, const Eigen::Vector3f& gravity, float dt,
                  PackedState& state, PackedMeasure* measure) noexcept = nullptr;
  /// Compares with where all was at the last look. `farthest` [m] is how far a particle may have
  /// gone.
  Change (*compare)(const PackedModel& model, const Eigen::Vector3f& gravity, float farthest,
                    const PackedState& state) noexcept = nullptr;
  /// Writes position [m] and velocity [m/s] of every particle that moves, in double.
  void (*unpack)(const PackedModel& model, const Vec3* rest, const PackedState& packed,
                 Vec3* position, Vec3* velocity) noexcept = nullptr;
  /// Says of each slice that moves whether a particle in it has moved: whether it is more than
  /// `least` [m] from where `anchor` has it, and that way, times the longer of it and the way from
  /// where `still` has it, is more than `yield` [m²].
  void (*find_moved)(const PackedModel& model, float least, float yield, const float* anchor,
                     const float* still, const PackedState& state,
                     unsigned char* moved) noexcept = nullptr;
};

/// Those this machine can run, the best first.
std::span<const Kernels* const> available() noexcept;

}  // namespace palpate::packed_kernels
