// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "palpate/sim/contact/find_candidates.h"
#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/tick/costs.h"
#include "palpate/sim/tick/scene.h"
#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

/// Something that only the functions of a tick know, copied with what owns it.
template <class Hidden>
class Owned {
 public:
  Owned() noexcept;
  explicit Owned(Hidden hidden);
  Owned(const Owned& other);
  Owned(Owned&& other) noexcept;
  Owned& operator=(const Owned& other);
  Owned& operator=(Owned&& other) noexcept;
  ~Owned();
  Hidden& get() const noexcept { return *hidden_; }

 private:
  std::unique_ptr<Hidden> hidden_;
};

struct BodyInternals;
struct TickBuffers;

/// What a body is stepped by where it would blow up without, each beyond the one before [motion:
/// ladder].
enum class Safeguard {
  none,              ///< as the scene says
  half_steps,        ///< of half the length
  quarter_steps,     ///< of a quarter of it
  implicit_damping,  ///< damped by the velocity that a step leads to, as well
  implicit_euler,    ///< by implicit Euler where that is still too long, as well
};

// In brackets the function of the tick that writes a field (tick.cpp).

/// A soft body of a running scene, after every tick, whichever kernel moves it.
struct SoftState {
  SoftState(const Scene& scene, const SoftBody& body);

  State tissue;     ///< (move_tissue, end_moving)
  Vec3Array skin;   ///< [m] the vertices of the skin; empty without one (move_tissue, end_moving)
  AabbTree tree;    ///< where not all is followed, of boxes up to two rounds old (follow_tissue)
  Guard guard;      ///< (end_moving)
  Stretch stretch;  ///< (end_moving)
  int torn_count = 0;  ///< links that have torn since the start [contact: tear] (tear_links)
  Load load;           ///< of the last step: what all instruments do (balance_instruments)
  int substeps = 0;    ///< of the last tick (choose_substeps)
  Safeguard safeguard = Safeguard::none;  ///< of the last tick (calm_down, climb)
  Alarm averted;  ///< the last alarm that a safeguard has averted; none so far (climb)
  /// It has come to rest far from every instrument, and ticks leave it out until one comes near:
  /// no bit of it would change (end_moving, wake_bodies). A program that writes into the tissue
  /// sets this to false.
  bool asleep = false;

 private:
  friend BodyInternals& internals(SoftState& body) noexcept;
  friend const BodyInternals& internals(const SoftState& body) noexcept;
  Owned<BodyInternals> internals_;
};
static_assert(alignof(SoftState) == 8);

/// Where a rigid body is and how it moves, after every tick.
struct RigidState {
  Vec3 position = Vec3::Zero();                     ///< [m] of its frame
  Quaternion orientation = Quaternion::Identity();  ///< [-] of its frame
  Vec3 velocity = Vec3::Zero();                     ///< [m/s]
  Vec3 angular_velocity = Vec3::Zero();             ///< [rad/s]

  // [N] mean of the last tick
  Vec3 tissue_force = Vec3::Zero();      ///< that all tissues push it with
  Vec3 instrument_force = Vec3::Zero();  ///< that all instruments do
};
static_assert(alignof(RigidState) == 8);

/// The hand's spring of an instrument whose device bears less of one than the instrument has
/// [stability: weak coupling].
struct DeviceCoupling {
  /// [N/m] up to which a spring is passive with the device (find_passive_stiffness); 0, or no less
  /// than the instrument's own: all of this stays as it is. For who runs the world to set.
  double passive_stiffness = 0.0;
  /// [s] by which a force is late, T/2 + d: times passive_stiffness the device's damping. Likewise.
  double delay = 0.0;
  double stiffness = 0.0;  ///< [N/m] of the spring in the last tick (choose_coupling)
  double tissue = 0.0;     ///< [N/m] as the contact has shown it to be to the tool (learn_tissue)
  /// 9 `tissue` is above what is passive, so that the spring follows the tissue (choose_coupling)
  bool follows_tissue = false;
  double energy = 0.0;       ///< [J] that a spring may give as it gets stiffer (choose_coupling)
  double way = 0.0;          ///< [m] of the tool against its force, in this touch (learn_tissue)
  double mean_way = 0.0;     ///< [m] lately, as what follows (learn_tissue)
  double mean_force = 0.0;   ///< [N]
  double way_square = 0.0;   ///< [m²] variance
  double way_force = 0.0;    ///< [N m] covariance
  Vec3 tool = Vec3::Zero();  ///< [m] in the last tick (learn_tissue)
};
static_assert(alignof(DeviceCoupling) == 8);

