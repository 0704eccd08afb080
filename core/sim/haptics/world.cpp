// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/haptics/world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "palpate/sim/dynamics/follow_motion.h"
#include "palpate/sim/dynamics/packed.h"
#include "palpate/sim/haptics/linear_tick.h"
#include "palpate/sim/model/volumes.h"

namespace palpate {
namespace {

/// [s] A part of a tissue that has not moved for so long sleeps: longer than any wave takes to come
/// back, shorter than anybody waits for.
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

}  // namespace

// every triangle may be touched and held at once, so no capacity can ever run out
World::World(const Scene& scene)
    : scene_identity(scene.identity),
      tissue(validated(scene).tissue),
      skin(scene.tissue.skin.corners.size()),
      tree(compute_surface(scene.tissue, scene.tissue.rest_position), scene.tissue.triangles),
      tree_cost(tree),
      candidates(static_cast<int>(scene.tissue.triangles.size())),
      tool(static_cast<int>(scene.tissue.triangles.size())),
      load(2 * static_cast<int>(scene.tissue.triangles.size())),
      guard(scene.tissue, scene.gravity, tissue),
      substeps(scene.substeps),
      spectrum(scene.tissue, scene.spectrum_stiffness),
      chosen_stiffness(scene.spectrum_stiffness),
      scratch(static_cast<std::size_t>(surface_count(scene.tissue)), 0.0),
      surface_mass(compute_surface_mass(scene.tissue)) {
  load.gravity = scene.gravity;
  move_skin(scene.tissue.skin, tissue.position, skin);
  for (const auto& weights : scene.tissue.skin.weights) {
    double gain = 0.0;
    for (const double w : weights) gain += std::abs(w);
    skin_gain = std::max(skin_gain, gain);
  }
  if (scene.kernel != Kernel::reference && !scene.tissue.elastic.corners.empty()) {
    response = scene.response;
    answer = ResponseState(*response);
    deepest = compute_shallow_depths(scene.tissue, tree);
    make_near();
    return;
  }
  if (scene.kernel == Kernel::reference || simd_targets().empty() ||
      !has_packed_form(scene.tissue)) {
    return;
  }
  const bool sleeps = scene.force_error > 0.0;
  packed_model = std::make_shared<const PackedModel>(
      pack(scene.tissue, scene.simd_target, sleeps ? PackedOrder::patches : PackedOrder::bands));
  packed = PackedState(*packed_model, scene.tissue, tissue);
  tool.lanes =
      ContactLanes(static_cast<int>(scene.tissue.triangles.size()), simd_target(*packed_model));
  make_near();
  if (!sleeps) return;
  active = ActiveSet(*packed_model, scene.tissue, load, tissue,
                     derive_active_rule(scene.tissue, scene.tool.radius, scene.force_error),
                     std::max(1, static_cast<int>(std::lround(kPatience * scene.rate))), packed);
  in_tree.assign(static_cast<std::size_t>(packed_model->slice_count), 0);
}

void World::make_near() {
  suspects.resize(tree.triangles().size());
  last_read_at.resize(scratch.size(), -1);
  near.resize(tissue.position.size());
  last_near_at.resize(near.size(), -1);
  near_skin.resize(skin.size());
  last_skin_near_at.resize(skin.size(), -1);
}

}  // namespace palpate
