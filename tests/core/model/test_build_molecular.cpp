// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <sstream>

#include "core/model/refusal.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/model/build_surface.h"
#include "scenes/scenes.h"

using namespace palpate;
using doctest::Approx;

namespace {

const SurfaceMesh kSolid = scenes::make_ellipsoid({0.05, 0.035, 0.03}, 2);
const SurfaceMesh kSheet = scenes::make_sheet(6, 5, 0.1);

Material make_wall() {
  Material material;
  material.wall_thickness = 2e-3;
  return material;
}

std::string refuse_coupling(const SurfaceMesh& mesh, double coupling) {
  return find_refusal([&] {
    build_molecular(mesh, make_wall(),
                    {.bond_stiffness = 50.0, .bend_stiffness = 1e-5, .stretch_coupling = coupling});
  });
}

/// The two numbers of a refusal that ends in "expected LOW to HIGH N on this mesh".
std::array<double, 2> read_range(const std::string& refusal) {
  std::istringstream text(refusal.substr(refusal.find("expected ") + 9));
  double low = 0.0, high = 0.0;
  std::string to;
  text >> low >> to >> high;
  REQUIRE(to == "to");
  return {low, high};
}

}  // namespace

TEST_CASE("a bond inside the surface has K_b, one at its border half") {
  const TissueModel model = build_molecular(kSheet, make_wall(), {.bond_stiffness = 50.0});
  const Topology topology = build_topology(kSheet.triangles);

  CHECK(model.springs.ends.empty());
  CHECK(model.bonds.ends == topology.edges);
  for (std::size_t l = 0; l < topology.edges.size(); ++l) {
    CHECK(model.bonds.stiffness[l] == (topology.edge_triangles[l][1] < 0 ? 25.0 : 50.0));
  }
}

TEST_CASE("the angle table holds the sides and cosines of every triangle as it lies") {
  const TissueModel model = build_molecular(kSolid, {}, {});

  CHECK(model.angles.corners == kSolid.triangles);
  for (std::size_t a = 0; a < kSolid.triangles.size(); ++a) {
    for (int c = 0; c < 3; ++c) {
      const Vec3 u = kSolid.vertices[kSolid.triangles[a][(c + 1) % 3]] -
                     kSolid.vertices[kSolid.triangles[a][c]];
      const Vec3 v = kSolid.vertices[kSolid.triangles[a][(c + 2) % 3]] -
                     kSolid.vertices[kSolid.triangles[a][c]];
      CHECK(model.angles.rest_length[a][c] == Approx((u - v).norm()));
      CHECK(model.angles.rest_cosine[a][c] == Approx(u.dot(v) / (u.norm() * v.norm())));
    }
  }
}

TEST_CASE("a triangle takes the mean of the local scales of its corners, its bonds of their ends") {
  SurfaceOptions options;
  options.stiffness_scale.assign(kSolid.vertices.size(), 1.0);
  options.stiffness_scale[7] = 4.0;
  const MolecularConstants constants = {
      .bond_stiffness = 50.0, .bend_stiffness = 1e-4, .stretch_coupling = 1e-3};

  const TissueModel model = build_molecular(kSolid, {}, constants, options);

  for (std::size_t a = 0; a < model.angles.corners.size(); ++a) {
    const Triangle& t = model.angles.corners[a];
    const double scale = t[0] == 7 || t[1] == 7 || t[2] == 7 ? 2.0 : 1.0;
    for (int c = 0; c < 3; ++c) {
      const bool side_at_7 = t[(c + 1) % 3] == 7 || t[(c + 2) % 3] == 7;
      CHECK(model.angles.bend_stiffness[a][c] == Approx(1e-4 * scale));
      CHECK(model.angles.stretch_coupling[a][c] == Approx(1e-3 * scale));
      CHECK(model.angles.bond_share[a][c] == Approx(side_at_7 ? 62.5 : 25.0));
    }
  }
}

