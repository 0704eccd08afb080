// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/dynamics/forces.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

namespace {

Links one_link(double rest_length, double stiffness, double damping = 0.0) {
  return {{{0, 1}}, {rest_length}, {stiffness}, {damping}};
}

const Vec3 kLeft(0.0, 0.0, 0.0), kRight(0.010, 0.0, 0.0);

Vec3Array link_forces(const Links& links, DampingLaw law, const Vec3Array& x, const Vec3Array& v) {
  Vec3Array f(x.size(), Vec3::Zero());
  accumulate_link_forces(links, law, x, v, f);
  return f;
}

double power(const Vec3Array& f, const Vec3Array& v) {
  double sum = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) sum += f[i].dot(v[i]);
  return sum;
}

}  // namespace

TEST_CASE("a link at rest length exerts no force") {
  const auto f = link_forces(one_link(0.010, 200.0), DampingLaw::axis, {kLeft, kRight},
                             Vec3Array(2, Vec3::Zero()));

  CHECK(f[0] == Vec3::Zero());
  CHECK(f[1] == Vec3::Zero());
}

TEST_CASE("a link stretched by 1 mm pulls its ends together with k times 1 mm") {
  const auto f = link_forces(one_link(0.010, 200.0), DampingLaw::axis, {kLeft, {0.011, 0.0, 0.0}},
                             Vec3Array(2, Vec3::Zero()));

  CHECK(f[0].x() == Approx(0.2));
  CHECK((f[0] + f[1]).norm() == 0.0);
}

TEST_CASE("a link compressed by 2 mm pushes its ends apart with k times 2 mm") {
  const auto f = link_forces(one_link(0.010, 200.0), DampingLaw::axis, {kLeft, {0.008, 0.0, 0.0}},
                             Vec3Array(2, Vec3::Zero()));

  CHECK(f[0].x() == Approx(-0.4));
  CHECK(f[1].x() == Approx(0.4));
}

TEST_CASE("damping along the axis resists what goes along the link and nothing else") {
  const Links link = one_link(0.010, 200.0, 0.5);
  const Vec3Array v = {Vec3::Zero(), {0.2, 0.3, 0.0}};

  const auto f = link_forces(link, DampingLaw::axis, {kLeft, kRight}, v);

  CHECK(f[1].x() == Approx(-0.1));  // 0.5 N·s/m * 0.2 m/s
  CHECK(f[1].y() == 0.0);
}

TEST_CASE("isotropic damping resists every relative velocity of the ends") {
  const Links link = one_link(0.010, 200.0, 0.5);
  const Vec3Array v = {Vec3::Zero(), {0.2, 0.3, 0.0}};

  const auto f = link_forces(link, DampingLaw::isotropic, {kLeft, kRight}, v);

  CHECK(f[1].x() == Approx(-0.1));
  CHECK(f[1].y() == Approx(-0.15));
}

TEST_CASE("both dampings dissipate, only the one along the axis keeps angular momentum") {
  const Links link = one_link(0.010, 0.0, 0.5);
  double largest_power_axis = -1.0, largest_power_isotropic = -1.0;
  double largest_torque_axis = 0.0, largest_torque_isotropic = 0.0;
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    const Vec3Array x = scenes::scatter_vectors(2, 0.02, seed);
    const Vec3Array v = scenes::scatter_vectors(2, 1.0, seed + 5000);
    const auto axis = link_forces(link, DampingLaw::axis, x, v);
    const auto isotropic = link_forces(link, DampingLaw::isotropic, x, v);
    largest_power_axis = std::max(largest_power_axis, power(axis, v));
    largest_power_isotropic = std::max(largest_power_isotropic, power(isotropic, v));
    largest_torque_axis = std::max(largest_torque_axis, scenes::compute_torque(x, axis).norm());
    largest_torque_isotropic =
        std::max(largest_torque_isotropic, scenes::compute_torque(x, isotropic).norm());
  }

  CHECK(largest_power_axis <= 0.0);
  CHECK(largest_power_isotropic <= 0.0);
  CHECK(largest_torque_axis < 1e-16);
  CHECK(largest_torque_isotropic > 1e-3);
}

TEST_CASE("a rigid rotation is braked by isotropic damping alone") {
  const Links link = one_link(0.010, 200.0, 0.5);
  const Vec3Array x = {-0.5 * kRight, 0.5 * kRight};
  const Vec3 spin(0.0, 0.0, 7.0);
  const Vec3Array v = {spin.cross(x[0]), spin.cross(x[1])};

  CHECK(scenes::max_norm(link_forces(link, DampingLaw::axis, x, v)) == 0.0);
  // 0.5 N·s/m * 7 rad/s * 10 mm
  CHECK(scenes::max_norm(link_forces(link, DampingLaw::isotropic, x, v)) == Approx(0.035));
}

