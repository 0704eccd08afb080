// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/dynamics/packed_model.h"

namespace palpate::packed_kernels {

/// The kernels compiled for one vector target. Each works on models of its own width.
struct Kernels {
  const char* target = nullptr;
  int width = 0;  ///< lanes

  /// Adds the forces of bonds, angles and stretch-bend to the force rows.
  void (*accumulate_triangles)(const PackedModel& model, PackedState& state) noexcept = nullptr;
  /// Adds the forces of the pressure to the force rows.
  void (*accumulate_pressure)(const PackedModel& model, PackedState& state) noexcept = nullptr;
  /// Adds links, home springs, gravity [m/s²], drag and the force rows, moves every particle by
  /// one step of dt [s] into the other tables of rows, and leaves the force rows zero.
  void (*advance)(const PackedModel& model, const Eigen::Vector3f& gravity, float dt,
                  PackedState& state) noexcept = nullptr;
};

/// Those this machine can run, the best first.
std::span<const Kernels* const> available() noexcept;

}  // namespace palpate::packed_kernels