TEST_CASE("every parameter that can be set changes the molecular model, and only what it should") {
  struct Parameters {
    Material material = make_wall();
    MolecularConstants constants = {
        .bond_stiffness = 50.0, .bend_stiffness = 1e-4, .stretch_coupling = 1e-3};
    SurfaceOptions options;
  };
  const auto build = [](const std::function<void(Parameters&)>& change) {
    Parameters p;
    change(p);
    return build_molecular(kSheet, p.material, p.constants, p.options);
  };
  const TissueModel before = build([](Parameters&) {});

  TissueModel after = build([](Parameters& p) { p.constants.bond_stiffness *= 4.0; });
  CHECK(after.bonds.stiffness[5] == Approx(4.0 * before.bonds.stiffness[5]));
  CHECK(after.bonds.damping[5] == Approx(2.0 * before.bonds.damping[5]));
  CHECK(after.angles.bend_stiffness == before.angles.bend_stiffness);

  after = build([](Parameters& p) { p.constants.bend_stiffness *= 2.0; });
  CHECK(after.angles.bend_stiffness[5][1] == Approx(2.0 * before.angles.bend_stiffness[5][1]));
  CHECK(after.bonds.stiffness == before.bonds.stiffness);

  after = build([](Parameters& p) { p.constants.stretch_coupling *= -2.0; });
  CHECK(after.angles.stretch_coupling[5][1] == Approx(-2.0 * before.angles.stretch_coupling[5][1]));
  CHECK(after.bonds.stiffness == before.bonds.stiffness);

  after = build([](Parameters& p) {
    p.constants.stretch_coupling = 0.0;
    p.constants.angle_law = AngleLaw::eq10;
  });
  CHECK(after.angle_law == AngleLaw::eq10);

  after = build([](Parameters& p) { p.material.density *= 4.0; });
  CHECK(after.mass[5] == Approx(4.0 * before.mass[5]));
  after = build([](Parameters& p) { p.material.young_modulus *= 2.0; });
  CHECK(after.home[5] == Approx(2.0 * before.home[5]));
  after = build([](Parameters& p) { p.material.damping_ratio *= 2.0; });
  CHECK(after.bonds.damping[5] == Approx(2.0 * before.bonds.damping[5]));
  after = build([](Parameters& p) { p.material.wall_thickness = 6e-3; });
  CHECK(after.mass[5] == Approx(3.0 * before.mass[5]));
  after = build([](Parameters& p) { p.options.home_stiffness = 1e3; });
  CHECK(after.home[5] < before.home[5]);
  after = build([](Parameters& p) { p.options.fixed = {1}; });
  CHECK(after.fixed == std::vector<int>{1});
  after = build([](Parameters& p) { p.options.pressure = 100.0; });
  CHECK(after.pressure == 100.0);
  after = build([](Parameters& p) { p.options.drag = 7.0; });
  CHECK(after.drag == 7.0);
  after = build([](Parameters& p) { p.options.damping_law = DampingLaw::isotropic; });
  CHECK(after.damping_law == DampingLaw::isotropic);
}

TEST_CASE("a coupling too strong for some triangle is refused with the range all can take") {
  for (const double coupling : {-1.0, 100.0}) {
    const std::string refusal = refuse_coupling(kSheet, coupling);
    CAPTURE(refusal);
    REQUIRE(refusal.find("mesh: triangle ") == 0);
    REQUIRE(refusal.find(" N on this mesh") != std::string::npos);

    const auto [low, high] = read_range(refusal);
    CHECK(low < 0.0);
    CHECK(high > 0.0);
    CHECK(refuse_coupling(kSheet, low) == "");
    CHECK(refuse_coupling(kSheet, high) == "");
    CHECK(refuse_coupling(kSheet, 1.001 * low) != "");
    CHECK(refuse_coupling(kSheet, 1.001 * high) != "");
  }
}

