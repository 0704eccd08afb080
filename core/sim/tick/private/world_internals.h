// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "palpate/sim/collision/private/edge_points.h"
#include "palpate/sim/contact/private/touched_surface.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/grasp/private/tear.h"
#include "palpate/sim/model/private/mean_load.h"
#include "palpate/sim/packed/private/active_set.h"
#include "palpate/sim/packed/private/packed_checkpoint.h"
#include "palpate/sim/packed/private/packed_model.h"
#include "palpate/sim/tick/private/rigid_contacts.h"
#include "palpate/sim/tick/world.h"
#include "palpate/sim/tree/aabb_tree.h"

namespace palpate {

class StiffPart;

/// [m/s²] that acts on a body: the scene's, or none [motion: weight].
inline Vec3 find_gravity(const Scene& scene, const SoftBody& body) noexcept {
  return body.weightless ? Vec3::Zero() : scene.gravity;
}

/// What the tools may touch in a tick: particles, and vertices of a skin that rides on them. Only
/// these are brought up to date between the substeps.
struct NearList {
  NearList() = default;
  NearList(const TissueModel& tissue);

  void clear() noexcept { particle_count = skin_count = 0; }
  std::span<const int> particles_in_use() const noexcept {
    return std::span(particles).first(static_cast<std::size_t>(particle_count));
  }
  std::span<const int> skin_in_use() const noexcept {
    return std::span(skin).first(static_cast<std::size_t>(skin_count));
  }

  std::vector<int> particles, skin;
  int particle_count = 0, skin_count = 0;  ///< how many of them are in use
  /// The last tick in which each was listed.
  std::vector<long> particle_last_at, skin_last_at, triangle_last_at;
};

/// How far behind the packed tissue is what a world has in double, where World::follows_all is off.
/// A round brings positions and the tree up to date in parts, one in every tick.
struct Lag {
  bool behind = false;         ///< tissue and skin are not all what the last tick has left
  std::size_t next = 0;        ///< part of the round
  double moved = 0.0;          ///< [m] no particle has gone farther since the start
  double at_round = 0.0;       ///< [m] `moved` when this round began
  double at_last_round = 0.0;  ///< [m] when the one before it did, and no box is older
};

/// An implicit stepper of one world alone: a copy of that world makes its own in its next step.
struct OwnStepper {
  OwnStepper() = default;
  OwnStepper(const OwnStepper&) noexcept {}
  OwnStepper(OwnStepper&&) noexcept = default;
  OwnStepper& operator=(const OwnStepper&) noexcept {
    stepper.reset();
    return *this;
  }
  OwnStepper& operator=(OwnStepper&&) noexcept = default;

  std::unique_ptr<ImplicitStepper> stepper;
  const TissueModel* model = nullptr;  ///< that it was made for
};

/// The plain laws in double, on SoftState::tissue itself.
struct ReferenceKernel {
  OwnStepper implicit;    ///< empty under an explicit integrator (move_tissue)
  bool unsolved = false;  ///< a step found no solution, and later ones were left out (move_tissue)
};

/// The same laws in float, in vector code. Between the substeps its own state is the truth, and
/// SoftState::tissue is up to date where a tool may touch it.
struct PackedKernel {
  PackedKernel(const Scene& scene, const SoftBody& body, const SoftState& state);

  std::shared_ptr<const PackedModel> model;
  PackedState state;                   ///< (move_tissue)
  PackedMeasure measure;               ///< of the last substep (move_tissue)
  NearList near;                       ///< (begin_moving)
  bool began_still = false;            ///< nothing of it moves in this tick (begin_moving)
  Lag lag;                             ///< (follow_tissue, end_moving)
  ActiveSet active;                    ///< off unless force_error allows (begin, end_moving)
  std::vector<unsigned char> in_tree;  ///< per slice: moves, and the tree follows (begin_moving)
  std::vector<int> broad_candidates;   ///< triangles of boxes near the tool (find_touchable)
  std::vector<long> last_read_at;      ///< tick, per vertex of the surface (find_touchable)
  double skin_gain = 1.0;  ///< [-] no vertex of the skin goes farther than a particle times this
};

/// A linear solid, which its precomputed response moves.
struct ResponseKernel {
  ResponseKernel(const SoftBody& body, const AabbTree& tree);

  std::shared_ptr<const Response> response;
  ResponseState state;          ///< (move_tissue)
  NearList near;                ///< (begin_moving)
  std::vector<double> deepest;  ///< [m] per vertex of the surface: how far it may be moved
};

using TissueKernel = std::variant<ReferenceKernel, PackedKernel, ResponseKernel>;

/// What a tick changes of a body, as it was before the first substep (checkpoint.h).
struct BodyCheckpoint {
  BodyCheckpoint(const TissueKernel& kernel, const SoftState& state);

