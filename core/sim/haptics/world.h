// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>

#include "palpate/sim/contact/aabb_tree.h"
#include "palpate/sim/contact/find_candidates.h"
#include "palpate/sim/contact/tree_cost.h"
#include "palpate/sim/dynamics/active_set.h"
#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/dynamics/packed_model.h"
#include "palpate/sim/dynamics/stretch.h"
#include "palpate/sim/haptics/scene.h"

namespace palpate {

/// How far behind the packed tissue is what a world has in double, where World::follows_all is off.
/// A round brings positions and the tree up to date in parts, one in every tick.
struct Lag {
  bool behind = false;         ///< tissue and skin are not all what the last tick has left
  std::size_t next = 0;        ///< part of the round
  double moved = 0.0;          ///< [m] no particle has gone farther since the start
  double at_round = 0.0;       ///< [m] `moved` when this round began
  double at_last_round = 0.0;  ///< [m] when the one before it did, and no box is older
};

/// A running scene. Everything a tick needs is allocated here, once.
struct World {
  explicit World(const Scene& scene);

  std::uint64_t scene_identity = 0;  ///< of the scene that it was made for, and ticks with
  State tissue;                      ///< after every tick, whichever kernel moves it
  Vec3Array skin;  ///< [m] the vertices of the skin, after every tick; empty where there is none
  /// Whether tick() keeps all of tissue, skin and tree up to date. Forces are the same to the bit
  /// without, and a large tissue takes half the time: its packed form is then the truth, and
  /// whoever reads tissue or skin calls catch_up() first (follow_tissue.h). Nothing is ever behind
  /// under another kernel, or where parts of the tissue may sleep.
  bool follows_all = true;
  Lag lag;
  AabbTree tree;  ///< where not all is followed, of boxes as they were up to two rounds ago
  TreeCost tree_cost;
  Candidates candidates;
  ToolState tool;
  Vec3 hand = Vec3::Zero();  ///< [m] where the tool is drawn to: the hand, unless that jumped
  Load load;
  Guard guard;
  Alarm alarm;  ///< the first alarm; from then on the force fades and the tissue stands still
  Vec3 last_force = Vec3::Zero();  ///< [N] of the last tick
  Vec3 fade_from = Vec3::Zero();   ///< [N] the force before the alarm
  int fade_ticks = 0;              ///< since the alarm
  long tick_count = 0;
  int substeps = 0;  ///< of the last tick
  StretchSpectrum spectrum;
  Stretch stretch;                ///< after the last tick
  double chosen_stiffness = 0.0;  ///< [1/s²] largest eigenvalue of M⁻¹K that substeps are for
  bool attach_pressed = false;
  int release_ticks = 0;             ///< left until a hold that fades is gone; 0 when none does
  double release_load = 0.0;         ///< [N] that the holds which fade carried when they began to
  std::vector<double> scratch;       ///< per vertex of the surface
  std::vector<double> surface_mass;  ///< [kg] per vertex of the surface (compute_surface_mass)

  // the packed kernel, where the scene has it and this machine too
  std::shared_ptr<const PackedModel> packed_model;  ///< null under the reference kernel
  PackedState packed;
  PackedMeasure measure;           ///< of the last substep
  std::vector<int> near;           ///< particles the tool may touch in this tick
  int near_count = 0;              ///< how many of them are in force
  std::vector<long> last_near_at;  ///< per particle: the last tick in which it was one of them
  std::vector<int> near_skin;      ///< vertices of the skin likewise
  int near_skin_count = 0;
  std::vector<long> last_skin_near_at;
  std::vector<int> suspects;  ///< work space: triangles that may be near the tool
  std::vector<long>
      last_read_at;        ///< per vertex of the surface: the last tick in which it was one's
  double skin_gain = 1.0;  ///< [-] no vertex of the skin goes farther than a particle times this
  std::shared_ptr<const Response> response;  ///< the scene's, where that kernel runs
  ResponseState answer;
  std::vector<double> deepest;  ///< [m] per vertex of the surface: how far a linear solid may go

  ActiveSet active;                    ///< off where the scene allows no error of the force
  std::vector<unsigned char> in_tree;  ///< per slice: moved in the last tick, and the tree follows

 private:
  void make_near();
};
static_assert(alignof(World) == 8);

/// [m] The vertices of the surface: the skin's, or the particles where there is none.
inline std::span<const Vec3> surface_position(const World& world) noexcept {
  return world.skin.empty() ? world.tissue.position : world.skin;
}

}  // namespace palpate
