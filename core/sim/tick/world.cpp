// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "palpate/sim/contact/private/touched_surface.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/packed/private/follow_motion.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/linear_tick.h"
#include "palpate/sim/tick/private/stop_at_scenery.h"
#include "palpate/sim/tick/private/touch_bodies.h"
#include "palpate/sim/tick/private/touch_hard.h"
#include "palpate/sim/tick/private/touch_rigid.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// [s] A part of a tissue that has not moved for so long sleeps: longer than any wave takes to come
/// back, shorter than a user waits.
constexpr double kPatience = 0.05;

const Scene& validated(const Scene& scene) {
  bool built = !scene.bodies.empty() && !scene.instruments.empty();
  for (const SoftBody& body : scene.bodies) {
    built = built && body.substeps >= 1 && body.substeps_max >= body.substeps &&
            body.rest_areas.size() == body.tissue.triangles.size();
  }
  if (!built) {
    throw std::invalid_argument(
        "world: got a scene whose derived fields are not filled in, expected one from build_scene");
  }
  for (const SoftBody& body : scene.bodies) {
    const bool linear = !body.tissue.elastic.corners.empty();
    if (linear && body.kernel != Kernel::reference && !body.response) {
      throw std::invalid_argument(
          "world: got a linear solid without its response, expected a scene from build_scene");
    }
  }
  return scene;
}

TissueKernel choose_kernel(const Scene& scene, const SoftBody& body, const SoftState& state) {
  if (body.kernel == Kernel::reference || body.integrator != Integrator::symplectic_euler) {
    return ReferenceKernel();
  }
  if (!body.tissue.elastic.corners.empty()) return ResponseKernel(body, state.tree);
  if (simd_targets().empty() || !has_packed_form(body.tissue)) return ReferenceKernel();
  return PackedKernel(scene, body, state);
}

/// [-] No vertex of a skin goes farther than a particle times this.
double find_skin_gain(const Skin& skin) {
  double most = 1.0;
  for (const auto& weights : skin.weights) {
    double gain = 0.0;
    for (const double w : weights) gain += std::abs(w);
    most = std::max(most, gain);
  }
  return most;
}

std::size_t count_surface(const SoftBody& body) {
  return static_cast<std::size_t>(surface_count(body.tissue));
}

int count_triangles(const SoftBody& body) noexcept {
  return static_cast<int>(body.tissue.triangles.size());
}

/// Of one instrument, 1 of a ball.
std::size_t count_most_capsules(const Scene& scene) noexcept {
  std::size_t most = 1;
  for (const Instrument& instrument : scene.instruments) {
    most = std::max(most, instrument.tool.capsules.size());
  }
  return most;
}

/// Every triangle may be touched and held at once, by each of two jaws.
int count_pushes(const Tool& tool, int triangles) noexcept {
  return (tool.jaws ? 4 : 2) * triangles;
}

int count_pushes(const Scene& scene, const SoftBody& body) noexcept {
  int count = 0;
  for (const Instrument& each : scene.instruments) {
    count += count_pushes(each.tool, count_triangles(body));
  }
  if (!scene.body_pairs.empty()) count += surface_count(body.tissue);
  for (const RigidBody& rigid : scene.rigid) {
    count += static_cast<int>(kMostSpherePushes * rigid.sphere_radii.size());
  }
  return count;
}

int count_triangles(const Scene& scene) noexcept {
  int count = 0;
  for (const SoftBody& body : scene.bodies) count += count_triangles(body);
  for (const Scenery& scenery : scene.scenery) {
    count += static_cast<int>(scenery.mesh.triangles.size());
  }
  for (const RigidBody& body : scene.rigid) {
    count += static_cast<int>(body.mesh.triangles.size());
  }
  return count;
}

}  // namespace

NearList::NearList(const TissueModel& tissue)
    : particles(tissue.rest_position.size()),
      skin(tissue.skin.corners.size()),
      particle_last_at(particles.size(), -1),
      skin_last_at(skin.size(), -1),
      triangle_last_at(tissue.triangles.size(), -1) {}

PackedKernel::PackedKernel(const Scene& scene, const SoftBody& body, const SoftState& soft)
    : near(body.tissue),
      broad_candidates(body.tissue.triangles.size() * count_most_capsules(scene)),
      last_read_at(count_surface(body), -1),
      skin_gain(find_skin_gain(body.tissue.skin)) {
  const bool sleeps = body.force_error > 0.0;
  model = std::make_shared<const PackedModel>(
      pack(body.tissue, body.simd_target, sleeps ? PackedOrder::patches : PackedOrder::bands));
  state = PackedState(*model, body.tissue, soft.tissue);
  if (!sleeps) return;
  active = ActiveSet(*model, body.tissue, soft.load, soft.tissue,
                     derive_active_rule(body.tissue, find_largest_radius(scene), body.force_error),
                     std::max(1, static_cast<int>(std::lround(kPatience * scene.rate))), state);
  in_tree.assign(static_cast<std::size_t>(model->slice_count), 0);
}

