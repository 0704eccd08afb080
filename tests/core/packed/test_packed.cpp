// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/packed/simd_targets.h"
#include "scenes/shells.h"
#include "scenes/solids.h"
#include "skip.h"

using namespace palpate;

namespace {

/// An open tube, softer towards one end, as a molecular or mass-spring model.
TissueModel make_painted_tube(bool molecular) {
  const SurfaceMesh mesh = scenes::make_tube(0.015, 0.06, 20, 16);
  const Material material{.damping_ratio = 0.2, .wall_thickness = 2e-3};
  SurfaceOptions options;
  options.home_stiffness = 2e5;
  options.fixed = {0, 1, 2, 319};
  for (const Vec3& x : mesh.vertices) options.stiffness_scale.push_back(0.4 + 20.0 * x.z());
  if (!molecular) return build_mass_spring(mesh, material, 40.0, options);
  return build_molecular(
      mesh, material, {.bond_stiffness = 40.0, .bend_stiffness = 2e-5, .stretch_coupling = 0.005},
      options);
}

/// A sheet of exact membrane in long triangles, some of whose bonds are negative.
TissueModel make_long_membrane(AngleLaw law) {
  SurfaceMesh mesh = scenes::make_sheet(8, 12, 0.05);
  for (Vec3& x : mesh.vertices) x.x() *= 3.0;
  const Material wall{
      .young_modulus = 5e4, .poisson_ratio = 0.5, .damping_ratio = 0.2, .wall_thickness = 2e-3};
  SurfaceOptions options;
  options.fixed = {0, 1, 2};
  const TissueModel model = build_membrane_molecular(mesh, wall, 0.0, law, options);
  REQUIRE((law == AngleLaw::eq10 || std::ranges::min(model.bonds.stiffness) < 0.0));
  return model;
}

/// Every model kind and law, open and closed, with and without each kind of loss.
std::vector<TissueModel> make_every_tissue() {
  const scenes::Losses axis = {.damping_ratio = 0.2, .drag = 3.0};
  const scenes::Losses isotropic = {0.2, 0.0, DampingLaw::isotropic};
  std::vector<TissueModel> tissues = {
      scenes::make_spring_organ(2),
      scenes::make_spring_organ(2, axis),
      scenes::make_spring_organ(2, isotropic),
      scenes::make_molecular_organ(2),
      scenes::make_molecular_organ(2, axis),
      scenes::make_molecular_organ(2, isotropic),
      scenes::make_molecular_organ(2, {}, AngleLaw::eq10),
      scenes::make_molecular_organ(2, axis, AngleLaw::eq10),
      scenes::make_sheet_tissue(axis),
      scenes::make_hollow_tissue(axis),
      make_painted_tube(false),
      make_painted_tube(true),
      scenes::make_oscillator_model(),
      scenes::make_chain_model(40, 1e-3, 100.0, 0.05, 2e-3),
  };
  for (const double share : {0.0, 0.7, 1.0}) {
    tissues.push_back(scenes::make_solid_organ(5, share, axis));
    tissues.push_back(scenes::make_covered_organ(4, share, isotropic));
  }
  tissues.push_back(scenes::make_shell_organ(2, {}));
  tissues.push_back(scenes::make_shell_organ(2, axis));
  tissues.push_back(scenes::make_shell_organ(1, isotropic));
  tissues.push_back(scenes::make_damped_prism());
  // a bond beside the triangles, and home springs under a molecular model
  TissueModel odd = scenes::make_molecular_organ(1, axis);
  odd.bonds.ends.push_back({0, 40});
  odd.bonds.rest_length.push_back((odd.rest_position[40] - odd.rest_position[0]).norm());
  odd.bonds.stiffness.push_back(20.0);
  odd.bonds.damping.push_back(0.02);
  odd.home.assign(odd.mass.size(), 5.0);
  odd.pressure = 300.0;
  tissues.push_back(odd);
  // damped triangles beside links that are not
  odd.bonds.damping.back() = 0.0;
  tissues.push_back(std::move(odd));
  return tissues;
}

/// A tissue off its rest by up to `size` [m] along each axis, and in motion.
State shake(const TissueModel& model, double size, double speed) {
  State state(model);
  scenes::shake(model, size, speed, state);
  return state;
}

Load make_load(const TissueModel& model) {
  Load load(8);
  load.gravity = {0.5, -1.0, -9.81};
  const auto triangles = static_cast<int>(model.triangles.size());
  for (int p = 0; p < 4 && triangles > 0; ++p) {
    load.add({p * 7 % triangles, {0.2, 0.3, 0.5}, {0.01, -0.02, 0.03}});
  }
  return load;
}

/// Forces as a packed step sees them: what a step so long that nothing else counts adds to m v.
Vec3Array compute_packed_forces(const PackedModel& packed, const TissueModel& model,
                                const Load& load, const State& state) {
  PackedState running(packed, model, state);
  constexpr double kLong = 1.0;
  step(packed, load, kLong, running);
  State after(model);
  unpack(packed, model, running, after);
  Vec3Array forces(model.mass.size());
  for (std::size_t i = 0; i < forces.size(); ++i) {
    forces[i] = model.mass[i] / kLong * (after.velocity[i] - state.velocity[i]);
  }
  return forces;
}

State run_packed(const PackedModel& packed, const TissueModel& model, const Load& load,
                 const State& start, double dt, int steps) {
  PackedState running(packed, model, start);
  for (int s = 0; s < steps; ++s) step(packed, load, dt, running);
  State after(model);
  unpack(packed, model, running, after);
  return after;
}

}  // namespace