/// An instrument of a running scene, and the hand that moves it.
struct InstrumentState {
  Vec3 hand = Vec3::Zero();     ///< [m] where the tool is drawn to (read_hands)
  ToolState tool;               ///< (read_hands, follow_button, balance_instruments)
  bool attach_pressed = false;  ///< (follow_button)
  bool opens = false;           ///< its jaws open by themselves, until the hand has (follow_jaws)
  int release_ticks = 0;        ///< until a hold that fades is gone; 0 without (follow_button)
  double release_load = 0.0;    ///< [N] of the fading holds when they began to (follow_button)
  Vec3 last_force = Vec3::Zero();  ///< [N] of the last tick (tick, fade_out)
  Vec3 fade_from = Vec3::Zero();   ///< [N] the force before the alarm (fade_out)
  DeviceCoupling device = {};      ///< off unless its device needs it
};
static_assert(alignof(InstrumentState) == 8);

/// What an instrument may touch of a body, and what it does to it.
struct ContactPair {
  Candidates candidates;  ///< (find_touchable)
  Load load;  ///< of the last substep; the body's own has its gravity (balance_instruments)
};

/// How two bodies of a running scene touch, after every tick.
struct BodyPairState {
  bool near = false;  ///< some of their surfaces may come to touch (meet_bodies)
  int touching =
      0;  ///< vertices and middles of edges that touch, in the last substep (touch_bodies)
  /// [m] between the surfaces where they were nearest in the last tick, below 0 inside of each
  /// other; infinite where nothing was within the thickness (touch_bodies)
  double least_gap = std::numeric_limits<double>::infinity();
  /// [N] on the second body, mean of the last tick; 0 of a body with itself (touch_bodies)
  Vec3 force = Vec3::Zero();
};
static_assert(alignof(BodyPairState) == 8);

/// How a body of a running scene stops at a scenery, after every tick.
struct SceneryContact {
  int scenery = 0;            ///< of Scene::scenery
  int body = 0;               ///< of Scene::bodies
  bool near = false;          ///< some of their surfaces may come to touch (meet_scenery)
  int touching = 0;           ///< vertices on it, in the body's last step (stop_at_scenery)
  Vec3 force = Vec3::Zero();  ///< [N] on the body, mean of the last tick (stop_at_scenery)
};
static_assert(alignof(SceneryContact) == 8);

/// A running scene. Everything a tick needs is allocated here, once.
struct World {
  /// Throws std::invalid_argument for a scene that is not from build_scene.
  explicit World(const Scene& scene);

  std::uint64_t scene_identity = 0;  ///< of the scene that it was made for, and ticks with
  long tick_count = 0;               ///< (tick)
  /// Whether tick() keeps all of tissues, skins and trees up to date. Forces are the same to the
  /// bit without, and a large tissue takes half the time: its packed form is then the truth, and
  /// readers of tissue or skin call catch_up() first (follow_tissue.h). Nothing is ever behind
  /// under another kernel, or where parts of the tissue may sleep.
  bool follows_all = true;

  /// Whether tick() keeps `costs`. Forces are the same to the bit with and without, and a tick
  /// takes some microseconds more.
  bool measures_costs = false;
  TickCosts costs;  ///< of the last tick (each stage its own)

  /// Whether a tick in which a body blows up is done again, from where it began, under the body's
  /// next safeguard, before its alarm stands. What judges a scene as it is sets this to false.
  bool recovers = true;

  std::vector<SoftState> bodies;             ///< as Scene::bodies
  std::vector<RigidState> rigid;             ///< as Scene::rigid
  std::vector<InstrumentState> instruments;  ///< as Scene::instruments
  std::vector<ContactPair> pairs;            ///< every instrument with every body: pair()
  std::vector<BodyPairState> body_pairs;     ///< as Scene::body_pairs
  /// As Scene::scenery, one for each body that it lists.
  std::vector<SceneryContact> scenery_contacts;

  /// The first alarm; from then on forces fade and all tissue stands still (check_input,
  /// end_moving).
  Alarm alarm;
  int alarm_body = -1;  ///< whose tissue raised it; -1 for what is of no body
  int fade_ticks = 0;   ///< since the alarm (fade_out)

  ContactPair& pair(std::size_t instrument, std::size_t body) noexcept {
    return pairs[instrument * bodies.size() + body];
  }
  const ContactPair& pair(std::size_t instrument, std::size_t body) const noexcept {
    return pairs[instrument * bodies.size() + body];
  }

 private:
  friend TickBuffers& workspace(World& world) noexcept;
  Owned<TickBuffers> workspace_;
};
static_assert(alignof(World) == 8);

/// [m] The vertices of the surface: the skin's, or the particles where there is none.
inline std::span<const Vec3> surface_position(const SoftState& body) noexcept {
  return body.skin.empty() ? body.tissue.position : body.skin;
}

}  // namespace palpate
