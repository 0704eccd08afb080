// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/kernels.h"
#include "scenes/solids.h"
#include "scenes/walls.h"

/// Jaws at the rim of a slab, by their own hand: closed, drawn outwards, held, let go.
namespace palpate::scenes {

constexpr double kJawRadius = 0.0012, kJawLength = 0.02;  ///< [m] of meshes/tools.toml

/// Two jaws along the tool's z that open along its y.
inline Tool make_grasper(double friction, double grip) {
  constexpr double r = kJawRadius, length = kJawLength;
  Tool tool{.radius = r,
            .stiffness = 3e7,
            .friction = friction,
            .capsules = {{{0, r, 0}, {0, r, length}}, {{0, -r, 0}, {0, -r, length}}}};
  tool.jaws = Jaws{.hinge = {0, 0, length + 2.0 * r}, .grip = grip};
  return tool;
}

/// Two pads as long as these jaws on arms of 100 mm, so that they close all but parallel.
inline Tool make_parallel_grasper(double friction, double grip) {
  Tool tool = make_grasper(friction, grip);
  tool.jaws->hinge = {0, 0, 0.1};
  tool.jaws->open = 0.06;
  return tool;
}

/// A closed slab, x from 0 to `size`[0], y and z about 0, with edges of about `edge` [m]. With
/// `rounds` its rim at the largest x is half a circle of so many pieces, one plane without.
inline SurfaceMesh make_slab(const Vec3& size, double edge, int rounds = 1) {
  SurfaceMesh mesh;
  const double radius = 0.5 * size.z(), end = rounds > 1 ? size.x() - radius : size.x();
  const int nx = static_cast<int>(std::lround(end / edge));
  const int ny = static_cast<int>(std::lround(size.y() / edge));
  const auto id = [&](int i, int j, int face) { return (face * (ny + 1) + j) * (nx + 1) + i; };
  const auto across = [&](int j) { return size.y() * (double(j) / ny - 0.5); };
  for (int face = 0; face < 2; ++face) {
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        mesh.vertices.emplace_back(end * i / nx, across(j), size.z() * (face - 0.5));
      }
    }
  }
  const int flat = static_cast<int>(mesh.vertices.size());
  for (int j = 0; j <= ny; ++j) {
    for (int k = 1; k < rounds; ++k) {
      const double angle = std::numbers::pi * k / rounds;
      mesh.vertices.emplace_back(end + radius * std::sin(angle), across(j),
                                 -radius * std::cos(angle));
    }
  }
  // from the lower face, k = 0, to the upper one
  const auto rim = [&](int k, int j) {
    return k == 0 ? id(nx, j, 0) : k == rounds ? id(nx, j, 1) : flat + j * (rounds - 1) + k - 1;
  };
  const auto add = [&](int a, int b, int c, int d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      add(id(i, j, 1), id(i + 1, j, 1), id(i + 1, j + 1, 1), id(i, j + 1, 1));
      add(id(i, j, 0), id(i, j + 1, 0), id(i + 1, j + 1, 0), id(i + 1, j, 0));
    }
  }
  for (int i = 0; i < nx; ++i) {
    add(id(i, 0, 0), id(i + 1, 0, 0), id(i + 1, 0, 1), id(i, 0, 1));
    add(id(i, ny, 0), id(i, ny, 1), id(i + 1, ny, 1), id(i + 1, ny, 0));
  }
  for (int j = 0; j < ny; ++j) {
    add(id(0, j, 0), id(0, j, 1), id(0, j + 1, 1), id(0, j + 1, 0));
    for (int k = 0; k < rounds; ++k) {
      add(rim(k, j), rim(k, j + 1), rim(k + 1, j + 1), rim(k + 1, j));
    }
  }
  for (int k = 1; k < rounds; ++k) {
    mesh.triangles.push_back({rim(0, 0), rim(k, 0), rim(k + 1, 0)});
    mesh.triangles.push_back({rim(0, ny), rim(k + 1, ny), rim(k, ny)});
  }
  return mesh;
}

/// One tissue under jaws and their hand; of a modulus [Pa] its near field.
inline Scene make_jaw_scene(TissueModel tissue, const Tool& tool, double coupling,
                            double contact_modulus = 0.0, double force_max = 20.0) {
  Scene scene;
  scene.bodies[0].kernel = kernel_under_test();
  scene.bodies[0].tissue = std::move(tissue);
  scene.bodies[0].contact_modulus = contact_modulus;
  scene.instruments[0].tool = tool;
  scene.instruments[0].coupling = {.stiffness = coupling, .force_max = force_max};
  return build_scene(std::move(scene));
}

/// Of [Pa] Young's modulus, nearly incompressible.
inline Material make_jaw_material(double young_modulus, double wall_thickness = 0.0) {
  Material material = make_material({.damping_ratio = 0.3});
  material.young_modulus = young_modulus;
  material.poisson_ratio = 0.45;
  if (wall_thickness > 0.0) material.wall_thickness = wall_thickness;
  return material;
}

/// [Pa] E* of that.
inline double contact_modulus_of(double young_modulus) {
  return young_modulus / (1.0 - 0.45 * 0.45);
}

using BuildSolid = TissueModel (*)(const SolidMesh&, const Material&, const SolidOptions&);

