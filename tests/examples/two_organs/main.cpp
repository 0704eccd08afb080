// SPDX-License-Identifier: BSD-3-Clause
// Two organs that touch: a tip presses the upper one onto the lower one, in a scene from code and
// in the same scene from a .palpate file. Prints what the hand and the lower organ feel, and fails
// where that is not so.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>

#include "palpate/scenario/read.h"
#include "palpate/scenario/write.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/tick/tick.h"

using namespace palpate;

namespace {

constexpr double kTick = 1e-3, kRadius = 0.02, kGap = 4e-4;

/// A sphere of 258 vertices around a centre: an octahedron's sides, halved.
SurfaceMesh make_sphere(const Vec3& centre) {
  SurfaceMesh mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < 3; ++level) {
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
  for (Vec3& x : mesh.vertices) x = centre + kRadius * x;
  return mesh;
}

/// `home` [N/m³] is how firmly it is held where it is.
SoftBody make_organ(double height, double home) {
  SurfaceOptions options;
  options.home_stiffness = home;
  options.drag = 30.0;
  SoftBody body;
  body.tissue = build_mass_spring(make_sphere({0.0, 0.0, height}),
                                  {.density = 1000.0, .wall_thickness = 0.003}, 2000.0, options);
  return body;
}

Scene make_scene(bool touches) {
  Scene scene;
  scene.bodies = {make_organ(2.0 * kRadius + kGap, 5e3), make_organ(0.0, 3e5)};
  if (touches) scene.body_pairs = {{.first = 0, .second = 1}};
  return build_scene(std::move(scene));
}

struct Pressed {
  double hand = 0.0;       ///< [N] of the hand, at the deepest
  double lower = 0.0;      ///< [N] downwards on the lower organ
  double least_gap = 1.0;  ///< [m] between the organs
  bool alarm = false;
};

Pressed press(const Scene& scene) {
  World world(scene);
  HapticSample hand;
  HapticCommand command;
  Pressed felt;
  const double top = 3.0 * kRadius + kGap + scene.instruments[0].tool.radius;
  for (int i = 0; i < 600; ++i) {
    hand.time = i * kTick;
    // 6 mm: pressed farther, the springs of the upper one buckle over the lower one
    hand.position = {0.0, 0.0, top + 1e-3 - 7e-3 * std::min(1.0, i / 400.0)};
    tick(scene, {&hand, 1}, kTick, world, {&command, 1});
    felt.alarm = felt.alarm || world.alarm;
    if (!world.body_pairs.empty()) {
      felt.least_gap = std::min(felt.least_gap, world.body_pairs[0].least_gap);
    }
  }
  felt.hand = command.force.z();
  if (!world.body_pairs.empty()) felt.lower = -world.body_pairs[0].force.z();
  return felt;
}

}  // namespace

int main() {
  const Scene scene = make_scene(true);
  const Pressed touching = press(scene), through = press(make_scene(false));

  const std::string file =
      (std::filesystem::temp_directory_path() / "palpate_two_organs_example.palpate").string();
  scenario::Scenario made;
  made.scene = scene;
  made.title = "Two organs";
  scenario::write(file, made);
  const Pressed from_file = press(scenario::read(file).scene);
  std::filesystem::remove(file);

  std::printf("the hand feels %.3f N, the lower organ %.3f N, gap %.3f mm at least; alone %.3f N\n",
              touching.hand, touching.lower, 1e3 * touching.least_gap, through.hand);
  const bool same = from_file.hand == touching.hand && from_file.lower == touching.lower &&
                    from_file.least_gap == touching.least_gap;
  std::printf("from a file: %s\n", same ? "the same bits" : "something else");
  const bool sound = !touching.alarm && !through.alarm && touching.least_gap > 0.0;
  const bool felt = touching.lower > 1e-3 && touching.hand > through.hand;
  return same && sound && felt ? 0 : 1;
}
