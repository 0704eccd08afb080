// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "palpate/sim/collision/private/pull_bristle.h"
#include "palpate/sim/model/load.h"
#include "palpate/sim/tick/private/rigid_motion.h"
#include "palpate/sim/tick/world.h"

namespace palpate {

/// Where a sphere sticks: a point of its body, and one of what it is on, drawn together along the
/// surface by a spring that slips at mu times what presses there [contact: rigid].
struct Bristle {
  bool holds = false;
  Vec3 place = Vec3::Zero();  ///< [m] in the body's frame
  Vec3 other = Vec3::Zero();  ///< [m] in the scene's frame, or the other body's; weights in tissue
  int triangle = 0;           ///< of tissue
};

/// The triangles that the spheres of a body may touch in a tick, one list after the other.
struct SphereLists {
  bool near = false;             ///< (meet_rigid)
  std::vector<int> triangles;    ///< room for a query
  std::vector<std::size_t> end;  ///< per sphere
  std::size_t first_bristle = 0;

  std::span<const int> of(std::size_t sphere) const noexcept {
    const std::size_t begin = sphere == 0 ? 0 : end[sphere - 1];
    return std::span(triangles).subspan(begin, end[sphere] - begin);
  }
};

/// A rigid body in a tick.
struct MovedBody {
  MovedMass moved;             ///< (begin_rigid)
  double volume = 0.0;         ///< [m³] never changes
  double reach = 0.0;          ///< [m] of its spheres from its centre; never changes
  double stiffness = 0.0;      ///< [N/m] of all that it may touch (find_rigid_contacts)
  int contacts = 0;            ///< in this substep (touch_rigid)
  int last_contacts = 0;       ///< in the one before (touch_rigid)
  Vec3Array centre;            ///< [m] of its spheres (place_rigid)
  Wrench wrench;               ///< (touch_rigid)
  double stored_energy = 0.0;  ///< [J] no less than its contacts hold (touch_rigid)
};

/// What a tick knows of rigid bodies.
struct RigidContacts {
  std::vector<MovedBody> bodies;        ///< as Scene::rigid
  std::vector<SphereLists> on_tissue;   ///< every rigid body with every soft one
  std::vector<SphereLists> on_scenery;  ///< with every scenery
  std::vector<std::size_t> first_pair;  ///< bristle of every rigid body with every other
  std::vector<Bristle> bristles;        ///< of all; from tick to tick (touch_rigid)
  std::vector<Load> loads;              ///< per soft body (touch_rigid)
  std::vector<double> row;              ///< [1/s²] per soft body, of M⁻¹K at most
  std::vector<RigidState> kept_states;  ///< (keep_checkpoint)
  std::vector<Bristle> kept_bristles;   ///< likewise
};

/// So many pushes a sphere gives to a tissue at most.
inline constexpr std::size_t kMostSpherePushes = 64;

}  // namespace palpate