/// A block held at x = 0 [m], under jaws, by its near field.
inline Scene make_held_solid(const Tool& tool, double coupling, BuildSolid build, const Vec3& size,
                             const std::array<int, 3>& cells, double young_modulus, double drag) {
  SolidMesh solid = make_block(size, cells);
  SolidOptions options;
  options.nodal_share = 0.9;
  options.drag = drag;
  for (std::size_t i = 0; i < solid.vertices.size(); ++i) {
    solid.vertices[i].x() += 0.5 * size.x();
    if (solid.vertices[i].x() < 1e-6) options.fixed.push_back(static_cast<int>(i));
  }
  return make_jaw_scene(build(solid, make_jaw_material(young_modulus), options), tool, coupling,
                        contact_modulus_of(young_modulus));
}

/// Springs on home springs, 2 mm thick.
inline Scene make_grasped_mesh(const SurfaceMesh& mesh, const Tool& tool, double coupling,
                               double home = 3e6, double spring = 100.0, double force_max = 20.0) {
  SurfaceOptions options;
  options.home_stiffness = home;
  options.drag = 60.0;
  const Material wall{.density = 1000.0, .damping_ratio = 0.2, .wall_thickness = 0.002};
  return make_jaw_scene(build_mass_spring(mesh, wall, spring, options), tool, coupling, 0.0,
                        force_max);
}

/// Springs on home springs, 30 x 30 x 4 mm; its rim is at x = 30 mm, `rounds` as of make_slab().
inline Scene make_grasped_slab(const Tool& tool, double coupling, double home = 3e6,
                               double spring = 100.0, int rounds = 1) {
  return make_grasped_mesh(make_slab({0.03, 0.03, 0.004}, 0.0015, rounds), tool, coupling, home,
                           spring);
}

/// A flat sheet of springs, 50 x 16 x 6 mm, on home springs that are damped as tissue is.
inline Scene make_grasped_sheet(const Tool& tool, double coupling) {
  constexpr double kThickness = 0.002, kDensity = 1000.0, kDamping = 0.2;
  SurfaceOptions options;
  options.home_stiffness = 1e8;
  options.drag = 2.0 * kDamping * std::sqrt(*options.home_stiffness / (kDensity * kThickness));
  const Material wall{.density = kDensity, .damping_ratio = kDamping, .wall_thickness = kThickness};
  return make_jaw_scene(
      build_mass_spring(make_slab({0.05, 0.016, 0.006}, 0.0015), wall, 100.0, options), tool,
      coupling);
}

/// A wall of prisms, 1.5 mm thick and of 0.1 MPa, on home springs [N/m³].
inline Scene make_prism_scene(const SurfaceMesh& mesh, const Tool& tool, double coupling,
                              double home) {
  constexpr double kYoung = 1e5;
  SurfaceOptions options;
  options.home_stiffness = home;
  options.drag = 60.0;
  return make_jaw_scene(build_shell(mesh, make_jaw_material(kYoung, 0.0015), options), tool,
                        coupling, contact_modulus_of(kYoung));
}

/// The same sheet as a wall of prisms.
inline Scene make_grasped_plate(const Tool& tool, double coupling) {
  return make_prism_scene(make_slab({0.05, 0.016, 0.006}, 0.0015), tool, coupling, 1e8);
}

/// The same bar of solid, 0.1 MPa, with cells of 2 mm, held at x = 0.
inline Scene make_grasped_bar(const Tool& tool, double coupling, BuildSolid build) {
  return make_held_solid(tool, coupling, build, {0.05, 0.016, 0.006}, {25, 8, 3}, 1e5, 200.0);
}

/// A block of 30 x 30 x 10 mm, held at x = 0, with its rim at x = 30 mm, by its near field.
inline Scene make_grasped_block(const Tool& tool, double coupling, BuildSolid build) {
  return make_held_solid(tool, coupling, build, {0.03, 0.03, 0.01}, {6, 6, 2}, 5e3, 30.0);
}

/// A closed wall of prisms, 30 x 24 x 12 mm, its end at x = 30 mm.
inline Scene make_grasped_wall(const Tool& tool, double coupling) {
  SurfaceMesh mesh = make_ellipsoid({0.015, 0.012, 0.006}, 3);
  for (Vec3& x : mesh.vertices) x.x() += 0.015;
  return make_prism_scene(mesh, tool, coupling, 1e6);
}

/// A hand with jaws open along z, which comes to the rim along x and has 12 mm of it between them.
class GraspingHand {
 public:
  explicit GraspingHand(const Scene& scene) : scene_(scene), world_(scene) {
    Mat3 turn;
    turn.col(2) = Vec3::UnitX();
    turn.col(1) = Vec3::UnitZ();
    turn.col(0) = turn.col(1).cross(turn.col(2));
    sample_.orientation = Quaternion(turn);
    sample_.position = Vec3(0.05, 0.0, 0.0);
    go(-0.032, 0.2);
  }

  /// Goes along x by so far [m] within so long [s].
  void go(double way, double time) {
    const int ticks = static_cast<int>(std::lround(time * 1e3));
    const double from = sample_.position.x();
    for (int i = 1; i <= ticks; ++i) {
      sample_.position.x() = from + way * i / ticks;
      step();
    }
  }
  void close() { sample_.buttons = kAttachButton; }
  void open() { sample_.buttons = 0; }
  void wait(double time) { go(0.0, time); }

  Vec3 step() {
    force_ = tick(scene_, sample_, 1e-3, world_).force;
    if (after_tick) after_tick();
    return force_;
  }

  std::function<void()> after_tick;
  const Vec3& force() const { return force_; }
  const World& world() const { return world_; }
  const ToolState& tool() const { return world_.instruments[0].tool; }
  HapticSample& sample() { return sample_; }

 private:
  const Scene& scene_;
  World world_;
  HapticSample sample_;
  Vec3 force_ = Vec3::Zero();
};

}  // namespace palpate::scenes