TEST_CASE("packed forces are the reference's to 1e-5 on every model kind and vector target") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  const auto tissues = make_every_tissue();
  for (std::size_t t = 0; t < tissues.size(); ++t) {
    const TissueModel& model = tissues[t];
    const State state = shake(model, 5e-4, 0.05);
    const Load load = make_load(model);
    Vec3Array expected(model.mass.size());
    compute_forces(model, load, state.position, state.velocity, expected);
    for (const int i : model.fixed) expected[i].setZero();
    for (const std::string& target : simd_targets()) {
      CAPTURE(t);
      CAPTURE(target);
      const Vec3Array found = compute_packed_forces(pack(model, target), model, load, state);

      CHECK(scenes::max_difference(found, expected) < 1e-5 * scenes::max_norm(expected));
    }
  }
}

TEST_CASE(
    "an exact membrane of long triangles, whose terms cancel, keeps four digits when packed") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  for (const AngleLaw law : {AngleLaw::gradient, AngleLaw::eq10}) {
    const TissueModel model = make_long_membrane(law);
    const Load load = make_load(model);
    const State state = shake(model, 5e-4, 0.05);
    Vec3Array expected(model.mass.size());
    compute_forces(model, load, state.position, state.velocity, expected);
    for (const int i : model.fixed) expected[i].setZero();
    for (const std::string& target : simd_targets()) {
      CAPTURE(target);
      const Vec3Array found = compute_packed_forces(pack(model, target), model, load, state);
      CHECK(scenes::max_difference(found, expected) < 1e-4 * scenes::max_norm(expected));
    }
  }
}

TEST_CASE("after 0.1 s a packed tissue is where the reference is, to 1e-4 mm") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  const auto tissues = make_every_tissue();
  for (std::size_t t = 0; t < tissues.size(); ++t) {
    const TissueModel& model = tissues[t];
    // without losses a shell amplifies any difference: two runs in double do not agree either
    const bool lossless = model.drag == 0.0 && model.damping_law == DampingLaw::axis;
    if (lossless && model.mass.size() > 40) continue;
    const double dt = 0.5 * stable_step(model);
    const int steps = static_cast<int>(0.1 / dt);
    const State start = shake(model, 2e-5, 0.01);
    // a tenth of gravity: under all of it the organs without home springs sag beyond any use
    Load load = make_load(model);
    load.gravity *= 0.1;
    State reference = start;
    for (int s = 0; s < steps; ++s) step(model, load, dt, reference);
    for (const std::string& target : simd_targets()) {
      CAPTURE(t);
      CAPTURE(target);
      const State packed = run_packed(pack(model, target), model, load, start, dt, steps);

      CHECK(scenes::max_difference(packed.position, reference.position) < 1e-7);
    }
  }
}