ResponseKernel::ResponseKernel(const SoftBody& body, const AabbTree& tree)
    : response(body.response),
      state(*response),
      near(body.tissue),
      deepest(compute_shallow_depths(body.tissue, tree)) {}

BodyCheckpoint::BodyCheckpoint(const TissueKernel& kernel, const SoftState& state) {
  if (const auto* moved = std::get_if<PackedKernel>(&kernel)) {
    packed = PackedCheckpoint(moved->state);
  } else if (const auto* answers = std::get_if<ResponseKernel>(&kernel)) {
    displacement = answers->state.displacement;
  } else {
    position = state.tissue.position;
    velocity = state.tissue.velocity;
    internal = state.tissue.internal;
  }
}

BodyInternals::BodyInternals(const Scene& scene, const SoftBody& body, const SoftState& state)
    : kernel(choose_kernel(scene, body, state)),
      checkpoints{BodyCheckpoint(kernel, state), BodyCheckpoint(kernel, state)},
      tree_cost(state.tree),
      spectrum(body.tissue, body.spectrum_stiffness),
      chosen_stiffness(body.spectrum_stiffness),
      wanted_substeps(body.substeps),
      surface_mass(compute_surface_mass(body.tissue)),
      // a number for each particle as well (ParticleRows)
      vertex_scratch(std::max(count_surface(body), body.tissue.mass.size()), 0.0) {
  rest.copy.resize(2 * sizeof(Vec3) * state.tissue.position.size() +
                   sizeof(double) * state.tissue.internal.size());
  if (const auto* packed = std::get_if<PackedKernel>(&kernel)) {
    std::size_t numbers = 2 * packed->state.displacement.size();
    for (const auto& internal : packed->state.internal) numbers += internal.size();
    rest.copy.resize(numbers * sizeof(float));
  }
  tear = Tear(body.tissue, body.tear_stretch);
  if (scene.bodies.size() > 1 || !scene.rigid.empty())
    mean_load = MeanLoad(body.tissue.triangles, count_surface(body));
}

// every triangle may be touched and held by every instrument at once, so no capacity can run out
SoftState::SoftState(const Scene& scene, const SoftBody& body)
    : tissue(body.tissue),
      skin(body.tissue.skin.corners.size()),
      tree(compute_surface(body.tissue, body.tissue.rest_position), body.tissue.triangles),
      guard(body.tissue, find_gravity(scene, body), tissue),
      load(count_pushes(scene, body)),
      substeps(body.substeps) {
  load.gravity = find_gravity(scene, body);
  move_skin(body.tissue.skin, tissue.position, skin);
  if (body.tear_stretch > 0.0) {
    guard.torn_links.assign(body.tissue.springs.ends.size() + body.tissue.bonds.ends.size(), 0);
  }
  internals_ = Owned(BodyInternals(scene, body, *this));
}

World::World(const Scene& scene) : scene_identity(validated(scene).identity) {
  bodies.reserve(scene.bodies.size());
  for (const SoftBody& body : scene.bodies) bodies.emplace_back(scene, body);
  for (const Instrument& instrument : scene.instruments) {
    const int count = count_triangles(scene);
    const bool rubs = instrument.tool.friction > 0.0, has_jaws = instrument.tool.jaws.has_value();
    const int patch = rubs && !has_jaws ? count : 0, anchors = rubs && has_jaws ? 2 * count : 0;
    instruments.push_back(InstrumentState{.tool = ToolState(count, patch, anchors)});
    if (!has_jaws) continue;
    ToolState& tool = instruments.back().tool;
    tool.jaw_angle = tool.jaw_wanted = instrument.tool.jaws->open;
    tool.grip_limit = instrument.tool.jaws->grip;
  }
  pairs.reserve(instruments.size() * bodies.size());
  std::vector<std::vector<unsigned char>> borders;
  for (const SoftBody& body : scene.bodies) borders.push_back(find_border(body.tissue.triangles));
  for (std::size_t i = 0; i < instruments.size(); ++i) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const int count = count_triangles(scene.bodies[b]);
      const Tool& tool = scene.instruments[i].tool;
      // of jaws each has candidates of its own
      const int capsules = tool.jaws ? 1 : static_cast<int>(tool.capsules.size());
      pairs.push_back({Candidates(count, capsules), Load(count_pushes(tool, count))});
      pairs.back().candidates.border = borders[b];
      if (const PackedKernel* packed = find_packed(bodies[b])) {
        pairs.back().candidates.lanes = ContactLanes(count, simd_target(*packed->model), capsules);
      }
      if (scene.bodies[b].near_field) {
        pairs.back().candidates.near = {count, surface_count(scene.bodies[b].tissue),
                                        static_cast<int>(instruments.size()) - 1};
      }
    }
  }
  costs.bodies.resize(bodies.size());
  costs.instruments.resize(instruments.size());
  costs.pairs.resize(pairs.size());
  costs.body_pairs.resize(scene.body_pairs.size());
  workspace_ = Owned(TickBuffers(*this));
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const bool has_jaws = scene.instruments[p / bodies.size()].tool.jaws.has_value();
    if (has_jaws) workspace(*this).second[p] = pairs[p].candidates;
  }
  build_hard_surfaces(scene, *this);
  build_body_contacts(scene, *this);
  build_scenery_contacts(scene, *this);
  build_rigid_contacts(scene, *this);
}

