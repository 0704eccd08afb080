// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "palpate/sim/contact/find_candidates.h"
#include "palpate/sim/contact/private/footprint.h"

namespace palpate {

// The footprint of a capsule in a triangle's plane, cut into slices across the axis
// [contact: capsules]: what capsule_footprint.cpp sums over them, or vector code does.

/// Gauss and Legendre on 0 to 1: three points along the axis, four across it.
inline constexpr std::array<double, 3> kSliceNodes = {0.1127016653792583, 0.5, 0.8872983346207417};
inline constexpr std::array<double, 3> kSliceWeights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
inline constexpr std::array<double, 4> kAcrossNodes = {0.0694318442029737, 0.3300094782075719,
                                                       0.6699905217924281, 0.9305681557970263};
inline constexpr std::array<double, 4> kAcrossWeights = {0.1739274225687269, 0.3260725774312731,
                                                         0.3260725774312731, 0.1739274225687269};

/// Cosine below which an axis has no direction along a plane.
inline constexpr double kUpright = 1e-9;

/// The part of a capsule's axis that lies above a plane and within a radius of it: seen from the
/// plane, where s goes along it from the foot of the axis' start, and y beside it.
struct Strip {
  const NearPressure& law;
  double flat = 1.0, rise = 0.0;   ///< of the unit vector along the axis: along the plane, off it
  double height = 0.0;             ///< [m] of its start, which is the lower end
  double first = 0.0, last = 0.0;  ///< [m] along the axis

  double height_at(double along) const noexcept { return height + along * rise; }
};

/// Where the slices are [m], and how wide each is.
struct Slices {
  /// Three in each of the pieces between five kinks; in vector code a multiple of its lanes.
  static constexpr std::size_t kMost = 24;
  alignas(64) std::array<double, kMost> at{};
  alignas(64) std::array<double, kMost> width{};
  std::size_t count = 0;
};

/// Sums over the footprint, in the plane.
struct SliceSums {
  double force = 0.0, stiffness = 0.0, area = 0.0;  ///< [N], [N/m], [m²]
  double along_plane = 0.0, beside = 0.0;           ///< [N m] moments of the pressure
  double aside_along = 0.0, aside = 0.0;            ///< [N] sideways, with the capsule's slope
  double along_axis = 0.0;                          ///< [N m] moment of the places on the axis
  double squared = 0.0;                             ///< [N m²] of their squares
};

/// In the vector code that lanes have; null where they have none.
SumSlices find_slice_sums(const ContactLanes& lanes) noexcept;

/// One of the targets of vector_targets.h; 0 of lanes without vector code.
std::int64_t find_target(const ContactLanes& lanes) noexcept;

}  // namespace palpate
