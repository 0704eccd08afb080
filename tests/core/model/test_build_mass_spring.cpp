// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <functional>
#include <limits>

#include "core/model/refusal.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/model/build_surface.h"
#include "scenes/scenes.h"

using namespace palpate;
using doctest::Approx;

namespace {

const SurfaceMesh kSolid = scenes::make_ellipsoid({0.05, 0.035, 0.03}, 2);
const SurfaceMesh kSheet = scenes::make_sheet(6, 5, 0.1);
const SurfaceMesh kTube = scenes::make_tube(0.02, 0.08, 12, 7);

Material make_wall(double thickness) {
  Material material;
  material.wall_thickness = thickness;
  return material;
}

}  // namespace

TEST_CASE("a closed solid weighs density times volume") {
  const TissueModel model = build_mass_spring(kSolid, {.density = 1000.0}, 50.0);

  CHECK(compute_total_mass(model) == Approx(1000.0 * compute_volume(kSolid)));
}

TEST_CASE("hollow organs and open surfaces weigh density times wall thickness times area") {
  Material material = make_wall(2e-3);
  material.density = 1000.0;

  for (const SurfaceMesh& mesh : {kSolid, kSheet, kTube}) {
    CHECK(compute_total_mass(build_mass_spring(mesh, material, 50.0)) ==
          Approx(2.0 * compute_area(mesh)));
  }
}

TEST_CASE("the mass of a vertex is in proportion to the area around it") {
  const std::vector<double> areas = compute_vertex_areas(kSolid);
  const std::vector<double> mass = compute_lumped_mass(kSolid, {});

  for (std::size_t i = 0; i < mass.size(); ++i) {
    CHECK(mass[i] / mass[0] == Approx(areas[i] / areas[0]));
  }
}

TEST_CASE("an open surface without a wall thickness is refused, and so is a solid inside out") {
  CHECK(find_refusal([] { build_mass_spring(kSheet, {}, 50.0); }) ==
        "material: wall_thickness: got none for an open surface, expected the thickness of the "
        "wall [m], since what is open encloses no volume");

  SurfaceMesh inside_out = kSolid;
  for (Triangle& t : inside_out.triangles) std::swap(t[0], t[1]);
  CHECK(find_refusal([&] {
          build_mass_spring(inside_out, {}, 50.0);
        }).find("mesh: volume: got -") == 0);
}

TEST_CASE("there is one spring along every edge, at rest where the surface is") {
  const TissueModel model = build_mass_spring(kTube, make_wall(2e-3), 50.0);

  CHECK(model.springs.ends == build_topology(kTube.triangles).edges);
  CHECK(model.bonds.ends.empty());
  CHECK(model.angles.corners.empty());
  for (std::size_t l = 0; l < model.springs.ends.size(); ++l) {
    const auto [i, j] = model.springs.ends[l];
    CHECK(model.springs.stiffness[l] == 50.0);
    CHECK(model.springs.rest_length[l] == (kTube.vertices[i] - kTube.vertices[j]).norm());
  }
}

TEST_CASE("a spring is damped in proportion to what is critical for its two end masses") {
  Material material = make_wall(1e-3);
  material.density = 1000.0;
  material.damping_ratio = 0.25;
  // one triangle of 6 m²: each corner weighs 2 kg, two of them swing like 1 kg
  const SurfaceMesh triangle = {{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}}};

  const TissueModel model = build_mass_spring(triangle, material, 9.0);

  // 2 x 0.25 x sqrt(9 N/m x 1 kg) = 1.5 N s/m
  CHECK(model.mass == std::vector<double>{2.0, 2.0, 2.0});
  for (const double damping : model.springs.damping) CHECK(damping == Approx(1.5));
}

TEST_CASE("the membrane's spring stiffness is sqrt(3)/2 E h, and needs a wall") {
  Material material = make_wall(2e-3);
  material.young_modulus = 10e3;

  CHECK(membrane_spring_stiffness(material) == Approx(17.3205));
  CHECK(find_refusal([] { membrane_spring_stiffness({}); }) ==
        "material: wall_thickness: got none, expected the thickness of the membrane [m]");
}

TEST_CASE("home springs are on for sheets and hollow organs, off for solids") {
  CHECK(build_mass_spring(kSolid, {}, 50.0).home.empty());
  CHECK(build_mass_spring(kSolid, make_wall(2e-3), 50.0).home.size() == kSolid.vertices.size());
  CHECK(build_mass_spring(kSheet, make_wall(2e-3), 50.0).home.size() == kSheet.vertices.size());
}

TEST_CASE("a home spring is the stiffness per area times the area of its vertex") {
  Material material = make_wall(2e-3);
  material.young_modulus = 5e3;
  // the sheet's diagonal is sqrt(2) x 0.1 m, so E h / d² = 10 N/m / 2e-4 m² = 50 000 N/m³
  CHECK(default_home_stiffness(kSheet, material) == Approx(50e3));

  const std::vector<double> areas = compute_vertex_areas(kSheet);
  const TissueModel by_default = build_mass_spring(kSheet, material, 50.0);
  const TissueModel chosen = build_mass_spring(kSheet, material, 50.0, {.home_stiffness = 1e3});
  for (std::size_t i = 0; i < areas.size(); ++i) {
    CHECK(by_default.home[i] == Approx(50e3 * areas[i]));
    CHECK(chosen.home[i] == Approx(1e3 * areas[i]));
  }
  CHECK(build_mass_spring(kSheet, material, 50.0, {.home_stiffness = 0.0}).home.empty());
}

