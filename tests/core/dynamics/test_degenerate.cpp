// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/tensions.h"
#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/dynamics/tangent.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

namespace {

/// A triangle with bonds, angles and stretch-bend, sides about 1 cm.
TissueModel make_triangle_model(AngleLaw law) {
  TissueModel model;
  model.rest_position = {{0, 0, 0}, {0.01, 0, 0}, {0.004, 0.009, 0}};
  model.mass.assign(3, 1e-3);
  model.triangles = {{0, 1, 2}};
  model.angles = scenes::make_angles(model.triangles, model.rest_position, 1e-3, 0.02);
  model.angle_law = law;
  for (const auto& [i, j] : {std::array{0, 1}, {0, 2}, {1, 2}}) {
    model.bonds.ends.push_back({i, j});
    model.bonds.rest_length.push_back((model.rest_position[i] - model.rest_position[j]).norm());
    model.bonds.stiffness.push_back(50.0);
    model.bonds.damping.push_back(0.1);
  }
  return model;
}

/// Shapes in which a length, an angle or an area is nothing.
std::vector<Vec3Array> make_degenerate_shapes() {
  std::vector<Vec3Array> shapes;
  for (const double gap : {1e-3, 1e-5, 1e-9, 1e-15, 0.0}) {
    shapes.push_back({{0, 0, 0}, {0.01, 0, 0}, {0.01, gap, 0}});        // theta -> 0, a short side
    shapes.push_back({{0, 0, 0}, {0.01, 0, 0}, {-0.01, gap, 0}});       // theta -> 180 degrees
    shapes.push_back({{0, 0, 0}, {gap, 0, 0}, {0, 0.01, 0}});           // a short arm
    shapes.push_back({{0, 0, 0}, {gap, 0, 0}, {0, gap, 0}});            // all but a point
    shapes.push_back({{0, 0, 0}, {0.01, 0, 0}, {0.005, gap, 0}});       // flat, all sides long
    shapes.push_back({{0, 0, 0}, {0.03, 0, 0}, {0.015, gap, 1e-300}});  // drawn out
  }
  shapes.push_back({{0, 0, 0}, {0.01, 0, 0}, {0.004, -0.009, 0}});  // turned over
  return shapes;
}

}  // namespace

TEST_CASE("forces, energies and tangents are finite in needles and collapsed triangles") {
  for (const AngleLaw law : {AngleLaw::gradient, AngleLaw::eq10}) {
    const TissueModel model = make_triangle_model(law);
    for (const Vec3Array& x : make_degenerate_shapes()) {
      State state(model);
      state.position = x;
      const Vec3Array v = scenes::scatter_vectors(3, 0.1, 7);
      Vec3Array f(3, Vec3::Zero());

      compute_forces(model, Load(), x, v, f);
      const Energy energy = compute_energy(model, Vec3::Zero(), state);
      const Eigen::MatrixXd exact = compute_stiffness(model, x, Projection::none);
      const Eigen::MatrixXd projected =
          compute_stiffness(model, x, Projection::positive_semidefinite);

      for (const Vec3& each : f) CHECK(each.allFinite());
      CHECK(std::isfinite(energy.total()));
      CHECK(exact.allFinite());
      CHECK(projected.allFinite());
    }
  }
}

TEST_CASE("no collapse makes an angle force larger than its constants over a seventh of a side") {
  // |f| <= 2 sides x (2 w + 2 s) with w <= (K 2 + Kb 4 l) l / (0.15 l)^2 and s <= 2 Kb
  const TissueModel model = make_triangle_model(AngleLaw::gradient);
  const double bend = 1.3e-3, coupling = 1.6 * 0.02, l = 0.011, blunt = 0.5 * kBluntSide * 0.009;
  const double w = (2.0 * bend + coupling * 8.0 * l) * 3.0 * l / (blunt * blunt);
  for (const Vec3Array& x : make_degenerate_shapes()) {
    Vec3Array f(3, Vec3::Zero());

    accumulate_angle_forces(model.angles, x, f);

    CHECK(scenes::max_norm(f) < 2.0 * (3.0 * w + 4.0 * coupling));
  }
}

TEST_CASE("a short side divides as a longer one, from three tenths of its rest length on") {
  const PerSide<double> rest = {0.01, 0.01, 0.01};

  const auto by = invert_lengths(rest, PerSide<double>{0.01, 0.003, 0.0015});

  CHECK(by.blunt);
  CHECK(by.inverse[0] == 1.0 / 0.01);
  CHECK(by.slope[0] == 1.0 / 0.01);
  CHECK(by.inverse[1] == Approx(1.0 / 0.003));
  CHECK(by.slope[1] == Approx(1.0 / 0.003));
  // (3 + 1.5²/3)/2 = 1.875 mm, which grows by half of what the side does
  CHECK(by.inverse[2] == Approx(1.0 / 0.001875));
  CHECK(by.slope[2] == Approx(0.5 / 0.001875));
  CHECK(by.direction[2] == Approx(1.0 / 0.0015));
  const PerSide<double> nothing = {0.0, 0.0, 0.0};
  CHECK(invert_lengths(rest, nothing).inverse[0] == Approx(1.0 / 0.0015));
  CHECK(invert_lengths(rest, nothing).direction[0] == 0.0);
  CHECK_FALSE(invert_lengths(rest, PerSide<double>{0.01, 0.02, 0.0031}).blunt);
}