  long tick = 0;  ///< its number, as World::tick_count

  // of the kernel that moves it; the others are empty
  Vec3Array position, velocity;  ///< [m], [m/s]
  std::vector<double> internal;  ///< as State::internal
  PackedCheckpoint packed;
  CacheAligned<float> displacement;  ///< [m] as ResponseState::displacement
  double time = 0.0;                 ///< [s]
  Lag lag;
  // of its guard
  double last_time = 0.0, last_energy = 0.0, work = 0.0, given_energy = 0.0, reference_energy = 0.0;
  int rising_steps = 0, strained_checks = 0;
};

/// Where a body stands on the ladder of safeguards (safeguard.h).
struct Calm {
  double since = 0.0;      ///< [s] that the safeguard is what it is
  double needed = 0.0;     ///< [s] after which the next one below is tried
  bool climbed = false;    ///< in this tick
  bool went_back = false;  ///< this tick began where the one before it did
};

/// Whether a body may sleep, and as what (sleep.h).
struct Rest {
  bool at_any_step = false;     ///< not a particle of it moves, however long a step is (end_moving)
  double step = 0.0;            ///< [s] with which a tick left every bit as it was (end_moving)
  int substeps = 0;             ///< of that tick (end_moving)
  Vec3 gravity = Vec3::Zero();  ///< [m/s²] with which it did (end_moving)
  int patience = 0;             ///< ticks until it is tried again (end_moving)
  bool is_tried = false;        ///< `copy` is of the tick before (end_moving)
  bool has_copy = false;        ///< `copy` is of a tick since which it has been calm (end_moving)
  std::vector<std::byte> copy;  ///< of all that a step reads and writes (end_moving)
};

/// What implicit Euler moves of a body in one tick (safeguard.h).
struct StiffSteps {
  std::shared_ptr<StiffPart> part;  ///< none where there was no memory for it (choose_stiff_parts)
  bool unsolved = false;  ///< it found no solution, or needs too many particles (step_stiff_part)
};

/// What stands behind a SoftState: the kernel that moves its tissue, and buffers.
struct BodyInternals {
  BodyInternals(const Scene& scene, const SoftBody& body, const SoftState& state);