TEST_CASE("a packed tissue without home and support keeps its momentum") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  for (TissueModel model : {scenes::make_spring_organ(2, {.damping_ratio = 0.2}),
                            scenes::make_molecular_organ(2, {.damping_ratio = 0.2}),
                            scenes::make_shell_organ(2, {.damping_ratio = 0.2})}) {
    model.fixed.clear();
    const State start = shake(model, 3e-4, 0.1);
    const auto momentum = [&](const State& state) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t i = 0; i < model.mass.size(); ++i) sum += model.mass[i] * state.velocity[i];
      return sum;
    };
    double size = 0.0;
    for (std::size_t i = 0; i < model.mass.size(); ++i) {
      size += model.mass[i] * start.velocity[i].norm();
    }
    const double dt = 0.5 * stable_step(model);

    const State after = run_packed(pack(model), model, Load(), start, dt, 1000);

    CHECK((momentum(after) - momentum(start)).norm() < 1e-5 * size);
  }
}

TEST_CASE("a packed step is stable at 0.98 of the exact limit and not at 1.05") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  const TissueModel model = scenes::make_oscillator_model(1e-3, 100.0);
  const double limit = 2.0 / std::sqrt(100.0 / 1e-3);
  State start(model);
  start.position[1].x() += 1e-5;

  const State below = run_packed(pack(model), model, Load(), start, 0.98 * limit, 2000);
  const State above = run_packed(pack(model), model, Load(), start, 1.05 * limit, 40);

  CHECK(std::abs(below.position[1].x() - model.rest_position[1].x()) < 1e-4);
  CHECK(std::abs(above.position[1].x() - model.rest_position[1].x()) > 1e-3);
}

TEST_CASE("a packed run gives the same bits twice") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  for (const TissueModel& model : {scenes::make_molecular_organ(2, {.damping_ratio = 0.2}),
                                   scenes::make_shell_organ(2, {.damping_ratio = 0.2})}) {
    const State start = shake(model, 1e-4, 0.02);
    const double dt = 0.5 * stable_step(model);

    const State once = run_packed(pack(model), model, make_load(model), start, dt, 500);
    const State again = run_packed(pack(model), model, make_load(model), start, dt, 500);

    CHECK(once.position == again.position);
    CHECK(once.velocity == again.velocity);
  }
}

TEST_CASE("collapsed triangles and links feel the reference's forces") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.2});
  model.fixed.clear();
  State state = shake(model, 2e-4, 0.02);
  const auto [a, b, c] = model.angles.corners[5];
  for (const double part : {0.28, 0.1, 0.03, 1e-3, 0.0}) {
    state.position[b] =
        state.position[a] + part * (model.rest_position[b] - model.rest_position[a]);
    Vec3Array expected(model.mass.size());
    compute_forces(model, Load(), state.position, state.velocity, expected);

    const Vec3Array found = compute_packed_forces(pack(model), model, Load(), state);

    // where two corners meet a float cannot tell their direction
    const double tolerance = part == 1e-3 ? 1e-2 : 1e-4;
    CHECK(scenes::max_difference(found, expected) < tolerance * scenes::max_norm(expected));
  }
}

TEST_CASE("a link of no length pulls nowhere when packed, and a held particle stays held") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  TissueModel model = scenes::make_chain_model(3);
  State state(model);
  state.position[1] = state.position[0];
  state.position[2] = state.position[0] + Vec3(0.01, 0.0, 0.0);
  state.velocity[0] = Vec3(1.0, 0.0, 0.0);

  const State after = run_packed(pack(model), model, Load(), state, 1e-4, 1);

  CHECK(after.position[0] == model.rest_position[0]);
  CHECK(after.velocity[0] == Vec3::Zero());
  CHECK(after.velocity[1].norm() < 1e-6);
}

TEST_CASE("every particle has a row of its own, and packing refuses an unknown target") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  const TissueModel model = scenes::make_molecular_organ(2);
  const PackedModel packed = pack(model);

  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    CHECK(packed.particle[packed.row[i]] == static_cast<int>(i));
  }
  CHECK(simd_target(packed) == simd_targets().front());
  CHECK_THROWS_AS(pack(model, "MMX"), std::invalid_argument);
}