TEST_CASE("the refused triangle is the one that takes the least") {
  // one vertex moved towards its neighbour makes the triangles between them sharp
  SurfaceMesh sheet = scenes::make_sheet(4, 4, 0.1);
  sheet.vertices[5] += 0.6 * (sheet.vertices[4] - sheet.vertices[5]);
  const std::string refusal = refuse_coupling(sheet, -1.0);
  const int named = std::stoi(refusal.substr(std::string("mesh: triangle ").size()));
  const auto [low, high] = read_range(refusal);

  // by itself every other triangle takes a little more than that one
  const Triangle worst = sheet.triangles[named];
  const auto make_alone = [&](const Triangle& t) -> SurfaceMesh {
    return {{sheet.vertices[t[0]], sheet.vertices[t[1]], sheet.vertices[t[2]]}, {{0, 1, 2}}};
  };
  CHECK(refuse_coupling(make_alone(worst), 1.001 * low) != "");
  for (const Triangle& t : sheet.triangles) {
    if (t != worst) CHECK(refuse_coupling(make_alone(t), 1.001 * low) == "");
  }
}

TEST_CASE("each end of the range is told with the triangle that sets it") {
  // a small even triangle takes little below 0 and anything above, a large needle the reverse
  const SurfaceMesh mesh = {{{0, 0, 0},
                             {0.1, 0, 0},
                             {0.05, 0.05 * std::sqrt(3.0), 0},
                             {2, 0, 0},
                             {2.2, 0, 0},
                             {2.1, std::sqrt(0.99), 0}},
                            {{0, 1, 2}, {3, 4, 5}}};

  CHECK(refuse_coupling(mesh, -10.0).find("mesh: triangle 0: got K_btheta -10 N") == 0);
  CHECK(refuse_coupling(mesh, 1000.0).find("mesh: triangle 1: got K_btheta 1000 N") == 0);
}

TEST_CASE("local scales count in the admissible range") {
  const SurfaceMesh triangle = {{{0, 0, 0}, {0.01, 0, 0}, {0.004, 0.008, 0}}, {{0, 1, 2}}};
  SurfaceOptions stiff;
  stiff.stiffness_scale = {3.0, 3.0, 3.0};
  const MolecularConstants wrong = {.bond_stiffness = 50.0, .stretch_coupling = -10.0};

  const auto plain = find_refusal([&] { build_molecular(triangle, make_wall(), wrong); });
  const auto scaled = find_refusal([&] { build_molecular(triangle, make_wall(), wrong, stiff); });

  // bonds and coupling scale alike, so what a designer may ask for stays the same
  CHECK(read_range(plain)[0] == Approx(read_range(scaled)[0]));
  CHECK(read_range(plain)[1] == Approx(read_range(scaled)[1]));
}

TEST_CASE("the constant 1 N on slivers is refused, on a good mesh taken") {
  SurfaceMesh sliver = scenes::make_sheet(4, 4, 0.03);
  sliver.vertices[5] += 0.99 * (sliver.vertices[4] - sliver.vertices[5]);

  CHECK(refuse_coupling(scenes::make_ellipsoid({0.05, 0.05, 0.05}, 2), 1.0) == "");
  CHECK(refuse_coupling(sliver, 1.0) != "");
}

TEST_CASE("constants no coupling can make up for are refused by name") {
  const auto refuse = [](MolecularConstants constants) {
    return find_refusal([&] { build_molecular(kSheet, make_wall(), constants); });
  };

  CHECK(refuse({.bond_stiffness = 0.0}) ==
        "molecular: bond_stiffness: got 0 N/m, expected a positive number");
  CHECK(refuse({.bond_stiffness = -5.0}) ==
        "molecular: bond_stiffness: got -5 N/m, expected a positive number");
  CHECK(refuse({.bend_stiffness = -1.0}).find("mesh: triangle") == 0);
  CHECK(refuse({.bend_stiffness = std::nan("")}) ==
        "molecular: bend_stiffness: got nan J, expected a finite number");
  CHECK(refuse({.bend_stiffness = -1.0, .angle_law = AngleLaw::eq10}) ==
        "molecular: bend_stiffness: got -1 N, expected 0 or a positive number");
  CHECK(refuse({.stretch_coupling = 1e-3, .angle_law = AngleLaw::eq10}) ==
        "molecular: stretch_coupling: got 0.001 N, expected 0 under AngleLaw::eq10, which has no "
        "stretch-bend force");
  CHECK(refuse({.bend_stiffness = 10.0, .angle_law = AngleLaw::eq10}) == "");
}