  TissueKernel kernel;
  std::array<BodyCheckpoint, 2> checkpoints;  ///< of this tick and the last (keep_checkpoint)
  int latest = 0;                             ///< which of them is of this tick (keep_checkpoint)
  Calm calm;                                  ///< (calm_down, climb)
  Rest rest;
  TreeCost tree_cost;              ///< (follow_tissue)
  StretchSpectrum spectrum;        ///< never changes
  double chosen_stiffness;         ///< [1/s²] largest eigenvalue of M⁻¹K (choose_substeps)
  bool meets = false;              ///< another body is near, or it may fold (meet_bodies)
  int wanted_substeps;             ///< before those of all bodies were fitted (choose_substeps)
  double contact_stiffness = 0.0;  ///< [1/s²] that contacts add to it at most (choose_substeps)
  double volume_before = 1.0;  ///< [-] Stretch::smallest_volume a tick earlier (choose_substeps)
  StiffSteps stiff;            ///< under Safeguard::implicit_euler
  std::vector<double> surface_mass;    ///< [kg] per vertex of the surface; never changes
  std::vector<double> vertex_scratch;  ///< per vertex of the surface; zero between its uses
  Tear tear;                           ///< off unless the body may tear (begin_moving, tear_links)
  MeanLoad mean_load;  ///< over the substeps of a finer body since the last step (move_bodies)
};

inline BodyInternals& internals(SoftState& body) noexcept { return body.internals_.get(); }
inline const BodyInternals& internals(const SoftState& body) noexcept {
  return body.internals_.get();
}

/// The packed kernel of a body, null under another.
inline PackedKernel* find_packed(SoftState& body) noexcept {
  return std::get_if<PackedKernel>(&internals(body).kernel);
}
inline const PackedKernel* find_packed(const SoftState& body) noexcept {
  return std::get_if<PackedKernel>(&internals(body).kernel);
}

/// The response kernel of a body, null under another.
inline const ResponseKernel* find_response(const SoftState& body) noexcept {
  return std::get_if<ResponseKernel>(&internals(body).kernel);
}

/// [-] The smallest volume so many ticks on, as fast as it shrinks.
inline double foresee_volume(double ticks, const SoftState& state) noexcept {
  const double now = state.stretch.smallest_volume;
  return now + std::min(0.0, now - internals(state).volume_before) * ticks;
}

/// Turns a tool of capsules as its hand is turned, or about its trocar; a ball has no directions.
/// One that touches does not follow at once [contact: capsules], and one whose hand tissue limits
/// to `bearable` [N] turns against it with no more than that has about its far end.
void turn_tool(const Instrument& instrument, const Quaternion& hand, double dt, double bearable,
               ToolState& state) noexcept;

/// [m] Of the tips of all instruments.
double find_smallest_radius(const Scene& scene) noexcept;
double find_largest_radius(const Scene& scene) noexcept;

/// What one tick knows of a hand.
struct HandMotion {
  Vec3 hand = Vec3::Zero();  ///< [m] where it is now (read_hands)
  double travel = 0.0;       ///< [m] since the last tick; 0 where it has just appeared (read_hands)
  double stored_energy = 0.0;  ///< [J] no less than its springs hold (read_hands)
  Vec3 felt = Vec3::Zero();    ///< [N] sum over substeps (balance_instruments)
  /// [N] by no more does what is felt of closed jaws fall in this tick; 0: by any (follow_jaws)
  double most_fall = 0.0;
  /// [N] that its spring pulls with at most, where tissue bears no more; from tick to tick
  /// (limit_hand)
  double bearable = std::numeric_limits<double>::infinity();
};

/// What the substeps of a tick change of an instrument, as it was before them.
struct InstrumentCheckpoint {
  Vec3 position = Vec3::Zero();  ///< [m] of the tool
  ToolState::Carrier carrier;
  bool touching = false;
  Vec3 residual = Vec3::Zero();              ///< [N]
  std::vector<ToolState::PatchPoint> patch;  ///< as ToolState::patch, with its capacity
  int patch_count = 0;                       ///< likewise
  Vec3 patch_position = Vec3::Zero();        ///< [m]
  Vec3 patch_normal = Vec3::Zero();          ///< unit
  Vec3 friction = Vec3::Zero();              ///< [N]
  double jaw_angle = 0.0;                    ///< [rad]
  std::vector<ToolState::Anchor> anchors;    ///< as ToolState::anchors, with its capacity
  int anchor_count = 0;                      ///< likewise
};

/// What an instrument may touch of a hard surface, and what it does to it.
struct HardPair {
  std::array<Candidates, 2> candidates;  ///< of the tool, or of each jaw (find_touchable_hard)
  Load load;                             ///< of the last substep (balance_instruments)
  std::vector<double> areas;  ///< [m²] per triangle, as stiff as what is hard; never changes
};

/// What may touch of two bodies, or of one with itself.
struct BodyContacts {
  std::array<std::size_t, 2> bodies = {};  ///< of World::bodies; never change
  std::array<SurfaceContacts, 2> sides;  ///< vertices of the first on the second, and of it on that
  std::size_t side_count = 0;            ///< 1 of a body with itself
  std::array<EdgePoints, 2> edges;       ///< likewise middles of long edges; none with itself
  double apart = 0.0;          ///< [m] beyond the thickness, where they are not near (meet_bodies)
  double stored_energy = 0.0;  ///< [J] in the barrier, at the first substep (touch_bodies)
};

/// How often a tick looks at what bodies may touch. Where surfaces go far in a tick, once is not
/// enough [contact: bodies].
struct ContactPace {
  bool within = false;  ///< it looks again within the tick (find_body_contacts, look_more_often)
  bool outrun = false;  ///< surfaces went farther than what was found bears (touch_bodies)
  double hold = 0.0;    ///< [s] that what was found holds
  double since = 0.0;   ///< [s] since it was found
};

/// What is no tissue, as instruments touch it: a scenery, or the mesh of a rigid body.
struct HardSurface {
  explicit HardSurface(const SurfaceMesh& mesh) : x(mesh.vertices), tree(x, mesh.triangles) {}

  Vec3Array x;  ///< [m] (move_rigid)
  AabbTree tree;
};

/// What may come to touch of a body and a scenery that stops it.
struct StopContacts {
  SurfaceContacts on_scenery;  ///< vertices of the body
  SurfaceContacts on_body;     ///< vertices of the scenery
};

/// A body that a scenery may stop.
struct StoppedBody {
  SurfaceMotion motion;
  std::vector<double> inverse_mass;  ///< [1/kg] per particle, 0 of what is held; never changes
};

/// Buffers that live for one tick.
struct TickBuffers {
  explicit TickBuffers(const World& world);

