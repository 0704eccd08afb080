// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "palpate/sim/contact/find_candidates.h"
#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/dynamics/stretch.h"
#include "palpate/sim/tick/scene.h"
#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

struct WorldInternals;

/// A running scene. Everything a tick needs is allocated here, once. In brackets the function of
/// the tick that writes a field (tick.cpp); what only the kernels and their buffers know is hidden.
struct World {
  /// Throws std::invalid_argument for a scene that is not from build_scene.
  explicit World(const Scene& scene);

  std::uint64_t scene_identity = 0;  ///< of the scene that it was made for, and ticks with
  long tick_count = 0;               ///< (tick)
  /// Whether tick() keeps all of tissue, skin and tree up to date. Forces are the same to the bit
  /// without, and a large tissue takes half the time: its packed form is then the truth, and
  /// readers of tissue or skin call catch_up() first (follow_tissue.h). Nothing is ever behind
  /// under another kernel, or where parts of the tissue may sleep.
  bool follows_all = true;

  // the tissue, after every tick, whichever kernel moves it
  State tissue;      ///< (move_tissue, end_moving)
  Vec3Array skin;    ///< [m] the vertices of the skin; empty without one (move_tissue, end_moving)
  AabbTree tree;     ///< where not all is followed, of boxes up to two rounds old (follow_tissue)
  Guard guard;       ///< (end_moving)
  Stretch stretch;   ///< (end_moving)
  int substeps = 0;  ///< (choose_substeps)

  // the tool and the hand
  Vec3 hand = Vec3::Zero();     ///< [m] where the tool is drawn to (follow_hand)
  ToolState tool;               ///< (place_tool, follow_button, balance_tool)
  Candidates candidates;        ///< (find_touchable)
  Load load;                    ///< (balance_tool)
  bool attach_pressed = false;  ///< (follow_button)
  int release_ticks = 0;        ///< until a hold that fades is gone; 0 without (follow_button)
  double release_load = 0.0;    ///< [N] of the fading holds when they began to (follow_button)

  // what the hand feels
  /// The first alarm; from then on the force fades and the tissue stands still (check_input,
  /// end_moving).
  Alarm alarm;
  Vec3 last_force = Vec3::Zero();  ///< [N] of the last tick (tick, fade_out)
  Vec3 fade_from = Vec3::Zero();   ///< [N] the force before the alarm (fade_out)
  int fade_ticks = 0;              ///< since the alarm (fade_out)

 private:
  friend WorldInternals& internals(World& world) noexcept;
  friend const WorldInternals& internals(const World& world) noexcept;

  /// Copied with the world.
  class OwnedInternals {
   public:
    OwnedInternals() noexcept;
    explicit OwnedInternals(const World& world, const Scene& scene);
    OwnedInternals(const OwnedInternals& other);
    OwnedInternals(OwnedInternals&& other) noexcept;
    OwnedInternals& operator=(const OwnedInternals& other);
    OwnedInternals& operator=(OwnedInternals&& other) noexcept;
    ~OwnedInternals();
    WorldInternals& get() const noexcept { return *internals_; }

   private:
    std::unique_ptr<WorldInternals> internals_;
  };
  OwnedInternals internals_;
};
static_assert(alignof(World) == 8);

/// [m] The vertices of the surface: the skin's, or the particles where there is none.
inline std::span<const Vec3> surface_position(const World& world) noexcept {
  return world.skin.empty() ? world.tissue.position : world.skin;
}

}  // namespace palpate