TEST_CASE("link forces sum to zero, exert no torque and turn with the body") {
  const Mat3 turn = Eigen::AngleAxisd(1.234, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  const Links links = {{{0, 1}, {0, 2}}, {0.01, 0.02}, {50.0, 80.0}, {0.1, 0.3}};
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const Vec3Array x = scenes::scatter_vectors(3, 0.02, seed);
    const Vec3Array v = scenes::scatter_vectors(3, 0.1, seed + 2000);
    Vec3Array turned, turned_v;
    for (int i = 0; i < 3; ++i) {
      turned.push_back(turn * x[i] + Vec3(0.3, -0.1, 0.2));
      turned_v.push_back(turn * v[i]);
    }

    const auto f = link_forces(links, DampingLaw::axis, x, v);
    const auto f_turned = link_forces(links, DampingLaw::axis, turned, turned_v);

    const double size = scenes::max_norm(f);
    CHECK(scenes::sum(f).norm() <= 1e-15 * size);
    CHECK(scenes::compute_torque(x, f).norm() <= 1e-15 * size);
    for (int i = 0; i < 3; ++i) CHECK((f_turned[i] - turn * f[i]).norm() < 1e-11 * size);
  }
}

TEST_CASE("a home spring pulls by h times the displacement from home") {
  const std::vector<double> home = {5.0};
  const Vec3Array rest = {{0, 0, 0}}, x = {{0.002, 0, -0.001}};
  Vec3Array f(1, Vec3::Zero());

  accumulate_home_forces(home, rest, x, f);

  CHECK(f[0].x() == Approx(-0.010));
  CHECK(f[0].z() == Approx(0.005));
}

TEST_CASE("pressure pushes a triangle outward with p times its area, a third at each corner") {
  const std::vector<Triangle> triangles = {{0, 1, 2}};  // counter-clockwise from +z
  const Vec3Array x = {{0, 0, 0}, {0.02, 0, 0}, {0, 0.03, 0}};
  Vec3Array f(3, Vec3::Zero());

  accumulate_pressure_forces(triangles, 1000.0, x, f);

  for (const Vec3& each : f) CHECK(each.z() == Approx(1000.0 * 3e-4 / 3.0));
}

TEST_CASE("pressure in a closed body neither moves nor turns it") {
  const SurfaceMesh mesh = scenes::make_organ_mesh(1);
  Vec3Array f(mesh.vertices.size(), Vec3::Zero());

  accumulate_pressure_forces(mesh.triangles, 2000.0, mesh.vertices, f);

  CHECK(scenes::sum(f).norm() < 1e-14);
  CHECK(scenes::compute_torque(mesh.vertices, f).norm() < 1e-15);
}

TEST_CASE("gravity is m g and drag is drag m v") {
  const std::vector<double> mass = {0.5, 2.0};
  const Vec3Array v = {{1.0, 0, 0}, {0, 3.0, 0}};
  Vec3Array f(2, Vec3::Zero());

  accumulate_gravity(mass, {0, 0, -9.81}, f);
  accumulate_drag(mass, 0.25, v, f);

  CHECK(f[0].z() == Approx(-4.905));
  CHECK(f[1].z() == Approx(-19.62));
  CHECK(f[0].x() == Approx(-0.125));
  CHECK(f[1].y() == Approx(-1.5));
}

TEST_CASE("a push keeps its force and its torque when the corners share it") {
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const Vec3Array x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Push> pushes = {{0, {0.2, 0.3, 0.5}, {0, 1.0, -4.0}}};
  Vec3Array f(3, Vec3::Zero());

  accumulate_push_forces(triangles, {}, pushes, f);

  CHECK(f[2].z() == Approx(-2.0));
  CHECK((scenes::sum(f) - pushes[0].force).norm() < 1e-15);
  CHECK((scenes::compute_torque(x, f) - Vec3(0.3, 0.5, 0).cross(pushes[0].force)).norm() < 1e-15);
}

TEST_CASE("the forces of a whole model are all its parts together, fixed particles included") {
  TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.3, .drag = 2.0});
  model.pressure = 300.0;
  model.home.assign(model.mass.size(), 4.0);
  State state(model);
  scenes::shake(model, 1e-3, 0.1, state);
  Load load(1);
  load.gravity = {0, 0, -9.81};
  load.add({3, {0.2, 0.3, 0.5}, {0.1, 0.2, -0.3}});
  Vec3Array parts(model.mass.size(), Vec3::Zero()), whole(model.mass.size(), Vec3::Ones());

  accumulate_link_forces(model.bonds, model.damping_law, state.position, state.velocity, parts);
  accumulate_angle_forces(model.angles, state.position, parts);
  accumulate_home_forces(model.home, model.rest_position, state.position, parts);
  accumulate_pressure_forces(model.triangles, model.pressure, state.position, parts);
  accumulate_gravity(model.mass, load.gravity, parts);
  accumulate_drag(model.mass, model.drag, state.velocity, parts);
  accumulate_push_forces(model.triangles, {}, load.pushes(), parts);
  compute_forces(model, load, state.position, state.velocity, whole);

  CHECK(scenes::max_difference(parts, whole) == 0.0);
  CHECK(whole[model.fixed[0]].norm() > 0.0);
}
