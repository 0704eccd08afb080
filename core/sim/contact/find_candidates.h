// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "palpate/sim/base/types.h"
#include "palpate/sim/contact/tool.h"
#include "palpate/sim/tree/aabb_tree.h"

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

/// Triangles the tool may touch during one tick, ascending, with the area of each [m²].
struct Candidates {
  explicit Candidates(int capacity = 0)
      : triangles(static_cast<std::size_t>(capacity)), areas(static_cast<std::size_t>(capacity)) {}

  std::vector<int> triangles;  ///< capacity; the triangle count of the tissue is always enough
  std::vector<double> areas;   ///< [m²] at rest, so that pressing does not change the law
  int count = 0;
  Vec3 from = Vec3::Zero();  ///< [m] the path they were looked for along
  Vec3 to = Vec3::Zero();    ///< [m]
  ContactLanes lanes;        ///< balance_tool's vector code and its work space; may be empty
};
static_assert(alignof(Candidates) == 8);

/// How far tissue and tool may close in on each other within one tick beside the tool's own path
/// [m].
inline constexpr double kCandidateMargin = 1.2e-3;

/// Finds every triangle within radius + kCandidateMargin of the path from the tool's last position
/// to where the hand is now. Once per tick; the contacts themselves are found in every substep.
/// `rest_areas` [m²] per triangle of the tissue.
void find_candidates(const AabbTree& tree, std::span<const Vec3> x, const Tool& tool,
                     const Vec3& tool_position, const Vec3& hand_position,
                     std::span<const double> rest_areas, Candidates& candidates) noexcept;

}  // namespace palpate
