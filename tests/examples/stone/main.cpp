// SPDX-License-Identifier: BSD-3-Clause
// A stone on a table: jaws take it, lift it and press it onto an organ that lies on another one, in
// a scene from code and in the same scene from a .palpate file. Prints what is felt, and fails
// where that is not so.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <numbers>

#include "palpate/scenario/read.h"
#include "palpate/scenario/write.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/tick/tick.h"

using namespace palpate;

namespace {

constexpr double kTick = 1e-3, kRadius = 0.02, kGap = 4e-4;
constexpr double kAside = -0.05;          ///< [m] in y: where the stone lies
const Vec3 kHalf(0.0055, 0.0045, 0.004);  ///< [m] half axes of the stone, an ellipsoid

/// A sphere of 258 vertices: an octahedron's sides, halved; made as long as `half` and moved.
SurfaceMesh make_ellipsoid(const Vec3& half, const Vec3& centre) {
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
  for (Vec3& x : mesh.vertices) x = centre + half.cwiseProduct(x);
  return mesh;
}

/// `home` [N/m³] is how firmly it is held where it is.
SoftBody make_organ(double height, double home) {
  SurfaceOptions options;
  options.home_stiffness = home;
  options.drag = 30.0;
  const SurfaceMesh mesh = make_ellipsoid(Vec3::Constant(kRadius), {0.0, 0.0, height});
  SoftBody body;
  body.tissue =
      build_mass_spring(mesh, {.density = 1000.0, .wall_thickness = 0.003}, 2000.0, options);
  return body;
}

/// A slab 10 mm thick with its top at z = 0; the lower organ stops at it.
Scenery make_table() {
  Scenery table{{}, {1}, 0.2};
  for (const double z : {-0.01, 0.0}) {
    for (const auto& [x, y] : {std::pair{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}) {
      table.mesh.vertices.emplace_back(x, y, z);
    }
  }
  table.mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                          {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  return table;
}

/// Of 2000 kg/m³, with fourteen spheres in it that touch its surface.
RigidBody make_stone() {
  RigidBody stone;
  const double r = 0.45 * kHalf.minCoeff();
  for (int way = 0; way < 27; ++way) {
    const Vec3 d(way % 3 - 1, way / 3 % 3 - 1, way / 9 - 1);
    const double sides = d.cwiseAbs().sum();
    if (sides != 1.0 && sides != 3.0) continue;
    stone.sphere_centres.push_back(d.normalized().cwiseProduct(kHalf - Vec3::Constant(r)));
    stone.sphere_radii.push_back(r);
  }
  stone.mesh = make_ellipsoid(kHalf, Vec3::Zero());
  stone.mass = 2000.0 * 4.0 / 3.0 * std::numbers::pi * kHalf.prod();
  const Vec3 square = kHalf.cwiseProduct(kHalf);
  stone.inertia = stone.mass / 5.0 * (Vec3::Constant(square.sum()) - square);
  stone.position = {0.0, kAside, kHalf.z()};
  return stone;
}

/// Two jaws of 10 mm, which close with 2 N.
Tool make_jaws() {
  Tool tool;
  const double r = tool.radius = 0.0012;
  tool.friction = 0.5;
  tool.capsules = {{{0.0, r, 0.0}, {0.0, r, 0.01}}, {{0.0, -r, 0.0}, {0.0, -r, 0.01}}};
  tool.jaws = Jaws{.hinge = {0.0, 0.0, 0.02}, .axis = Vec3::UnitX(), .open = 0.5, .grip = 2.0};
  return tool;
}

Scene make_scene() {
  Scene scene;
  scene.bodies = {make_organ(3.0 * kRadius + kGap + 1e-4, 3e3), make_organ(kRadius + 1e-4, 1e4)};
  scene.body_pairs = {{.first = 0, .second = 1}};
  scene.rigid = {make_stone()};
  scene.scenery = {make_table()};
  scene.instruments[0].tool = make_jaws();
  scene.gravity = {0.0, 0.0, -9.81};
  return build_scene(std::move(scene));
}

/// The hand goes down to the stone, closes the jaws, lifts it, brings it over the organs and down.
HapticSample find_hand(double time) {
  constexpr std::array kTime = {0.0, 0.15, 0.4, 0.9, 1.3, 1.7};
  constexpr std::array kY = {kAside, kAside, kAside, kAside, 0.0, 0.0};
  constexpr std::array kZ = {0.04, 0.0018, 0.0018, 0.1, 0.1, 4.0 * kRadius - 0.012};
  std::size_t n = 1;
  while (n + 1 < kTime.size() && time > kTime[n]) ++n;
  const double part = std::clamp((time - kTime[n - 1]) / (kTime[n] - kTime[n - 1]), 0.0, 1.0);
  HapticSample hand;
  hand.time = time;
  hand.position = {0.0, std::lerp(kY[n - 1], kY[n], part), std::lerp(kZ[n - 1], kZ[n], part)};
  hand.buttons = time >= 0.2 ? kAttachButton : 0;
  return hand;
}

struct Carried {
  double lifted = 0.0;    ///< [m] over the table, of the stone at its highest
  double hand = 0.0;      ///< [N] upwards, at the end
  double on_stone = 0.0;  ///< [N] upwards, of the tissue
  double on_lower = 0.0;  ///< [N] downwards, of the upper organ on the lower one
  double on_table = 0.0;  ///< [N] downwards, of the lower organ
  bool alarm = false;

  bool operator==(const Carried&) const = default;
};

Carried carry(const Scene& scene) {
  World world(scene);
  HapticCommand command;
  Carried felt;
  for (int i = 0; i < 1800; ++i) {
    const HapticSample hand = find_hand(i * kTick);
    tick(scene, {&hand, 1}, kTick, world, {&command, 1});
    felt.alarm = felt.alarm || world.alarm;
    felt.lifted = std::max(felt.lifted, world.rigid[0].position.z());
  }
  felt.hand = command.force.z();
  felt.on_stone = world.rigid[0].tissue_force.z();
  felt.on_lower = -world.body_pairs[0].force.z();
  felt.on_table = world.scenery_contacts[0].force.z();
  return felt;
}

}  // namespace

int main() {
  const Scene scene = make_scene();
  const Carried felt = carry(scene);

  const std::string file =
      (std::filesystem::temp_directory_path() / "palpate_stone_example.palpate").string();
  scenario::Scenario made;
  made.scene = scene;
  made.title = "A stone and two organs";
  scenario::write(file, made);
  const Carried from_file = carry(scenario::read(file).scene);
  std::filesystem::remove(file);

  std::printf("the stone was %.0f mm up; pressed down, it feels %.3f N, the hand %.3f N, ",
              1e3 * felt.lifted, felt.on_stone, felt.hand);
  std::printf("the lower organ %.3f N and the table %.3f N\n", felt.on_lower, felt.on_table);
  std::printf("from a file: %s\n", from_file == felt ? "the same bits" : "something else");
  const bool carried = !felt.alarm && felt.lifted > 0.09 && felt.on_stone > 0.01;
  const bool pressed = felt.on_lower > 0.01 && felt.on_table > 0.01;
  return from_file == felt && carried && pressed ? 0 : 1;
}
