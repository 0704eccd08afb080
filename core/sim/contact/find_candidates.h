// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "palpate/sim/base/types.h"
#include "palpate/sim/contact/tool.h"
#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

/// How the tip touches one triangle.
struct Contact {
  Vec3 weights = Vec3::Zero();    ///< barycentric, of the closest point
  Vec3 direction = Vec3::Zero();  ///< unit, from the closest point to the tool's centre
  double distance = 0.0;          ///< [m] between the two
  double force = 0.0;             ///< [N] along direction on the tool, against it on the tissue
  double stiffness = 0.0;         ///< [N/m] d force / d depth
};
static_assert(sizeof(Contact) == 72 && alignof(Contact) == 8);

/// The contacts of a tip with many triangles at once, in vector code: the law of find_contact
/// (contact_law.h), in double. Columns hold one number per lane.
struct ContactLanes {
  ContactLanes() = default;
  /// Room for `capacity` triangles, for one of simd_targets(); empty for the best.
  /// With capsules, each triangle has a lane for each of them.
  ContactLanes(int capacity, std::string_view target, int capsules = 0);

  using Column = CacheAligned<double>;
  using Find = void (*)(ContactLanes& lanes, double radius, double stiffness) noexcept;

  Find find = nullptr;  ///< null without vector code
  Find find_capsules = nullptr;
  Find find_jaws = nullptr;  ///< capsules with contacts that are spread [contact: spread]
  int width = 1;             ///< lanes of a vector: columns are filled up to a multiple of it
  int count = 0;             ///< lanes that hold a triangle
  std::vector<int> triangle;
  std::array<Column, 9> corners;  ///< [m] x, y, z of the first corner, of the second, of the third
  Column rest_area;               ///< [m²]
  std::vector<int> capsule;       ///< which of the tool's, empty of a ball
  std::array<Column, 6> axis;     ///< [m] its ends off the tool's position, likewise
  Vec3 filled_at = Vec3::Zero();  ///< [m] all that lies within `reach` of this point is here
  double reach = -1.0;            ///< [m]
  std::vector<unsigned char> border;  ///< as Candidates::border; empty where that is
  double side = 1.0;                  ///< [-] -1 where triangles are touched from behind
  Vec3 centre = Vec3::Zero();         ///< [m] of the tip
  bool found = false;                 ///< what follows is that of `centre`

  std::array<Column, 3> weights;    ///< barycentric, of the closest points
  std::array<Column, 3> direction;  ///< unit, from there to the centre
  Column distance;                  ///< [m] between the two
  Column force;                     ///< [N], 0 where there is no contact
  Column stiffness;                 ///< [N/m]
};
static_assert(alignof(ContactLanes) == 8);

/// What a tool that holds on to tissue has taken over of the pressures it held when it took hold.
struct Grip {
  double force = 0.0;          ///< [N] of those pressures; 0 where nothing is held
  double share = 1.0;          ///< [-] of `force` over their sum as vectors
  Vec3 normal = Vec3::Zero();  ///< unit, of that sum
  double pushed = 0.0;         ///< [N] what the holds push with in place of them, at `place`
  double stiffness = 0.0;      ///< [N/m] by which that falls as the tool goes up
  Vec3 place = Vec3::Zero();   ///< [m] of the tool

  /// [N] of the holds with the tool at p.
  double find_push(const Vec3& p) const noexcept {
    return pushed - stiffness * normal.dot(p - place);
  }
};

/// What goes on from one substep to the next of contacts with one surface: where that is open, the
/// side by which it is touched; all else of contacts under a NearField.
struct NearMemory {
  double side = 1.0;              ///< [-] -1 behind an open one, 0 not known (border.cpp)
  Vec3 centre = Vec3::Zero();     ///< [m] of the tip, lifted
  bool found = false;             ///< all contacts are those of `centre`
  Vec3 lift = Vec3::Zero();       ///< [m] of the tip off the triangles: what they lack of the dent
  Vec3 next_lift = Vec3::Zero();  ///< [m] in the next substep
  double mesh_compliance = 0.0;   ///< [m/N] of the patch under the tip, beyond the far field's
  Vec3 tilt = Vec3::Zero();       ///< [1/N] how the mesh turns the normal of the patch
  bool knows_compliance = false;  ///< in this tick
  double gain = 1.0;              ///< [-] force over that of the pressures alone
  double stiffening = 1.0;        ///< [-] its slope over theirs
  Vec3 push = Vec3::Zero();       ///< [N] of the pressures on the tool, as a vector
  double local_slope = 0.0;       ///< [N/m] of the half space that they are those of
  Grip grip;                      ///< what holds have taken over of them

  // of the patch in all, as other instruments see it
  double force = 0.0;           ///< [N] of the pressures, 0 where nothing is touched
  Vec3 middle = Vec3::Zero();   ///< [m] of pressure
  Vec3 normal = Vec3::Zero();   ///< unit
  double far_compliance = 0.0;  ///< [m/N] of the body beyond that of a half space
};
static_assert(alignof(NearMemory) == 8);

/// Contacts under the law of a NearField (contact_law.h), and work space for them.
struct NearContacts : NearMemory {
  NearContacts() = default;
  /// Room for so many triangles, of a surface with so many vertices, which so many other
  /// instruments may touch.
  NearContacts(int triangles, int vertices, int others = 0);

  std::vector<int> triangle;
  std::vector<Contact> closest;  ///< the contact that the hard law would have
  std::vector<Contact> contact;  ///< with the distance of the closest point
  int count = 0;
  std::vector<double> weight;  ///< (n,) per vertex, 0 between calls
  std::vector<double> cross;   ///< [m/N] of each other's press here that the mesh has not
};

/// Triangles the tool may touch during one tick, ascending, with the area of each [m²].
struct Candidates {
  /// With capsules, the list has room for what is near to each of them.
  explicit Candidates(int capacity = 0, int capsules = 0)
      : triangles(static_cast<std::size_t>(capacity) *
                  static_cast<std::size_t>(std::max(1, capsules))),
        areas(triangles.size()) {}

  std::vector<int> triangles;  ///< capacity; the triangle count of the tissue is always enough
  std::vector<double> areas;   ///< [m²] at rest, so that pressing does not change the law
  int count = 0;
  /// Per triangle of an open surface: bit k where the edge opposite corner k is a border of it.
  /// Empty of a closed surface.
  std::vector<unsigned char> border;
  bool at_border = false;    ///< a triangle of the list has part in the border
  Vec3 from = Vec3::Zero();  ///< [m] the path they were looked for along
  Vec3 to = Vec3::Zero();    ///< [m]
  ContactLanes lanes;        ///< balance_tool's vector code and its work space; may be empty
  NearContacts near;         ///< balance_tool's, with a NearField; may be empty without one
};
static_assert(alignof(Candidates) == 8);

/// How far tissue and tool may close in on each other within one tick beside the tool's own path
/// [m].
inline constexpr double kCandidateMargin = 1.2e-3;

/// Finds every triangle within radius + kCandidateMargin of the path of the tool from its last
/// position to where the hand is now, turned as it is, with jaws open by `jaw_angle` [rad]. Once
/// per tick; the contacts themselves are found in every substep. `rest_areas` [m²] per triangle of
/// the tissue.
void find_candidates(const AabbTree& tree, std::span<const Vec3> x, const Tool& tool,
                     const Vec3& tool_position, const Vec3& hand_position,
                     std::span<const double> rest_areas, Candidates& candidates,
                     const Quaternion& orientation = Quaternion::Identity(),
                     double jaw_angle = 0.0) noexcept;

}  // namespace palpate