  std::vector<InstrumentCheckpoint> instruments;  ///< (keep_checkpoint)
  std::vector<NearMemory> near;                   ///< per pair (keep_checkpoint)
  std::vector<Candidates> second;                 ///< per pair, of the second jaw (find_touchable)
  std::vector<NearMemory> second_near;            ///< per pair, likewise (keep_checkpoint)
  std::vector<HandMotion> hands;                  ///< per instrument
  std::vector<TouchedSurface> surfaces;           ///< per body, of one instrument (list_surfaces)
  std::vector<TouchedSurface> second_surfaces;    ///< likewise (list_jaw_surfaces)
  std::vector<const NearContacts*> others;        ///< per body, those of the others (list_surfaces)
  std::vector<double> work;                       ///< [J] per body, of the pushes (move_bodies)
  std::vector<int> wanted;                        ///< substeps per body (choose_substeps)
  std::vector<double> cost;            ///< of a substep of each, relative (choose_substeps)
  std::vector<BodyContacts> contacts;  ///< as Scene::body_pairs
  std::vector<SurfaceTouch> touched;   ///< per body; none without body_pairs
  ContactPace pace;
  std::vector<StopContacts> stops;   ///< as World::scenery_contacts
  std::vector<StoppedBody> stopped;  ///< per body; none without scenery_contacts
  std::vector<HardSurface> hard;     ///< every scenery, then every rigid body
  std::vector<HardPair> hard_pairs;  ///< every instrument with every one of these
  RigidContacts rigid;
};

inline TickBuffers& workspace(World& world) noexcept { return world.workspace_.get(); }

/// What the second jaw of an instrument may touch of a body; ContactPair::candidates are the
/// first's.
inline Candidates& second_jaw(World& world, std::size_t instrument, std::size_t body) noexcept {
  return workspace(world).second[instrument * world.bodies.size() + body];
}

/// Calls `visit` with every triangle of a body that an instrument may touch in this tick, with each
/// of its jaws, or that follows it.
template <class Visit>
void for_each_touchable(World& world, std::size_t instrument, std::size_t body, Visit visit) {
  const Candidates* parts[] = {&world.pair(instrument, body).candidates,
                               &second_jaw(world, instrument, body)};
  for (const Candidates* part : parts) {
    for (int c = 0; c < part->count; ++c) visit(part->triangles[static_cast<std::size_t>(c)]);
  }
  const ToolState& tool = world.instruments[instrument].tool;
  const auto index = static_cast<int>(body);
  for (int k = 0; k < tool.anchor_count; ++k) {
    const ToolState::Anchor& anchor = tool.anchors[static_cast<std::size_t>(k)];
    if (anchor.body == index) visit(anchor.triangle);
  }
  for (int h = 0; h < tool.hold_count; ++h) {
    const ToolState::Hold& hold = tool.holds[static_cast<std::size_t>(h)];
    if (hold.body == index) visit(hold.triangle);
  }
}

/// Springs, bonds and prisms of a surface; what has tetrahedra is a solid.
inline bool is_wall(const TissueModel& tissue) noexcept {
  return tissue.volumes.corners.empty() && tissue.elastic.corners.empty() &&
         tissue.corotated.corners.empty() && tissue.neo_hookean.corners.empty();
}

/// [-] Coulomb's coefficient of an instrument with one of the scene's surfaces, counted as
/// Instrument::pair_friction is, over its tool's own.
inline double find_friction_part(const Instrument& instrument, std::size_t surface) noexcept {
  const std::vector<double>& pairs = instrument.pair_friction;
  const double own = instrument.tool.friction;
  return pairs.empty() || own == 0.0 || pairs[surface] == own ? 1.0 : pairs[surface] / own;
}

/// What a tool feels a body by: capsules feel a wall by the hard law, for its near field is that of
/// a ball.
inline const NearField* find_near_field(const Tool& tool, const SoftBody& body) noexcept {
  const NearField* near = body.near_field.get();
  const bool wall = near && near->wall_thickness > 0.0;
  return wall && !tool.capsules.empty() ? nullptr : near;
}

/// list_surfaces() of each jaw of an instrument that has some.
std::array<std::span<const TouchedSurface>, 2> list_jaw_surfaces(const Scene& scene,
                                                                 std::size_t instrument,
                                                                 World& world) noexcept;

/// The surfaces of all bodies, as this instrument touches them, and after these the hard ones;
/// until it is called again.
std::span<const TouchedSurface> list_surfaces(const Scene& scene, std::size_t instrument,
                                              World& world) noexcept;

}  // namespace palpate
