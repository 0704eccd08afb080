// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "palpate/sim/dynamics/step.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

namespace {

constexpr int kSteps = 300;

/// A number of steps of one third of the limit, tame enough that rounding stays rounding.
State run(const TissueModel& model, const Load& load, double dt, State state) {
  for (int s = 0; s < kSteps; ++s) step(model, load, dt, state);
  return state;
}

/// Numbers from 0 to count - 1, shuffled, the same every time.
std::vector<int> shuffle(int count) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [](int a, int b) {
    return scenes::scatter(static_cast<std::uint32_t>(a)) <
           scenes::scatter(static_cast<std::uint32_t>(b));
  });
  return order;
}

/// The mesh with old vertex order[i] as new vertex i, its triangles shuffled, and each begun at
/// another corner.
SurfaceMesh reorder(const SurfaceMesh& mesh, const std::vector<int>& order) {
  std::vector<int> place(order.size());
  SurfaceMesh other;
  for (int i = 0; i < static_cast<int>(order.size()); ++i) {
    place[order[i]] = i;
    other.vertices.push_back(mesh.vertices[order[i]]);
  }
  for (const int t : shuffle(static_cast<int>(mesh.triangles.size()))) {
    const Triangle& old = mesh.triangles[t];
    Triangle renamed;
    for (int c = 0; c < 3; ++c) renamed[c] = place[old[(c + t) % 3]];
    other.triangles.push_back(renamed);
  }
  return other;
}

TissueModel build(const SurfaceMesh& mesh, bool molecular) {
  Material material;
  MolecularConstants constants;
  constants.bend_stiffness = 1e-3;
  constants.stretch_coupling = 0.02;
  SurfaceOptions options;
  options.pressure = 50.0;
  return molecular ? build_molecular(mesh, material, constants, options)
                   : build_mass_spring(mesh, material, 60.0, options);
}

}  // namespace

TEST_CASE("a body that is turned and moved as a whole moves the same, turned and moved") {
  const Mat3 turn = Eigen::AngleAxisd(2.2, Vec3(1, 0.4, -0.7).normalized()).toRotationMatrix();
  const Vec3 shift(0.4, -0.2, 0.3);
  const SurfaceMesh mesh = scenes::make_organ_mesh(1);
  SurfaceMesh turned = mesh;
  for (Vec3& x : turned.vertices) x = turn * x + shift;
  for (const bool molecular : {false, true}) {
    CAPTURE(molecular);
    const TissueModel model = build(mesh, molecular), turned_model = build(turned, molecular);
    State start(model), turned_start(turned_model);
    scenes::shake(model, 1e-3, 0.1, start);
    for (std::size_t i = 0; i < start.position.size(); ++i) {
      turned_start.position[i] = turn * start.position[i] + shift;
      turned_start.velocity[i] = turn * start.velocity[i];
    }
    Load load(1), turned_load(1);
    load.gravity = {0, 0, -9.81};
    load.add({3, {0.3, 0.3, 0.4}, {0.02, 0.0, -0.05}});
    turned_load.gravity = turn * load.gravity;
    turned_load.add({3, {0.3, 0.3, 0.4}, turn * load.storage[0].force});
    const double dt = stable_step(model) / 3.0;
    CHECK(stable_step(turned_model) == Approx(3.0 * dt).epsilon(1e-3));

    const State end = run(model, load, dt, start);
    const State turned_end = run(turned_model, turned_load, dt, turned_start);

    const double moved = scenes::max_difference(end.position, start.position);
    CHECK(moved > 1e-4);
    for (std::size_t i = 0; i < end.position.size(); ++i) {
      CHECK((turned_end.position[i] - (turn * end.position[i] + shift)).norm() < 1e-9 * moved);
      CHECK((turned_end.force[i] - turn * end.force[i]).norm() <
            1e-9 * scenes::max_norm(end.force));
    }
  }
}

TEST_CASE("another order of vertices and triangles gives the same motion up to rounding") {
  const SurfaceMesh mesh = scenes::make_organ_mesh(1);
  const std::vector<int> order = shuffle(static_cast<int>(mesh.vertices.size()));
  const SurfaceMesh reordered = reorder(mesh, order);
  REQUIRE(order[0] != 0);
  for (const bool molecular : {false, true}) {
    CAPTURE(molecular);
    const TissueModel model = build(mesh, molecular), other = build(reordered, molecular);
    State start(model), other_start(other);
    scenes::shake(model, 1e-3, 0.1, start);
    for (std::size_t i = 0; i < order.size(); ++i) {
      other_start.position[i] = start.position[order[i]];
      other_start.velocity[i] = start.velocity[order[i]];
    }
    const double dt = stable_step(model) / 3.0;
    CHECK(stable_step(other) == Approx(3.0 * dt).epsilon(1e-3));

    const State end = run(model, Load(), dt, start);
    const State other_end = run(other, Load(), dt, other_start);

    const double moved = scenes::max_difference(end.position, start.position);
    CHECK(moved > 1e-4);
    for (std::size_t i = 0; i < order.size(); ++i) {
      CHECK((other_end.position[i] - end.position[order[i]]).norm() < 1e-9 * moved);
    }
  }
}

TEST_CASE("triangles wound the other way give the same elastic forces, and pressure turns round") {
  const TissueModel model = build(scenes::make_organ_mesh(1), true);
  TissueModel flipped = model;
  for (Triangle& t : flipped.triangles) std::swap(t[1], t[2]);
  for (std::size_t t = 0; t < flipped.angles.corners.size(); ++t) {
    std::swap(flipped.angles.corners[t][1], flipped.angles.corners[t][2]);
    for (auto* column :
         {&flipped.angles.rest_cosine, &flipped.angles.rest_length, &flipped.angles.bend_stiffness,
          &flipped.angles.stretch_coupling, &flipped.angles.bond_share}) {
      std::swap((*column)[t][1], (*column)[t][2]);
    }
  }
  flipped.pressure = -model.pressure;
  State start(model);
  scenes::shake(model, 1e-3, 0.1, start);
  const double dt = stable_step(model) / 3.0;

  const State end = run(model, Load(), dt, start);
  const State flipped_end = run(flipped, Load(), dt, start);

  const double moved = scenes::max_difference(end.position, start.position);
  CHECK(scenes::max_difference(end.position, flipped_end.position) < 1e-9 * moved);
}
