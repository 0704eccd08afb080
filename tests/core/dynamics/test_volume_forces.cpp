// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/model/tissue_model.h"
#include "scenes/solids.h"

using namespace palpate;
using doctest::Approx;

namespace {

constexpr double kShares[] = {0.0, 0.4, 1.0};

Vec3Array volume_forces(const Volumes& volumes, const Vec3Array& x) {
  Vec3Array f(x.size(), Vec3::Zero());
  accumulate_volume_forces(volumes, x, f);
  return f;
}

/// The corner of a unit cube, 1/6 m³.
Volumes one_tetrahedron(double bulk, double nodal_share) {
  return build_volumes(4, {{0, 1, 2, 3}}, {1.0 / 6.0}, {bulk}, nodal_share);
}

double energy_at(const TissueModel& model, const Vec3Array& x) {
  State state(model);
  state.position = x;
  return compute_energy(model, Vec3::Zero(), state).elastic();
}

}  // namespace

TEST_CASE("a tetrahedron pulled to twice its height is pushed back by B ln 2 / 2 a third each") {
  // J = 2, e' = ln 2 / 2, and the face below has 1/2 m²: dv/dz of the tip is a third of that
  for (const double share : kShares) {
    const Vec3Array x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}};

    const Vec3Array f = volume_forces(one_tetrahedron(300.0, share), x);

    CHECK(f[3].z() == Approx(-300.0 * std::log(2.0) / 2.0 / 6.0));
    CHECK(f[3].x() == Approx(0.0));
    CHECK(scenes::sum(f).norm() < 1e-12);
  }
}

TEST_CASE("at rest, and however it is turned, a volume exerts no force") {
  for (const double share : kShares) {
    const TissueModel model = scenes::make_solid_organ(3, share);
    const Quaternion turn(Eigen::AngleAxisd(1.0, Vec3(1, 2, 3).normalized()));
    Vec3Array x = model.rest_position;
    for (Vec3& p : x) p = turn * p + Vec3(0.1, 0.2, 0.3);

    CHECK(scenes::max_norm(volume_forces(model.volumes, x)) < 1e-12);
  }
}

TEST_CASE("volumes keep momentum and angular momentum, and turn with the body") {
  for (const double share : kShares) {
    const TissueModel model = scenes::make_solid_organ(3, share);
    const Vec3Array x = scenes::strained(model, 2e-3);
    const Quaternion turn(Eigen::AngleAxisd(0.7, Vec3(-1, 0.5, 2).normalized()));
    Vec3Array turned = x;
    for (Vec3& p : turned) p = turn * p;

    const Vec3Array f = volume_forces(model.volumes, x);
    Vec3Array back = volume_forces(model.volumes, turned);
    for (Vec3& p : back) p = turn.conjugate() * p;

    CHECK(scenes::sum(f).norm() < 1e-12 * scenes::max_norm(f));
    CHECK(scenes::compute_torque(x, f).norm() < 1e-13 * scenes::max_norm(f));
    CHECK(scenes::max_difference(f, back) < 1e-11 * scenes::max_norm(f));
  }
}

TEST_CASE("the forces of a solid are the negative slope of its energy, inside out too") {
  for (const double share : kShares) {
    const TissueModel model = scenes::make_solid_organ(2, share);
    for (const double offset : {1e-3, 8e-3}) {  // cells of 30 mm; the second inverts
      Vec3Array x = scenes::strained(model, offset), f(x.size()), v(x.size(), Vec3::Zero());
      if (offset > 5e-3) x[13] += Vec3(0.0, 0.0, 0.06);
      compute_forces(model, Load(), x, v, f);
      const double scale = scenes::max_norm(f);
      for (const int i : {13, 20, 26}) {
        for (int axis = 0; axis < 3; ++axis) {
          constexpr double kShift = 1e-8;
          const double middle = x[i][axis];
          x[i][axis] = middle + kShift;
          const double above = energy_at(model, x);
          x[i][axis] = middle - kShift;
          const double below = energy_at(model, x);
          x[i][axis] = middle;

          CHECK(std::abs(f[i][axis] + (above - below) / (2.0 * kShift)) < 1e-6 * scale);
        }
      }
    }
  }
}

TEST_CASE("a tetrahedron that is flat or inside out is driven back by finite forces") {
  for (const double share : kShares) {
    double last = 0.0;
    for (const double height : {0.5, 0.19, 0.05, 0.0, -0.3, -1.0}) {
      const Vec3Array x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, height}};

      const double push = volume_forces(one_tetrahedron(300.0, share), x)[3].z();

      CHECK(std::isfinite(push));
      CHECK(push > last);
      last = push;
    }
  }
}

TEST_CASE("lengths alone cannot tell a tetrahedron from its mirror image, volumes can") {
  TissueModel model = build_solid(
      {{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}}, {{0, 1, 2, 3}}}, Material{});
  State mirrored(model);
  for (Vec3& x : mirrored.position) x.z() = -x.z();

  const Energy energy = compute_energy(model, Vec3::Zero(), mirrored);

  CHECK(energy.links == Approx(0.0));
  CHECK(energy.volumes > 1e-3);
}

