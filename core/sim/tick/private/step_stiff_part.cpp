// SPDX-License-Identifier: BSD-3-Clause
#include <exception>
#include <memory>
#include <vector>

#include "palpate/sim/implicit/private/stiff_part.h"
#include "palpate/sim/tick/private/safeguard.h"
#include "palpate/sim/tick/private/touch_bodies.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// Calls `visit` with every particle that carries a vertex of the surface.
template <class Visit>
void for_each_carrier_of(const TissueModel& tissue, int vertex, Visit visit) {
  if (tissue.skin.corners.empty()) return visit(vertex);
  for (const int i : tissue.skin.corners[static_cast<std::size_t>(vertex)]) visit(i);
}

/// Calls `visit` with every particle that carries a corner of the triangle.
template <class Visit>
void for_each_carrier(const TissueModel& tissue, int triangle, Visit visit) {
  for (const int vertex : tissue.triangles[static_cast<std::size_t>(triangle)]) {
    for_each_carrier_of(tissue, vertex, visit);
  }
}

/// [1/s²] What contacts add to w² of a particle that may be touched or is held; none in the air.
std::vector<double> list_contact_stiffness(const Scene& scene, std::size_t index, World& world) {
  const double most = internals(world.bodies[index]).contact_stiffness;
  if (!(most > 0.0)) return {};
  const TissueModel& tissue = scene.bodies[index].tissue;
  std::vector<double> added(tissue.mass.size(), 0.0);
  const auto add = [&](int i) { added[static_cast<std::size_t>(i)] = most; };
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    for_each_touchable(world, i, index,
                       [&](int triangle) { for_each_carrier(tissue, triangle, add); });
  }
  for_each_touched(
      index, world, [&](int vertex) { for_each_carrier_of(tissue, vertex, add); },
      [&](int triangle) { for_each_carrier(tissue, triangle, add); });
  return added;
}

}  // namespace

void choose_stiff_parts(const Scene& scene, double dt, World& world) noexcept {
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    SoftState& state = world.bodies[b];
    StiffSteps& stiff = internals(state).stiff;
    stiff.part.reset();
    stiff.unsolved = false;
    if (state.safeguard != Safeguard::implicit_euler || state.asleep) continue;
    try {
      stiff.part =
          std::make_shared<StiffPart>(scene.bodies[b].tissue, state.tissue.position,
                                      dt / state.substeps, list_contact_stiffness(scene, b, world));
    } catch (const std::exception&) {
      // without memory there is no such part
    }
    stiff.unsolved = !stiff.part || !stiff.part->holds();
  }
}

void step_stiff_part(const SoftBody& body, SoftState& state) noexcept {
  StiffSteps& stiff = internals(state).stiff;
  if (stiff.unsolved) return;
  try {
    stiff.unsolved = !stiff.part->step(body.tissue, state.load, state.tissue);
  } catch (const std::exception&) {
    stiff.unsolved = true;
  }
}

}  // namespace palpate
