// SPDX-License-Identifier: BSD-3-Clause
// Two instruments on one organ: a shaft through a trocar steadies it from one side, a second one is
// drawn over its top and rubs. Prints what each hand feels, and fails where that is not so.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/tick/tick.h"

using namespace palpate;

namespace {

constexpr double kTick = 1e-3, kRadius = 0.03;

/// A sphere of 642 vertices: an octahedron's sides, halved.
SurfaceMesh make_sphere() {
  SurfaceMesh mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < 4; ++level) {
    std::map<std::array<int, 2>, int> middles;
    const auto middle = [&](int i, int j) {
      const std::array<int, 2> edge = {std::min(i, j), std::max(i, j)};
      const auto [at, fresh] = middles.try_emplace(edge, static_cast<int>(mesh.vertices.size()));
      if (fresh) {
        const Vec3 sum =
            mesh.vertices[static_cast<std::size_t>(i)] + mesh.vertices[static_cast<std::size_t>(j)];
        mesh.vertices.push_back(sum.normalized());
      }
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& x : mesh.vertices) x *= kRadius;
  return mesh;
}

/// 5 mm thick and 20 mm of it touch; its shaft goes to the trocar.
Instrument make_probe(const Vec3& trocar, double friction) {
  Instrument probe;
  probe.tool = {.radius = 0.0025, .friction = friction, .capsules = {{{0, 0, 0}, {0, 0, 0.02}}}};
  probe.trocar = trocar;
  return probe;
}

Scene make_scene(double friction) {
  SurfaceOptions options;
  options.home_stiffness = 3e5;
  options.drag = 30.0;
  Scene scene;
  scene.bodies[0].tissue =
      build_mass_spring(make_sphere(), {.density = 1000.0, .wall_thickness = 0.003}, 60.0, options);
  scene.instruments = {make_probe({-0.15, 0.0, 0.10}, friction),
                       make_probe({0.05, 0.0, 0.20}, friction)};
  return build_scene(std::move(scene));
}

/// Where the two hands are: the left one goes 4 mm in from the side and stays; the right one goes
/// 3 mm down on the top and along it.
std::array<HapticSample, 2> find_hands(double time) {
  std::array<HapticSample, 2> hands;
  const double in = std::min(1.0, time / 0.2), along = std::max(0.0, time - 0.3);
  hands[0].position = {-kRadius - 0.0035 + 0.005 * in, 0.0, 0.0};
  hands[1].position = {0.02 * along, 0.0, kRadius + 0.0035 - 0.004 * in};
  hands[0].time = hands[1].time = time;
  return hands;
}

struct Hands {
  std::array<Vec3, 2> force;
  bool alarm = false;
};

Hands play(double friction) {
  const Scene scene = make_scene(friction);
  World world(scene);
  std::array<HapticCommand, 2> commands;
  for (int i = 0; i < 700; ++i) {
    tick(scene, find_hands(i * kTick), kTick, world, commands);
  }
  return {{commands[0].force, commands[1].force}, static_cast<bool>(world.alarm)};
}

}  // namespace

int main() {
  constexpr double kFriction = 0.2;
  const Hands felt = play(kFriction), again = play(kFriction), smooth = play(0.0);
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3& f = felt.force[k];
    std::printf("hand %zu feels %.3f %.3f %.3f N\n", k, f.x(), f.y(), f.z());
  }
  const bool steadied = felt.force[0].x() < -0.05;
  // friction drags the second hand back, by about mu times what presses it
  const double drag = smooth.force[1].x() - felt.force[1].x();
  const double rubs = drag / (kFriction * felt.force[1].norm());
  const bool same = felt.force == again.force;
  std::printf("dragged back by %.2f of mu N\n", rubs);
  const bool holds = steadied && rubs > 0.7 && rubs < 1.3 && same && !felt.alarm;
  std::puts(holds ? "one steadies, the other rubs, and again to the bit" : "this is not so");
  return holds ? 0 : 1;
}
