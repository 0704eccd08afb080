// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "core/tick/press_scene.h"

namespace palpate::testing {

inline HapticSample hand_at(const Vec3& position, double time = 0.0) {
  HapticSample sample;
  sample.position = position;
  sample.time = time;
  return sample;
}

inline const Vec3 kAway(0.0, 0.0, 0.2);

/// press_scene() at a rate at which one substep in the air is `times` as long as its tissue is
/// stable with, and up to `most` of them.
inline Scene make_coarse(double times, int most, Kernel kernel = scenes::kernel_under_test()) {
  Scene scene = press_scene();
  scene.bodies[0].kernel = kernel;
  const double limit = stable_step(scene.bodies[0].tissue) / 0.9;
  scene.bodies[0].substeps = 1;
  scene.bodies[0].substeps_max = most;
  scene.rate = 1.0 / (times * limit);
  return scene;
}

/// What a tick does to a tissue that has been struck: a millimetre a second, all over the place.
inline void strike(World& world) {
  SoftState& state = world.bodies[0];
  for (std::size_t i = 0; i < state.tissue.velocity.size(); ++i) {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    state.tissue.velocity[i] = sign * Vec3(1e-3, 0.5e-3, -1e-3);
  }
}

/// A world of a struck tissue under the reference, whose state may be written into.
inline World make_struck(const Scene& scene) {
  World world(scene);
  strike(world);
  return world;
}

struct Course {
  std::vector<Safeguard> levels;  ///< each tick's
  Alarm alarm;
  int climbs() const {
    int count = 0;
    for (std::size_t i = 1; i < levels.size(); ++i) count += levels[i] > levels[i - 1];
    return count;
  }
  Safeguard highest() const { return *std::ranges::max_element(levels); }
};

inline Course run(const Scene& scene, World& world, double seconds, const Vec3& hand = kAway) {
  Course course;
  const auto ticks = static_cast<long>(seconds * scene.rate);
  for (long i = 0; i < ticks && !world.alarm; ++i) {
    tick(scene, hand_at(hand), 1.0 / scene.rate, world);
    course.levels.push_back(world.bodies[0].safeguard);
  }
  course.alarm = world.alarm;
  return course;
}

/// press_scene() whose link nearest to the pole is 2000 times as stiff as the others, with as many
/// substeps as it has without: at least `needed` would be stable.
struct StiffLink {
  Scene scene;
  int needed = 0;
};

inline StiffLink make_stiff_link(Kernel kernel = scenes::kernel_under_test()) {
  Scene scene = press_scene();
  scene.bodies[0].kernel = kernel;
  const int usual = scene.bodies[0].substeps;
  TissueModel& tissue = scene.bodies[0].tissue;
  const auto height = [&](const auto& ends) {
    return tissue.rest_position[static_cast<std::size_t>(ends[0])].z() +
           tissue.rest_position[static_cast<std::size_t>(ends[1])].z();
  };
  const auto highest = std::ranges::max_element(tissue.springs.ends, {}, height);
  tissue.springs.stiffness[static_cast<std::size_t>(highest - tissue.springs.ends.begin())] *= 2000;
  scene.bodies[0].substeps = scene.bodies[0].substeps_max = 0;
  scene = build_scene(std::move(scene));
  const int needed = scene.bodies[0].substeps;
  scene.bodies[0].substeps = usual + 1;
  scene.bodies[0].substeps_max = usual + 2;
  return {std::move(scene), needed};
}

}  // namespace palpate::testing
