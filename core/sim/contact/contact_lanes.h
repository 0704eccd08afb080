// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "palpate/sim/base/cache_aligned.h"
#include "palpate/sim/base/types.h"

namespace palpate {

/// The contacts of a tip with many triangles at once, in vector code: the law of find_contact
/// (contact_law.h), in double. Columns hold one number per lane.
struct ContactLanes {
  ContactLanes() = default;
  /// Room for `capacity` triangles, for one of simd_targets(); empty for the best.
  ContactLanes(int capacity, std::string_view target);

  using Column = CacheAligned<double>;
  using Find = void (*)(ContactLanes& lanes, double radius, double stiffness) noexcept;

  Find find = nullptr;  ///< null without vector code
  int width = 1;        ///< lanes of a vector: columns are filled up to a multiple of it
  int count = 0;        ///< lanes that hold a triangle
  std::vector<int> triangle;
  std::array<Column, 9> corners;  ///< [m] x, y, z of the first corner, of the second, of the third
  Column rest_area;               ///< [m²]
  Vec3 filled_at = Vec3::Zero();  ///< [m] all that lies within `reach` of this point is here
  double reach = -1.0;            ///< [m]
  Vec3 centre = Vec3::Zero();     ///< [m] of the tip
  bool found = false;             ///< what follows is that of `centre`

  std::array<Column, 3> weights;    ///< barycentric, of the closest points
  std::array<Column, 3> direction;  ///< unit, from there to the centre
  Column distance;                  ///< [m] between the two
  Column force;                     ///< [N], 0 where there is no contact
  Column stiffness;                 ///< [N/m]
};
static_assert(alignof(ContactLanes) == 8);

}  // namespace palpate
