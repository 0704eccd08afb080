// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/model/build_surface.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

namespace {

/// One prism: an equilateral triangle of 10 mm, 4 mm high, outside above; shear of side c alone.
TissueModel make_prism(int side, double stiffness, double damping) {
  TissueModel model;
  for (const double z : {0.0, 0.004}) {
    model.rest_position.insert(model.rest_position.end(),
                               {{0.0, 0.0, z}, {0.01, 0.0, z}, {0.005, 0.0086602540378, z}});
  }
  model.mass.assign(6, 1e-3);
  model.triangles = {{3, 4, 5}};
  model.prisms.corners = {{0, 1, 2, 3, 4, 5}};
  model.prisms.rest_difference = {{0.0, 0.0, 0.0}};
  model.prisms.shear_stiffness = {{0.0, 0.0, 0.0}};
  model.prisms.shear_damping = {{0.0, 0.0, 0.0}};
  model.prisms.shear_stiffness[0][side] = stiffness;
  model.prisms.shear_damping[0][side] = damping;
  return model;
}

TissueModel make_shell() {
  const Material wall = {.young_modulus = 5e4, .damping_ratio = 0.2, .wall_thickness = 2e-3};
  SurfaceOptions options;
  options.fixed = {0, 1, 2};
  return build_shell(scenes::make_ellipsoid({0.05, 0.035, 0.03}, 2), wall, options);
}

Vec3Array compute_prism_forces(const TissueModel& model, const State& state) {
  Vec3Array f(model.mass.size(), Vec3::Zero());
  accumulate_prism_forces(model.prisms, state.position, state.velocity, f);
  return f;
}

State shake(const TissueModel& model, double size, double speed) {
  State state(model);
  scenes::shake(model, size, speed, state);
  return state;
}

}  // namespace

TEST_CASE("a sheared side of a prism pulls along its longer diagonal and pushes along the other") {
  const TissueModel model = make_prism(2, 100.0, 0.0);
  State state(model);
  state.position[3].x() += 0.001;  // the outer face slides along side 2, from corner 0 to corner 1
  state.position[4].x() += 0.001;
  state.position[5].x() += 0.001;

  const Vec3Array f = compute_prism_forces(model, state);

  // diagonals of (11, 4) and (9, 4) mm
  const double longer = std::hypot(0.011, 0.004), shorter = std::hypot(0.009, 0.004);
  const double tension = 100.0 * (longer - shorter);
  CHECK(f[0].x() == Approx(tension * 0.011 / longer));
  CHECK(f[0].z() == Approx(tension * 0.004 / longer));
  CHECK(f[4].x() == Approx(-tension * 0.011 / longer));
  CHECK(f[1].x() == Approx(tension * 0.009 / shorter));
  CHECK(f[3].x() == Approx(-tension * 0.009 / shorter));
  CHECK(f[2].norm() == 0.0);
  CHECK(compute_energy(model, Vec3::Zero(), state).prisms ==
        Approx(0.5 * 100.0 * std::pow(longer - shorter, 2.0)));
}

TEST_CASE("stretching, thinning and turning a prism shears it not at all") {
  TissueModel model = make_prism(0, 100.0, 0.1);
  model.prisms.shear_stiffness = {{100.0, 100.0, 100.0}};
  State state(model);
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  for (Vec3& x : state.position) x = turn * Vec3(1.2 * x.x(), 1.2 * x.y(), 0.7 * x.z());

  for (const Vec3& f : compute_prism_forces(model, state)) CHECK(f.norm() < 1e-14);
}

TEST_CASE(
    "the forces of prisms keep momentum and angular momentum, and damping only takes energy") {
  const TissueModel model = make_shell();
  const State state = shake(model, 5e-4, 0.05);

  const Vec3Array f = compute_prism_forces(model, state);

  Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
  double size = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    sum += f[i];
    moment += state.position[i].cross(f[i]);
    size += f[i].norm();
  }
  CHECK(sum.norm() < 1e-12 * size);
  CHECK(moment.norm() < 1e-12 * size);
  TissueModel undamped = model;
  for (auto& damping : undamped.prisms.shear_damping) damping = {0.0, 0.0, 0.0};
  const Vec3Array elastic = compute_prism_forces(undamped, state);
  double power = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) power += (f[i] - elastic[i]).dot(state.velocity[i]);
  CHECK(power < 0.0);
}

TEST_CASE("the forces of prisms are the negative gradient of their energy") {
  TissueModel model = make_shell();
  model.fixed.clear();
  State state = shake(model, 5e-4, 0.0);
  const Vec3Array f = compute_prism_forces(model, state);
  double largest = 0.0;
  for (const Vec3& force : f) largest = std::max(largest, force.norm());

  constexpr double kStep = 1e-7;
  for (const std::size_t i : {0u, 17u, 100u, 162u, 200u, 323u}) {
    for (int axis = 0; axis < 3; ++axis) {
      double& x = state.position[i][axis];
      const double at = x;
      x = at + kStep;
      const double above = compute_energy(model, Vec3::Zero(), state).prisms;
      x = at - kStep;
      const double below = compute_energy(model, Vec3::Zero(), state).prisms;
      x = at;
      CHECK(std::abs((above - below) / (2.0 * kStep) + f[i][axis]) < 1e-6 * largest);
    }
  }
}

TEST_CASE("the tangents of prisms are the derivatives of their forces") {
  TissueModel model = make_shell();
  const State state = shake(model, 5e-4, 0.0);
  const State direction = shake(model, 1e-3, 0.0);
  const Eigen::Index size = 3 * particle_count(model);
  Eigen::VectorXd step(size), change(size), damped(size);
  State above = state, below = state, moving = state;
  constexpr double kStep = 1e-4;
  std::vector<bool> held(model.mass.size(), false);
  for (const int i : model.fixed) held[i] = true;
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    Vec3 d = direction.position[i] - model.rest_position[i];
    if (held[i]) d.setZero();
    above.position[i] += kStep * d;
    below.position[i] -= kStep * d;
    moving.velocity[i] = d;
    step.segment<3>(3 * i) = d;
  }
  const auto compute = [&](const State& at) {
    Vec3Array f(model.mass.size());
    compute_forces(model, Load(0), at.position, at.velocity, f);
    return f;
  };
  const Vec3Array f_above = compute(above), f_below = compute(below);
  const Vec3Array f_moving = compute(moving), f_still = compute(state);
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    change.segment<3>(3 * i) =
        held[i] ? Vec3(Vec3::Zero()) : Vec3((f_below[i] - f_above[i]) / (2.0 * kStep));
    damped.segment<3>(3 * i) = held[i] ? Vec3(Vec3::Zero()) : Vec3(f_still[i] - f_moving[i]);
  }

  const Eigen::VectorXd exact = compute_stiffness(model, state.position, Projection::none) * step;
  CHECK((exact - change).norm() < 1e-6 * change.norm());
  const Eigen::VectorXd damping = compute_damping(model, state.position) * step;
  CHECK((damping - damped).norm() < 1e-9 * damped.norm());
  const double projected =
      step.dot(compute_stiffness(model, state.position, Projection::positive_semidefinite) * step);
  CHECK(projected > 0.0);
}

TEST_CASE("a diagonal of no length pulls nowhere") {
  const TissueModel model = make_prism(2, 100.0, 0.1);
  State state(model);
  state.position[4] = state.position[0];

  for (const Vec3& f : compute_prism_forces(model, state)) CHECK(f.allFinite());
}
