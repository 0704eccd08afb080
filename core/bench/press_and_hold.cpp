// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/bench/press_and_hold.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::bench {
namespace {

/// [m] from a particle to the closest one that is held.
double reach(const TissueModel& tissue, const Vec3& p) {
  double closest = std::numeric_limits<double>::infinity();
  for (const int i : tissue.fixed) {
    closest = std::min(closest, (tissue.rest_position[static_cast<std::size_t>(i)] - p).norm());
  }
  return closest;
}

}  // namespace

Place find_press_place(const TissueModel& tissue) {
  const auto& x = tissue.rest_position;
  std::vector<bool> outside(x.size(), false);
  for (const Triangle& corners : tissue.triangles) {
    for (const int i : corners) outside[static_cast<std::size_t>(i)] = true;
  }
  auto best =
      static_cast<std::size_t>(std::find(outside.begin(), outside.end(), true) - outside.begin());
  double farthest = reach(tissue, x[best]);
  for (std::size_t i = best + 1; i < x.size(); ++i) {
    if (!outside[i]) continue;
    const double here = reach(tissue, x[i]);
    if (here < farthest || (here == farthest && x[i].z() <= x[best].z())) continue;
    best = i;
    farthest = here;
  }
  return {x[best], compute_vertex_normals(x, tissue.triangles)[best]};
}

HapticSample hold_at(const Scene& scene, const Place& place, double height) {
  HapticSample sample;
  sample.position = place.point + (scene.instruments[0].tool.radius + height) * place.outward;
  return sample;
}

int afford(int wanted, int least, double work_each, double affordable) {
  return static_cast<int>(std::clamp(affordable / work_each, double(least), double(wanted)));
}

double count_work(const Scene& scene, const World& world) {
  return double(scene.bodies[0].tissue.mass.size()) *
         std::max(world.bodies[0].substeps, scene.bodies[0].substeps);
}

Vec3Array press_and_hold(const std::string& work, const Scene& scene, const Place& place,
                         World& world, double affordable) {
  const double dt = 1.0 / scene.rate;
  const int ticks = afford(300, 60, count_work(scene, world), affordable);
  Vec3Array felt;
  for (int i = 0; i <= ticks; ++i) {
    const double above = 2.0 * kPressDepth * std::max(0.0, 1.0 - 1.5 * i / ticks);
    felt.push_back(tick(scene, hold_at(scene, place, above - kPressDepth), dt, world).force);
  }
  // without dashpots it may bounce
  for (int i = 0; i < ticks && world.bodies[0].load.push_count == 0; ++i) {
    felt.push_back(tick(scene, hold_at(scene, place, -kPressDepth), dt, world).force);
  }
  if (world.alarm) throw std::logic_error("bench: " + work + ": the held press blew up");
  if (world.bodies[0].load.push_count == 0)
    throw std::logic_error("bench: " + work + ": touches nothing");
  return felt;
}

}  // namespace palpate::bench