TickBuffers::TickBuffers(const World& world)
    : instruments(world.instruments.size()),
      near(world.pairs.size()),
      second(world.pairs.size()),
      second_near(world.pairs.size()),
      hands(world.instruments.size()),
      surfaces(world.bodies.size()),
      second_surfaces(world.bodies.size()),
      others(world.bodies.size() * world.instruments.size()),
      work(world.bodies.size(), 0.0),
      wanted(world.bodies.size(), 1),
      cost(world.bodies.size(), 0.0) {
  for (std::size_t i = 0; i < instruments.size(); ++i) {
    instruments[i].patch = world.instruments[i].tool.patch;
    instruments[i].anchors = world.instruments[i].tool.anchors;
  }
}

std::span<const TouchedSurface> list_surfaces(const Scene& scene, std::size_t instrument,
                                              World& world) noexcept {
  std::vector<TouchedSurface>& surfaces = workspace(world).surfaces;
  std::vector<const NearContacts*>& others = workspace(world).others;
  const std::size_t count = world.instruments.size() - 1;
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    ContactPair& pair = world.pair(instrument, b);
    const auto from = others.begin() + static_cast<std::ptrdiff_t>(b * count);
    for (std::size_t i = 0, at = b * count; i <= count; ++i) {
      if (i != instrument) others[at++] = &world.pair(i, b).candidates.near;
    }
    const SoftBody& body = scene.bodies[b];
    surfaces[b] = {&pair.candidates,
                   body.tissue.triangles,
                   surface_position(world.bodies[b]),
                   &pair.load,
                   find_near_field(scene.instruments[instrument].tool, body),
                   {from, count}};
    surfaces[b].friction_part = find_friction_part(scene.instruments[instrument], b);
    surfaces[b].springs = is_wall(body.tissue) && body.tissue.prisms.corners.empty();
    if (body.near_field) {
      surfaces[b].wall_thickness = body.near_field->wall_thickness;
      surfaces[b].wall_modulus = body.near_field->modulus;
    }
  }
  list_hard_surfaces(scene, instrument, 0, world, std::span(surfaces).subspan(world.bodies.size()));
  return surfaces;
}

std::array<std::span<const TouchedSurface>, 2> list_jaw_surfaces(const Scene& scene,
                                                                 std::size_t instrument,
                                                                 World& world) noexcept {
  const std::span<const TouchedSurface> first = list_surfaces(scene, instrument, world);
  std::vector<TouchedSurface>& surfaces = workspace(world).second_surfaces;
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    surfaces[b] = first[b];
    surfaces[b].candidates = &second_jaw(world, instrument, b);
  }
  list_hard_surfaces(scene, instrument, 1, world, std::span(surfaces).subspan(world.bodies.size()));
  return {first, surfaces};
}

template <class Hidden>
Owned<Hidden>::Owned() noexcept = default;
template <class Hidden>
Owned<Hidden>::Owned(Hidden hidden) : hidden_(std::make_unique<Hidden>(std::move(hidden))) {}
template <class Hidden>
Owned<Hidden>::Owned(const Owned& other) : hidden_(std::make_unique<Hidden>(*other.hidden_)) {}
template <class Hidden>
Owned<Hidden>::Owned(Owned&& other) noexcept = default;
template <class Hidden>
Owned<Hidden>& Owned<Hidden>::operator=(const Owned& other) {
  return *this = Owned(other);
}
template <class Hidden>
Owned<Hidden>& Owned<Hidden>::operator=(Owned&& other) noexcept = default;
template <class Hidden>
Owned<Hidden>::~Owned() = default;

template class Owned<BodyInternals>;
template class Owned<TickBuffers>;

}  // namespace palpate