TEST_CASE("in needles and collapsed triangles forces are the gradient of the energy") {
  TissueModel model = make_triangle_model(AngleLaw::gradient);
  const Vec3Array& rest = model.rest_position;
  for (const double part : {0.5, 0.29, 0.2, 0.1, 0.04, 0.01}) {
    for (int moved = 0; moved < 3; ++moved) {
      CAPTURE(part);
      Vec3Array x = rest;
      const Vec3 aside = 0.3 * part * Vec3(0.001, -0.002, 0.004);
      x[moved] = rest[(moved + 1) % 3] + part * (rest[moved] - rest[(moved + 1) % 3]) + aside;
      Vec3Array f(3, Vec3::Zero());
      accumulate_angle_forces(model.angles, x, f);
      for (std::size_t i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
          const double h = 1e-9;
          State up(model), down(model);
          up.position = down.position = x;
          up.position[i][axis] += h, down.position[i][axis] -= h;
          const double slope = (compute_energy(model, Vec3::Zero(), up).total() -
                                compute_energy(model, Vec3::Zero(), down).total()) /
                               (2.0 * h);
          Vec3Array all = f;
          accumulate_link_forces(model.bonds, model.damping_law, x, Vec3Array(3, Vec3::Zero()),
                                 all);
          CHECK(all[i][axis] == Approx(-slope).epsilon(1e-5).scale(scenes::max_norm(all)));
        }
      }
    }
  }
}

TEST_CASE("stretch-bend that is stronger than the bonds does not shut a side of a needle") {
  // of the stomach's wall, folded: bonds push with 0.47 N at most, stretch-bend pulls with 0.89 N
  const PerSide<double> rest = {4.75e-3, 7.88e-3, 5.21e-3};
  const PerSide<double> bond = {96.0, 92.5, 64.5};
  Angles angles;
  angles.corners = {{0, 1, 2}};
  angles.rest_length = {rest};
  angles.rest_cosine = {{0.812, -0.251, 0.768}};
  angles.bend_stiffness = {{0.0, 0.0, 0.0}};
  angles.stretch_coupling = {{0.0510, 0.3843, 0.0477}};
  // what drives a flat triangle's side open, along which the third gives way
  const auto open = [&](double part) {
    const PerSide<double> length = {part * rest[0], 4.45e-3, part * rest[0] + 4.45e-3};
    const PerSide<double> tension =
        compute_angle_tensions(AngleRow(angles, 0), length, invert_lengths(rest, length));
    return -(tension[0] + bond[0] * (length[0] - rest[0]) + tension[2] +
             bond[2] * (length[2] - rest[2]));
  };

  CHECK(open(0.31) == Approx(-0.61).epsilon(0.03));
  CHECK(open(0.15) > 0.4);
  for (double part = 0.15; part > 0.01; part *= 0.9) CHECK(open(part) < open(0.9 * part));
}

TEST_CASE("a link of zero length has no direction and exerts no force along it") {
  const Links link = {{{0, 1}}, {0.01}, {100.0}, {0.5}};
  const Vec3Array x(2, Vec3(0.3, 0.2, 0.1)), v = {{1, 0, 0}, {0, 0, 0}};
  Vec3Array axis(2, Vec3::Zero()), isotropic(2, Vec3::Zero());

  accumulate_link_forces(link, DampingLaw::axis, x, v, axis);
  accumulate_link_forces(link, DampingLaw::isotropic, x, v, isotropic);

  CHECK(axis[0] == Vec3::Zero());
  CHECK(isotropic[0].x() == Approx(-0.5));  // it still rubs
}

TEST_CASE("a triangle turned over feels what it felt before, since lengths cannot see it") {
  const TissueModel model = make_triangle_model(AngleLaw::gradient);
  Vec3Array x = {{0.001, 0, 0}, {0.012, 0.001, 0}, {0.004, 0.008, 0}}, mirrored = x;
  for (Vec3& each : mirrored) each.y() = -each.y();
  Vec3Array f(3, Vec3::Zero()), f_mirrored(3, Vec3::Zero());

  compute_forces(model, Load(), x, Vec3Array(3, Vec3::Zero()), f);
  compute_forces(model, Load(), mirrored, Vec3Array(3, Vec3::Zero()), f_mirrored);

  for (Vec3& each : f_mirrored) each.y() = -each.y();
  CHECK(scenes::max_norm(f) > 0.0);
  CHECK(scenes::max_difference(f, f_mirrored) < 1e-15);
}

TEST_CASE("what is not finite in a position stays visible in the force") {
  const TissueModel model = make_triangle_model(AngleLaw::gradient);
  Vec3Array x = model.rest_position, f(3, Vec3::Zero());
  x[1].y() = std::numeric_limits<double>::quiet_NaN();

  compute_forces(model, Load(), x, Vec3Array(3, Vec3::Zero()), f);

  CHECK_FALSE(f[0].allFinite());
}
