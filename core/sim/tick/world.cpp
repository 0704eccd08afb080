// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "palpate/sim/model/volumes.h"
#include "palpate/sim/packed/private/follow_motion.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/linear_tick.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// [s] A part of a tissue that has not moved for so long sleeps: longer than any wave takes to come
/// back, shorter than a user waits.
constexpr double kPatience = 0.05;

const Scene& validated(const Scene& scene) {
  if (scene.substeps < 1 || scene.substeps_max < scene.substeps ||
      scene.rest_areas.size() != scene.tissue.triangles.size()) {
    throw std::invalid_argument(
        "world: got a scene whose derived fields are not filled in, expected one from build_scene");
  }
  const bool linear = !scene.tissue.elastic.corners.empty();
  if (linear && scene.kernel != Kernel::reference && !scene.response) {
    throw std::invalid_argument(
        "world: got a linear solid without its response, expected a scene from build_scene");
  }
  return scene;
}

TissueKernel choose_kernel(const Scene& scene, const World& world) {
  if (scene.kernel == Kernel::reference) return ReferenceKernel();
  if (!scene.tissue.elastic.corners.empty()) return ResponseKernel(scene, world.tree);
  if (simd_targets().empty() || !has_packed_form(scene.tissue)) return ReferenceKernel();
  return PackedKernel(scene, world.tissue, world.load);
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

std::size_t count_surface(const Scene& scene) {
  return static_cast<std::size_t>(surface_count(scene.tissue));
}

}  // namespace

NearList::NearList(std::size_t most_particles, std::size_t most_skin)
    : particles(most_particles),
      skin(most_skin),
      particle_last_at(most_particles, -1),
      skin_last_at(most_skin, -1) {}

PackedKernel::PackedKernel(const Scene& scene, const State& tissue, const Load& load)
    : near(tissue.position.size(), scene.tissue.skin.corners.size()),
      broad_candidates(scene.tissue.triangles.size()),
      last_read_at(count_surface(scene), -1),
      skin_gain(find_skin_gain(scene.tissue.skin)) {
  const bool sleeps = scene.force_error > 0.0;
  model = std::make_shared<const PackedModel>(
      pack(scene.tissue, scene.simd_target, sleeps ? PackedOrder::patches : PackedOrder::bands));
  state = PackedState(*model, scene.tissue, tissue);
  if (!sleeps) return;
  active = ActiveSet(*model, scene.tissue, load, tissue,
                     derive_active_rule(scene.tissue, scene.tool.radius, scene.force_error),
                     std::max(1, static_cast<int>(std::lround(kPatience * scene.rate))), state);
  in_tree.assign(static_cast<std::size_t>(model->slice_count), 0);
}

ResponseKernel::ResponseKernel(const Scene& scene, const AabbTree& tree)
    : response(scene.response),
      state(*response),
      near(scene.tissue.rest_position.size(), scene.tissue.skin.corners.size()),
      deepest(compute_shallow_depths(scene.tissue, tree)) {}

WorldInternals::WorldInternals(const Scene& scene, const World& world)
    : kernel(choose_kernel(scene, world)),
      tree_cost(world.tree),
      spectrum(scene.tissue, scene.spectrum_stiffness),
      chosen_stiffness(scene.spectrum_stiffness),
      surface_mass(compute_surface_mass(scene.tissue)),
      vertex_scratch(count_surface(scene), 0.0) {}

// every triangle may be touched and held at once, so no capacity can ever run out
World::World(const Scene& scene)
    : scene_identity(scene.identity),
      tissue(validated(scene).tissue),
      skin(scene.tissue.skin.corners.size()),
      tree(compute_surface(scene.tissue, scene.tissue.rest_position), scene.tissue.triangles),
      guard(scene.tissue, scene.gravity, tissue),
      substeps(scene.substeps),
      tool(static_cast<int>(scene.tissue.triangles.size())),
      candidates(static_cast<int>(scene.tissue.triangles.size())),
      load(2 * static_cast<int>(scene.tissue.triangles.size())) {
  load.gravity = scene.gravity;
  move_skin(scene.tissue.skin, tissue.position, skin);
  internals_ = OwnedInternals(*this, scene);
  if (const PackedKernel* packed = find_packed(*this)) {
    tool.lanes =
        ContactLanes(static_cast<int>(scene.tissue.triangles.size()), simd_target(*packed->model));
  }
}

World::OwnedInternals::OwnedInternals() noexcept = default;
World::OwnedInternals::OwnedInternals(const World& world, const Scene& scene)
    : internals_(std::make_unique<WorldInternals>(scene, world)) {}
World::OwnedInternals::OwnedInternals(const OwnedInternals& other)
    : internals_(std::make_unique<WorldInternals>(*other.internals_)) {}
World::OwnedInternals::OwnedInternals(OwnedInternals&& other) noexcept = default;
World::OwnedInternals& World::OwnedInternals::operator=(const OwnedInternals& other) {
  return *this = OwnedInternals(other);
}
World::OwnedInternals& World::OwnedInternals::operator=(OwnedInternals&& other) noexcept = default;
World::OwnedInternals::~OwnedInternals() = default;

}  // namespace palpate
