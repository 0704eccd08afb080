// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/packed/private/packed_model.h"

namespace palpate::packed_kernels {

/// Variables of a law's own, as its kernel lays them out.
using Internal = CacheAligned<float>;

/// A law in packed form.
struct PackedLaw {
  bool (*is_present)(const PackedModel& model) noexcept = nullptr;
  /// Adds its forces to the force rows; to `measure` their energy, unless it is null.
  void (*accumulate)(const PackedModel& model, PackedState& state, Internal& internal,
                     PackedMeasure* measure) noexcept = nullptr;
  /// How many variables it has; null for none.
  std::size_t (*count_internal)(const PackedModel& model) noexcept = nullptr;
};

/// The kernels compiled for one vector target. Each works on models of its own width.
struct Kernels {
  const char* target = nullptr;
  int width = 0;  ///< lanes
  /// All but springs and home springs, which advance() adds.
  std::span<const PackedLaw> laws;
  /// Adds the forces of the pressure to the force rows.
  void (*accumulate_pressure)(const PackedModel& model, PackedState& state) noexcept = nullptr;
  /// Adds links, home springs, gravity [m/s²], drag and the force rows, moves every particle by
  /// one step of dt [s] into the other tables of rows, and leaves the force rows zero. The first
  /// step after a check keeps where all was. Adds to `measure` the energies of all these, and how
  /// far all has gone since, unless it is null.
  void (*advance)(const PackedModel& model, const Eigen::Vector3f& gravity, float dt,
                  PackedState& state, PackedMeasure* measure) noexcept = nullptr;
  /// [J] done by the pressure since the last check, for a model that has one.
  double (*compute_pressure_work)(const PackedModel& model,
                                  const PackedState& state) noexcept = nullptr;
  /// Writes `values`, laid out as PackedState::displacement, of every particle of these slices in
  /// double, added to what stands at `from`; unless that is null.
  void (*unpack)(const PackedModel& model, const Vec3* from, const float* values,
                 std::span<const int> slices, Vec3* to) noexcept = nullptr;
  /// Says of each slice that moves whether a particle in it has moved: whether it is more than
  /// `least` [m] from where `anchor` has it, and that distance, times the longer of it and the
  /// distance from where `still` has it, is more than `product_limit` [m²].
  void (*find_moved)(const PackedModel& model, float least, float product_limit,
                     const float* anchor, const float* still, const PackedState& state,
                     unsigned char* moved) noexcept = nullptr;
};

/// Those this machine can run, the best first.
std::span<const Kernels* const> available() noexcept;

}  // namespace palpate::packed_kernels
