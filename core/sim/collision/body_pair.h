// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate {

/// Two bodies that may touch, or one that touches itself where it folds, and the barrier between
/// their surfaces [contact: bodies]. Bodies in no common pair pass through each other.
struct BodyPair {
  int first = 0;   ///< of Scene::bodies
  int second = 1;  ///< another one; the same for a body that may fold
  /// [m] tau: nearer than this, surfaces push each other; build_scene chooses 0.3 to 0.5 mm when 0
  double thickness = 0.0;
  /// [N/m³] k_A: the pressure over the depth in that thickness; build_scene chooses E / (3 tau)
  /// when 0, E of the stiffer body
  double stiffness = 0.0;
  double damping = 0.3;   ///< [-] of critical, of the vertices that touch; 0 to 1
  double friction = 0.0;  ///< [-] Coulomb's coefficient mu between the surfaces; 0: they slide
};

}  // namespace palpate
