// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/touch_hard.h"

#include <algorithm>
#include <numbers>

#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/contact/private/broad_phase.h"
#include "palpate/sim/grasp/private/jaws.h"
#include "palpate/sim/mesh/private/triangle_areas.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/tick/tick.h"

namespace palpate {
namespace {

/// [N/m] Of an instrument on a triangle that is hard, however small that is: pressed with all that
/// a hand may, 5 N, it goes in by 0.05 mm.
constexpr double kHard = 1e5;

/// Of the disc that the least stiffness of a stone belongs to: of a tool's radius, and [m] no more.
/// A wider one lets what presses with 5 N through stones of 5 mm, a smaller one is rough.
constexpr double kDiscPart = 0.7, kWidestDisc = 0.84e-3;

/// How hard a triangle is at least: by itself, or as its part of a disc [contact: rigid].
struct Hardness {
  double least = 0.0;  // [N/m]
  double disc = 0.0;   // [m²] 0: of each triangle by itself
};

Hardness find_hardness(const RigidBody& body, const Tool& tool) {
  const double r = std::min(kDiscPart * tool.radius, kWidestDisc);
  return {body.contact_stiffness, std::numbers::pi * r * r};
}

/// [m²] With which the contact law makes each triangle so hard.
std::vector<double> find_areas(const SurfaceMesh& mesh, const Tool& tool, const Hardness& hard) {
  std::vector<double> areas = compute_triangle_areas(mesh.vertices, mesh.triangles);
  for (double& area : areas) {
    const double part = area < hard.disc ? area / hard.disc : 1.0;
    area = std::max(area, part * hard.least / tool.stiffness);
  }
  return areas;
}

HardPair make_pair(const SurfaceMesh& mesh, const Tool& tool, const Hardness& hard) {
  const auto count = static_cast<int>(mesh.triangles.size());
  const int capsules = tool.jaws ? 1 : static_cast<int>(tool.capsules.size());
  HardPair pair{{Candidates(count, capsules), Candidates(tool.jaws ? count : 0)},
                Load((tool.jaws ? 4 : 2) * count),
                find_areas(mesh, tool, hard)};
  for (Candidates& candidates : pair.candidates) {
    candidates.border = find_border(mesh.triangles);
    if (simd_targets().empty() || candidates.triangles.empty()) continue;
    candidates.lanes = ContactLanes(count, {}, capsules);
  }
  return pair;
}

void find_of(const HardSurface& hard, const Shape& shape, const Vec3& position, const Vec3& hand,
             std::span<const double> areas, Candidates& candidates) noexcept {
  find_candidates(hard.tree, hard.x, Sweep(shape.tool, shape.axes, position, hand), position, hand,
                  areas, candidates);
}

}  // namespace

void build_hard_surfaces(const Scene& scene, World& world) {
  TickBuffers& work = workspace(world);
  for (const Scenery& scenery : scene.scenery) work.hard.emplace_back(scenery.mesh);
  for (const RigidBody& body : scene.rigid) work.hard.emplace_back(body.mesh);
  for (const Instrument& instrument : scene.instruments) {
    for (const Scenery& scenery : scene.scenery) {
      work.hard_pairs.push_back(make_pair(scenery.mesh, instrument.tool, {kHard}));
    }
    for (const RigidBody& body : scene.rigid) {
      const Tool& tool = instrument.tool;
      work.hard_pairs.push_back(make_pair(body.mesh, tool, find_hardness(body, tool)));
    }
  }
  work.surfaces.resize(world.bodies.size() + work.hard.size());
  work.second_surfaces.resize(work.surfaces.size());
}

void find_touchable_hard(const Scene& scene, std::size_t instrument, const Vec3& hand,
                         World& world) noexcept {
  TickBuffers& work = workspace(world);
  const Tool& tool = scene.instruments[instrument].tool;
  const ToolState& state = world.instruments[instrument].tool;
  for (std::size_t h = 0; h < work.hard.size(); ++h) {
    HardPair& pair = work.hard_pairs[instrument * work.hard.size() + h];
    if (!tool.jaws) {
      const Axes axes(tool, state.orientation);
      find_of(work.hard[h], {tool, axes}, state.position, hand, pair.areas, pair.candidates[0]);
      continue;
    }
    const OpenJaws jaws(tool, state.orientation, state.jaw_angle);
    for (int j = 0; j < 2; ++j) {
      find_of(work.hard[h], jaws.shape(j), state.position, hand, pair.areas,
              pair.candidates[static_cast<std::size_t>(j)]);
    }
  }
}

bool has_room_at_hard(World& world, const Vec3& hand, const Tool& tool,
                      const ToolState& state) noexcept {
  return std::ranges::all_of(workspace(world).hard, [&](const HardSurface& hard) noexcept {
    return has_room(hard.tree, hard.x, hand, tool, state.orientation, state.jaw_angle);
  });
}

void list_hard_surfaces(const Scene& scene, std::size_t instrument, std::size_t jaw, World& world,
                        std::span<TouchedSurface> list) noexcept {
  TickBuffers& work = workspace(world);
  for (std::size_t h = 0; h < list.size(); ++h) {
    HardPair& pair = work.hard_pairs[instrument * work.hard.size() + h];
    list[h] = {.candidates = &pair.candidates[jaw],
               .triangles = work.hard[h].tree.triangles(),
               .x = work.hard[h].x,
               .load = &pair.load,
               .friction_part =
                   find_friction_part(scene.instruments[instrument], world.bodies.size() + h)};
  }
}

}  // namespace palpate