TEST_CASE("the tangent of a solid is the slope of its forces, and projected it is semidefinite") {
  for (const double share : kShares) {
    const TissueModel model = scenes::make_solid_organ(2, share);
    const int n = particle_count(model);
    for (const double offset : {0.0, 3e-3}) {
      Vec3Array x = scenes::strained(model, offset), v(x.size(), Vec3::Zero()), above(n), below(n);
      const Eigen::MatrixXd k = compute_stiffness(model, x, Projection::none);
      Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(3 * n, 3 * n);
      for (int j = 0; j < 3 * n; ++j) {
        constexpr double kShift = 1e-7;
        x[j / 3][j % 3] += kShift;
        compute_forces(model, Load(), x, v, above);
        x[j / 3][j % 3] -= 2.0 * kShift;
        compute_forces(model, Load(), x, v, below);
        x[j / 3][j % 3] += kShift;
        for (int i = 0; i < n; ++i) {
          slopes.block<3, 1>(3 * i, j) = -(above[i] - below[i]) / (2.0 * kShift);
        }
      }
      for (const int i : model.fixed) {
        slopes.middleRows(3 * i, 3).setZero();
        slopes.middleCols(3 * i, 3).setZero();
      }

      CHECK((k - slopes).cwiseAbs().maxCoeff() < 1e-6 * k.cwiseAbs().maxCoeff());
      CHECK((k - k.transpose()).cwiseAbs().maxCoeff() < 1e-12 * k.cwiseAbs().maxCoeff());
      const Eigen::MatrixXd projected =
          compute_stiffness(model, x, Projection::positive_semidefinite);
      const Eigen::VectorXd all =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(projected, Eigen::EigenvaluesOnly)
              .eigenvalues();
      CHECK(all[0] > -1e-9 * all[all.size() - 1]);
      CHECK(compute_stiffness(model, x, Projection::none).nonZeros() ==
            compute_stiffness(model, model.rest_position, Projection::none).nonZeros());
    }
  }
}

TEST_CASE("a solid keeps its energy below the stable step and blows up above it") {
  for (const double share : kShares) {
    TissueModel model = scenes::make_solid_organ(3, share);
    const double limit = stable_step(model) / 0.9;
    const auto swing = [&](double dt) {
      State state(model);
      scenes::shake(model, 1e-5, 0.0, state);
      const double start = compute_energy(model, Vec3::Zero(), state).elastic();
      for (int s = 0; s < 2000; ++s) step(model, Load(), dt, state);
      return compute_energy(model, Vec3::Zero(), state).total() / start;
    };

    CHECK(swing(0.9 * limit) < 10.0);
    CHECK(!(swing(1.05 * limit) < 100.0));
  }
}

TEST_CASE("near nu = 0.5 averaged volumes bend more easily than single ones, which lock") {
  const auto soften = [](double share) {
    const SolidMesh beam = scenes::make_block({0.08, 0.01, 0.01}, {16, 2, 2});
    Material material;
    material.poisson_ratio = 0.49;
    SolidOptions options;
    options.nodal_share = share;
    for (int i = 0; i < static_cast<int>(beam.vertices.size()); ++i) {
      if (beam.vertices[i].x() < -0.0399) options.fixed.push_back(i);
    }
    const TissueModel model = build_solid(beam, material, options);
    State state(model);
    Load load;
    load.gravity = {0.0, 0.0, -1.0};
    ImplicitStepper stepper(model, Integrator::implicit_euler);
    for (int s = 0; s < 30; ++s) stepper.step(load, 1.0, state);
    return -state.position.back().z() + model.rest_position.back().z();
  };

  CHECK(soften(1.0) > 1.3 * soften(0.0));
}

TEST_CASE("a tetrahedron that stays inside out raises the alarm after ten checks") {
  const TissueModel model = build_solid(
      {{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}}, {{0, 1, 2, 3}}}, Material{});
  State state(model);
  state.position[3].z() = -0.01;
  Guard guard(model, Vec3::Zero(), state);

  Alarm alarm;
  int checks = 0;
  for (; !alarm && checks < 20; ++checks) alarm = check(model, Vec3::Zero(), state, 0.0, guard);

  CHECK(checks == 10);
  CHECK(alarm.kind == AlarmKind::inverted);
  CHECK(alarm.index == 0);
  CHECK(alarm.value == Approx(-1.0));
}

TEST_CASE("a push on a skin keeps its force and its moment on the tetrahedra, to rounding") {
  const TissueModel model = scenes::make_covered_organ(3, 0.9);
  State state(model);
  scenes::shake(model, 1e-3, 0.0, state);
  const Vec3Array skin = compute_surface(model, state.position);
  std::vector<Push> pushes;
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  for (int p = 0; p < 30; ++p) {
    Push push{(41 * p) % static_cast<int>(model.triangles.size()), {0.2, 0.5, 0.3}, {}};
    push.force = Vec3(0.1 * p, 1.0, -0.3 * p);
    const auto& [a, b, c] = model.triangles[push.triangle];
    const Vec3 at = 0.2 * skin[a] + 0.5 * skin[b] + 0.3 * skin[c];
    force += push.force;
    torque += at.cross(push.force);
    pushes.push_back(push);
  }
  Vec3Array f(model.mass.size(), Vec3::Zero());

  accumulate_push_forces(model.triangles, model.skin, pushes, f);

  CHECK((scenes::sum(f) - force).norm() < 1e-13 * force.norm());
  CHECK((scenes::compute_torque(state.position, f) - torque).norm() < 1e-13 * torque.norm());
}
