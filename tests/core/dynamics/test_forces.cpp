// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <functional>

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

Vec3Array angle_forces(const Angles& angles, const Vec3Array& x) {
  Vec3Array f(x.size(), Vec3::Zero());
  accumulate_angle_forces(angles, x, f);
  return f;
}

Vec3Array eq10_forces(const Angles& angles, const Vec3Array& x) {
  Vec3Array f(x.size(), Vec3::Zero());
  accumulate_eq10_forces(angles, x, f);
  return f;
}

/// Only corner 0 has a constant.
Angles one_corner(const Vec3Array& rest, double bend_stiffness, double stretch_coupling) {
  Angles angles = scenes::make_angles({{0, 1, 2}}, rest, 0.0, 0.0);
  angles.bend_stiffness[0] = {bend_stiffness, 0.0, 0.0};
  angles.stretch_coupling[0] = {stretch_coupling, 0.0, 0.0};
  return angles;
}

double power(const Vec3Array& f, const Vec3Array& v) {
  double sum = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) sum += f[i].dot(v[i]);
  return sum;
}

Vec3 total(const Vec3Array& f) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& one : f) sum += one;
  return sum;
}

Vec3 torque(const Vec3Array& x, const Vec3Array& f) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < f.size(); ++i) sum += x[i].cross(f[i]);
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
    largest_torque_axis = std::max(largest_torque_axis, torque(x, axis).norm());
    largest_torque_isotropic = std::max(largest_torque_isotropic, torque(x, isotropic).norm());
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

TEST_CASE("a right angle with 1 m arms that opens to 120 degrees is pulled shut by K/2 sin") {
  // at corner 0, q = cos 120° - cos 90° = -1/2; |grad cos| = sin 120° / 1 m on either arm's end
  const Vec3Array rest = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const double sine = std::sqrt(3.0) / 2.0;
  const Vec3Array x = {{0, 0, 0}, {1, 0, 0}, {-0.5, sine, 0}};

  const auto f = angle_forces(one_corner(rest, 2.0, 0.0), x);

  CHECK(f[1].x() == Approx(0.0).epsilon(1e-12));
  CHECK(f[1].y() == Approx(2.0 * 0.5 * sine));  // towards the other arm
  CHECK(total(f).norm() < 1e-15);
}

TEST_CASE("stretch-bend at a right angle pulls along the arms by K q and across by K S / r") {
  // arms 1.1 m and 1 m, so S = 0.1 m, q = 0: only the part K S grad cos is left
  const Vec3Array rest = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Vec3Array x = {{0, 0, 0}, {1.1, 0, 0}, {0, 1, 0}};

  const auto f = angle_forces(one_corner(rest, 0.0, 3.0), x);

  CHECK(f[1].y() == Approx(-3.0 * 0.1 / 1.1));
  CHECK(f[2].x() == Approx(-3.0 * 0.1 / 1.0));
  CHECK(f[1].x() == Approx(0.0).epsilon(1e-12));
  CHECK(total(f).norm() < 1e-15);
}

TEST_CASE("Eq 10 pushes the arms' ends apart along the opposite edge and spares the corner") {
  // corner closed from 90 to 60 degrees: q = 1/2, opposite edge 1 m along (1/2, -sqrt(3)/2)
  const Vec3Array rest = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const double sine = std::sqrt(3.0) / 2.0;
  const Vec3Array x = {{0, 0, 0}, {1, 0, 0}, {0.5, sine, 0}};

  const auto f = eq10_forces(one_corner(rest, 4.0, 0.0), x);

  CHECK(f[0] == Vec3::Zero());
  CHECK(f[1].x() == Approx(4.0 * 0.5 * 0.5));
  CHECK(f[1].y() == Approx(-4.0 * 0.5 * sine));
  CHECK((f[1] + f[2]).norm() == 0.0);
}

TEST_CASE("in an equilateral triangle Eq 10 equals the angle law to first order for 1.5 K / l") {
  const double l = 0.01, bend = 3e-5;
  const Vec3Array rest = {{0, 0, 0}, {l, 0, 0}, {0.5 * l, 0.5 * std::sqrt(3.0) * l, 0}};
  Angles law = scenes::make_angles({{0, 1, 2}}, rest, 0.0, 0.0);
  law.bend_stiffness[0] = {bend, bend, bend};
  Angles eq10 = law;
  eq10.bend_stiffness[0].fill(1.5 * bend / l);
  const Vec3Array offset = scenes::scatter_vectors(3, 1.0, 3);

  const auto difference_at = [&](double size) {
    Vec3Array x = rest;
    for (int i = 0; i < 3; ++i) x[i] += size * l * offset[i];
    const auto f = angle_forces(law, x);
    return scenes::max_difference(f, eq10_forces(eq10, x)) / scenes::max_norm(f);
  };

  CHECK(difference_at(1e-2) < 2e-1);
  CHECK(difference_at(1e-4) < 2e-3);  // shrinks with the strain
  CHECK(difference_at(1e-6) < 2e-5);
}

