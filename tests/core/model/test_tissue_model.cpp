// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/model/refusal.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/model/tissue_model.h"
#include "scenes/scenes.h"

using namespace palpate;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A molecular sheet of 9 particles, 16 bonds and 8 triangles with a table of everything.
TissueModel make_sound_model() {
  const SurfaceMesh sheet = scenes::make_sheet(3, 3, 0.02);
  Material material;
  material.wall_thickness = 2e-3;
  TissueModel model = build_molecular(
      sheet, material, {.bond_stiffness = 50.0, .bend_stiffness = 1e-4}, {.fixed = {0, 2}});
  model.springs = {{{0, 8}}, {0.028}, {10.0}, {0.01}};
  return model;
}

struct Damage {
  std::function<void(TissueModel&)> act;
  std::string where;  ///< how the refusal must begin
};

}  // namespace

TEST_CASE("a sound model is accepted") {
  CHECK_NOTHROW(validate(make_sound_model()));
  CHECK_NOTHROW(validate(scenes::make_chain_model(5)));
  CHECK_NOTHROW(validate(scenes::make_oscillator_model()));
}

TEST_CASE("every damage to a model is refused with the name of its table and row") {
  const std::vector<Damage> damages = {
      {[](TissueModel& m) { m = {}; }, "model: rest_position: got no particles"},
      {[](TissueModel& m) { m.rest_position[4].z() = kNan; }, "model: rest_position: row 4: got "},
      {[](TissueModel& m) { m.mass.pop_back(); }, "model: mass: got 8 rows, expected 9"},
      {[](TissueModel& m) { m.mass[3] = 0.0; }, "model: mass: row 3: got 0 kg"},
      {[](TissueModel& m) { m.mass[3] = kNan; }, "model: mass: row 3: got nan kg"},
      {[](TissueModel& m) { m.home.pop_back(); }, "model: home: got 8 rows, expected 9"},
      {[](TissueModel& m) { m.home[2] = -1.0; }, "model: home: row 2: got -1 N/m"},
      {[](TissueModel& m) { m.fixed = {9}; }, "model: fixed: row 0: got particle 9"},
      {[](TissueModel& m) { m.fixed = {-1}; }, "model: fixed: row 0: got particle -1"},
      {[](TissueModel& m) {
         m.fixed = {4, 3};
       },
       "model: fixed: row 1: got 3 after 4"},
      {[](TissueModel& m) {
         m.fixed = {4, 4};
       },
       "model: fixed: row 1: got 4 after 4"},
      {[](TissueModel& m) { m.springs.rest_length.push_back(1.0); },
       "model: springs.rest_length: got 2 rows, expected 1"},
      {[](TissueModel& m) { m.springs.stiffness.clear(); },
       "model: springs.stiffness: got 0 rows, expected 1"},
      {[](TissueModel& m) { m.springs.damping.clear(); },
       "model: springs.damping: got 0 rows, expected 1"},
      {[](TissueModel& m) {
         m.springs.ends[0] = {8, 0};
       },
       "model: springs.ends: row 0: got 8, 0"},
      {[](TissueModel& m) {
         m.springs.ends[0] = {3, 3};
       },
       "model: springs.ends: row 0: got 3, 3"},
      {[](TissueModel& m) {
         m.springs.ends[0] = {3, 9};
       },
       "model: springs.ends: row 0: got 3, 9"},
      {[](TissueModel& m) {
         m.springs.ends[0] = {-1, 3};
       },
       "model: springs.ends: row 0: got -1, 3"},
      {[](TissueModel& m) { m.springs.rest_length[0] = 0.0; },
       "model: springs.rest_length: row 0: got 0 m"},
      {[](TissueModel& m) { m.springs.stiffness[0] = -1.0; },
       "model: springs.stiffness: row 0: got -1 N/m"},
      {[](TissueModel& m) { m.springs.damping[0] = -1.0; },
       "model: springs.damping: row 0: got -1 N·s/m"},
      {[](TissueModel& m) { m.bonds.stiffness[5] = kNan; },
       "model: bonds.stiffness: row 5: got nan N/m"},
      {[](TissueModel& m) { m.bonds.stiffness[5] += 1.0; }, "model: bonds.stiffness: row 5: got "},
      {[](TissueModel& m) { m.bonds.rest_length[5] = -1.0; },
       "model: bonds.rest_length: row 5: got -1 m"},
      {[](TissueModel& m) { m.bonds.ends[1] = m.bonds.ends[0]; },
       "model: bonds.stiffness: row 1: got a second bond along the same side"},
      {[](TissueModel& m) { m.bonds = {}; }, "model: angles.bond_share: row "},
      {[](TissueModel& m) { m.angles.rest_cosine.pop_back(); },
       "model: angles.rest_cosine: got 7 rows, expected 8"},
      {[](TissueModel& m) { m.angles.rest_length.pop_back(); },
       "model: angles.rest_length: got 7 rows, expected 8"},
      {[](TissueModel& m) { m.angles.bend_stiffness.pop_back(); },
       "model: angles.bend_stiffness: got 7 rows, expected 8"},
      {[](TissueModel& m) { m.angles.stretch_coupling.pop_back(); },
       "model: angles.stretch_coupling: got 7 rows, expected 8"},
      {[](TissueModel& m) { m.angles.bond_share.pop_back(); },
       "model: angles.bond_share: got 7 rows, expected 8"},
      {[](TissueModel& m) { m.angles.corners[6][0] = 9; }, "model: angles.corners: row 6: got 9, "},
      {[](TissueModel& m) { m.angles.corners[6][0] = m.angles.corners[6][1]; },
       "model: angles.corners: row 6: got "},
      {[](TissueModel& m) { m.angles.rest_cosine[6][0] = 1.0; },
       "model: angles.rest_cosine: row 6: got 1, expected between -1 and 1"},
      {[](TissueModel& m) { m.angles.rest_cosine[6][0] += 0.01; },
       "model: angles.rest_cosine: row 6: got "},
      {[](TissueModel& m) { m.angles.rest_length[6][0] = 0.0; },
       "model: angles.rest_length: row 6: got 0 m"},
      {[](TissueModel& m) { m.angles.bend_stiffness[6][2] = kNan; },
       "model: angles.bend_stiffness: row 6: got nan J"},
      {[](TissueModel& m) { m.angles.stretch_coupling[6][1] = kNan; },
       "model: angles.stretch_coupling: row 6: got nan N"},
      {[](TissueModel& m) { m.angles.bond_share[6][1] = kNan; },
       "model: angles.bond_share: row 6: got nan N/m"},
      {[](TissueModel& m) {
         m.angles.stretch_coupling[6] = {-9.0, -9.0, -9.0};
       },
       "model: angles: row 6 (particles "},
      {[](TissueModel& m) { m.triangles[7][1] = 9; }, "model: triangles: row 7: got "},
      {[](TissueModel& m) { m.pressure = kNan; }, "model: pressure: got nan Pa"},
      {[](TissueModel& m) { m.drag = -2.0; }, "model: drag: got -2 1/s"},
  };

  for (const Damage& damage : damages) {
    TissueModel model = make_sound_model();
    damage.act(model);

    const std::string refusal = find_refusal([&] { validate(model); });

    CAPTURE(damage.where);
    CAPTURE(refusal);
    CHECK(refusal.rfind(damage.where, 0) == 0);
    CHECK(refusal.find(", expected ") != std::string::npos);
  }
}

TEST_CASE("a negative bond without triangles is refused, a positive one accepted") {
  TissueModel model = scenes::make_chain_model(3);
  std::swap(model.springs, model.bonds);
  CHECK_NOTHROW(validate(model));

  model.bonds.stiffness[1] = -1.0;
  CHECK(find_refusal([&] { validate(model); }) ==
        "model: bonds.stiffness: row 1: got -1 N/m outside of every triangle, expected 0 or a "
        "positive number");
}

TEST_CASE("the description counts everything and tells the total mass") {
  const TissueModel model = make_sound_model();

  // 1060 kg/m³ x 2 mm x (20 mm)² = 0.848 g
  CHECK(compute_total_mass(model) == doctest::Approx(0.848e-3));
  CHECK(describe(model) ==
        "9 particles, 2 of them held; 1 springs, 16 bonds, 24 angles, home springs; "
        "total mass 0.848 g");
}