TEST_CASE("held vertices come out ascending and once, whatever order they are named in") {
  const TissueModel model = build_mass_spring(kSolid, {}, 50.0, {.fixed = {9, 3, 9, 0}});

  CHECK(model.fixed == std::vector<int>{0, 3, 9});
}

TEST_CASE("a spring takes the mean of the local scales of its ends, a home spring its own") {
  SurfaceOptions options = {.home_stiffness = 1e3};
  options.stiffness_scale.assign(kSolid.vertices.size(), 1.0);
  options.stiffness_scale[7] = 3.0;

  const TissueModel plain = build_mass_spring(kSolid, {}, 50.0, {.home_stiffness = 1e3});
  const TissueModel scaled = build_mass_spring(kSolid, {}, 50.0, options);

  for (std::size_t l = 0; l < plain.springs.ends.size(); ++l) {
    const bool at_stiff_vertex = plain.springs.ends[l][0] == 7 || plain.springs.ends[l][1] == 7;
    CHECK(scaled.springs.stiffness[l] == (at_stiff_vertex ? 100.0 : 50.0));
  }
  CHECK(scaled.home[7] == Approx(3.0 * plain.home[7]));
  CHECK(scaled.home[8] == plain.home[8]);
}

TEST_CASE("a scale of 1 everywhere changes nothing") {
  SurfaceOptions options;
  options.stiffness_scale.assign(kTube.vertices.size(), 1.0);
  const Material material = make_wall(2e-3);

  const TissueModel plain = build_mass_spring(kTube, material, 50.0);
  const TissueModel scaled = build_mass_spring(kTube, material, 50.0, options);

  CHECK(scaled.springs.stiffness == plain.springs.stiffness);
  CHECK(scaled.springs.damping == plain.springs.damping);
  CHECK(scaled.home == plain.home);
}

TEST_CASE(
    "every parameter that can be set changes the mass-spring model, and only what it should") {
  struct Parameters {
    Material material = make_wall(2e-3);
    double stiffness = 50.0;
    SurfaceOptions options;
  };
  const auto build = [](const std::function<void(Parameters&)>& change) {
    Parameters p;
    change(p);
    return build_mass_spring(kTube, p.material, p.stiffness, p.options);
  };
  const TissueModel before = build([](Parameters&) {});

  TissueModel after = build([](Parameters& p) { p.material.density *= 4.0; });
  CHECK(after.mass[5] == Approx(4.0 * before.mass[5]));
  CHECK(after.springs.damping[5] == Approx(2.0 * before.springs.damping[5]));
  CHECK(after.home == before.home);

  after = build([](Parameters& p) { p.material.young_modulus *= 2.0; });
  CHECK(after.home[5] == Approx(2.0 * before.home[5]));
  CHECK(after.springs.stiffness == before.springs.stiffness);

  after = build([](Parameters& p) { p.material.damping_ratio *= 2.0; });
  CHECK(after.springs.damping[5] == Approx(2.0 * before.springs.damping[5]));

  after = build([](Parameters& p) { p.material.wall_thickness = 6e-3; });
  CHECK(after.mass[5] == Approx(3.0 * before.mass[5]));
  CHECK(after.home[5] == Approx(3.0 * before.home[5]));

  after = build([](Parameters& p) { p.stiffness *= 4.0; });
  CHECK(after.springs.stiffness[5] == Approx(4.0 * before.springs.stiffness[5]));
  CHECK(after.springs.damping[5] == Approx(2.0 * before.springs.damping[5]));

  after = build([](Parameters& p) { p.options.fixed = {1}; });
  CHECK(after.fixed == std::vector<int>{1});
  after = build([](Parameters& p) { p.options.pressure = 100.0; });
  CHECK(after.pressure == 100.0);
  after = build([](Parameters& p) { p.options.drag = 7.0; });
  CHECK(after.drag == 7.0);
  after = build([](Parameters& p) { p.options.damping_law = DampingLaw::isotropic; });
  CHECK(after.damping_law == DampingLaw::isotropic);
}

TEST_CASE("what cannot be built is refused by name") {
  const auto refuse_options = [](SurfaceOptions options) {
    return find_refusal([&] { build_mass_spring(kSolid, {}, 50.0, options); });
  };
  SurfaceOptions scale;
  scale.stiffness_scale.assign(kSolid.vertices.size(), 1.0);
  scale.stiffness_scale[4] = 0.0;

  CHECK(find_refusal([] { build_mass_spring(kSolid, {}, -1.0); }) ==
        "mass-spring: stiffness: got -1 N/m, expected a positive number");
  CHECK(find_refusal([] { build_mass_spring({}, {}, 1.0); }).find("mesh: ") == 0);
  CHECK(find_refusal([] {
          build_mass_spring(kSolid, {.density = 0.0}, 1.0);
        }).find("material: density") == 0);
  CHECK(refuse_options({.fixed = {3, 162}}) ==
        "options: fixed: row 1: got vertex 162, expected 0 to 161");
  CHECK(refuse_options({.home_stiffness = -1.0}) ==
        "options: home_stiffness: got -1 N/m³, expected 0 or a positive number");
  CHECK(refuse_options({.stiffness_scale = {1.0, 1.0}}) ==
        "options: stiffness_scale: got 2 rows, expected none, or one per vertex: 162");
  CHECK(refuse_options(scale) ==
        "options: stiffness_scale: row 4: got 0, expected a positive number");
  CHECK(refuse_options({.drag = -1.0}) ==
        "options: drag: got -1 1/s, expected 0 or a positive number");
  CHECK(refuse_options({.pressure = std::numeric_limits<double>::infinity()}) ==
        "options: pressure: got inf Pa, expected a finite number");
}