TEST_CASE("round a closed loop Eq 10 does work and the gradient of Eq 9 does none") {
  const Vec3Array rest = {{0, 0, 0}, {1, 0, 0}, {0.3, 1.1, 0}};
  const Angles angles = one_corner(rest, 1.0, 0.0);
  using Law = std::function<Vec3Array(const Vec3Array&)>;
  const auto work_round_loop = [&](const Law& forces) {
    const int count = 4000;
    const double amplitude = 0.2;
    const auto place = [&](double t) {
      Vec3Array x = rest;
      x[1].x() += amplitude * (std::cos(t) - 1.0);
      x[2].y() += amplitude * std::sin(t);
      return x;
    };
    double work = 0.0;
    for (int s = 0; s < count; ++s) {
      const double t = 2.0 * std::numbers::pi * s / count, dt = 2.0 * std::numbers::pi / count;
      const Vec3Array from = place(t), to = place(t + dt), f = forces(place(t + 0.5 * dt));
      for (int i = 0; i < 3; ++i) work += f[i].dot(to[i] - from[i]);
    }
    return work;
  };

  const double eq10 = work_round_loop([&](const Vec3Array& x) { return eq10_forces(angles, x); });
  const double law = work_round_loop([&](const Vec3Array& x) { return angle_forces(angles, x); });

  CHECK(std::abs(eq10) == Approx(0.0119).epsilon(0.01));
  CHECK(std::abs(law) < 1e-15);
}

TEST_CASE("link, angle and Eq 10 forces sum to zero, exert no torque and turn with the body") {
  const Mat3 turn = Eigen::AngleAxisd(1.234, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const Vec3Array rest = scenes::scatter_vectors(3, 0.02, seed);
    const Vec3Array x = scenes::scatter_vectors(3, 0.02, seed + 1000);
    const Vec3Array v = scenes::scatter_vectors(3, 0.1, seed + 2000);
    const Angles angles = scenes::make_angles({{0, 1, 2}}, rest, 1e-3, 0.05);
    const Links links = {{{0, 1}, {0, 2}}, {0.01, 0.02}, {50.0, 80.0}, {0.1, 0.3}};
    Vec3Array turned, turned_v;
    for (int i = 0; i < 3; ++i) {
      turned.push_back(turn * x[i] + Vec3(0.3, -0.1, 0.2));
      turned_v.push_back(turn * v[i]);
    }

    for (int law = 0; law < 3; ++law) {
      CAPTURE(law);
      const auto forces = [&](const Vec3Array& at, const Vec3Array& with) {
        return law == 0   ? link_forces(links, DampingLaw::axis, at, with)
               : law == 1 ? angle_forces(angles, at)
                          : eq10_forces(angles, at);
      };
      const auto f = forces(x, v), f_turned = forces(turned, turned_v);
      const double size = scenes::max_norm(f);
      CHECK(total(f).norm() <= 1e-15 * size);
      CHECK(torque(x, f).norm() <= 1e-15 * size);
      for (int i = 0; i < 3; ++i) CHECK((f_turned[i] - turn * f[i]).norm() < 1e-11 * size);
    }
  }
}

TEST_CASE("a home spring pulls by h times the way home") {
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

  CHECK(total(f).norm() < 1e-14);
  CHECK(torque(mesh.vertices, f).norm() < 1e-15);
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

  accumulate_push_forces(triangles, pushes, f);

  CHECK(f[2].z() == Approx(-2.0));
  CHECK((total(f) - pushes[0].force).norm() < 1e-15);
  CHECK((torque(x, f) - Vec3(0.3, 0.5, 0).cross(pushes[0].force)).norm() < 1e-15);
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
  accumulate_push_forces(model.triangles, load.pushes(), parts);
  compute_forces(model, load, state.position, state.velocity, whole);

  CHECK(scenes::max_difference(parts, whole) == 0.0);
  CHECK(whole[model.fixed[0]].norm() > 0.0);
}
