// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <numbers>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/response/private/local_compliance.h"
#include "scenes/held_block.h"
#include "scenes/hyperelastic_solids.h"
#include "scenes/linear_solids.h"
#include "scenes/shells.h"
#include "scenes/solids.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

namespace {

constexpr int kAll = 1 << 30;

/// The middle of a triangle, pushed along x, y and z.
std::vector<Push> push_axes(int triangle) {
  std::vector<Push> pushes;
  for (int axis = 0; axis < 3; ++axis) {
    pushes.push_back({triangle, Vec3(0.2, 0.3, 0.5), Vec3::Unit(axis)});
  }
  return pushes;
}

Mat3 compliance_at(const TissueModel& model, std::span<const Vec3> x, int triangle, int most) {
  return compute_local_compliance(model, x, push_axes(triangle), most).value();
}

/// The triangle nearest to the z axis, of those on top.
int find_top(const TissueModel& model) {
  const Vec3Array x = compute_surface(model, model.rest_position);
  int top = 0;
  double best = -1.0;
  for (int t = 0; t < static_cast<int>(model.triangles.size()); ++t) {
    Vec3 middle = Vec3::Zero();
    for (const int v : model.triangles[static_cast<std::size_t>(t)]) {
      middle += x[static_cast<std::size_t>(v)] / 3.0;
    }
    const double height = middle.z() - middle.head<2>().norm();
    if (height > best) best = height, top = t;
  }
  return top;
}

/// [m] Where 1 N times `force` on a point of the surface holds the model: Newton's steps until the
/// forces of the laws balance it.
Vec3Array balance(const TissueModel& model, int triangle, const Vec3& force) {
  Load load(1);
  load.add({triangle, Vec3(0.2, 0.3, 0.5), force});
  Vec3Array x = model.rest_position, f(x.size());
  const Vec3Array v(x.size(), Vec3::Zero());
  for (int step = 0; step < 4; ++step) {
    compute_forces(model, load, x, v, f);
    Eigen::SparseMatrix<double> stiffness = compute_stiffness(model, x, Projection::none);
    for (const int i : model.fixed) {
      for (int k = 0; k < 3; ++k) stiffness.coeffRef(3 * i + k, 3 * i + k) = 1.0;
      f[static_cast<std::size_t>(i)].setZero();
    }
    const Eigen::Map<const Eigen::VectorXd> left(f[0].data(), 3 * f.size());
    const Eigen::VectorXd u = Eigen::SimplicialLDLT<decltype(stiffness)>(stiffness).solve(left);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += u.segment<3>(3 * i);
  }
  return x;
}

Vec3 place(const TissueModel& model, const Vec3Array& x, int triangle) {
  const Vec3Array surface = compute_surface(model, x);
  const auto& [a, b, c] = model.triangles[static_cast<std::size_t>(triangle)];
  return 0.2 * surface[static_cast<std::size_t>(a)] + 0.3 * surface[static_cast<std::size_t>(b)] +
         0.5 * surface[static_cast<std::size_t>(c)];
}

/// A tissue of every kind of law that has a tangent.
std::vector<std::pair<const char*, TissueModel>> list_tissues() {
  return {{"springs", scenes::make_spring_organ(2)},
          {"molecular", scenes::make_molecular_organ(2)},
          {"prisms", scenes::make_shell_organ(2)},
          {"springs and volumes", scenes::make_solid_organ(4, 0.9)},
          {"under a skin", scenes::make_covered_organ(4, 0.9)},
          {"linear", scenes::make_linear_organ(4, 0.9)},
          {"corotated", scenes::make_finite_organ(scenes::kFiniteLaws[0], 4, 0.9)},
          {"neo-Hookean", scenes::make_finite_organ(scenes::kFiniteLaws[1], 4, 0.9)}};
}

/// A chain along x as the corners of a triangle of no area at its end.
TissueModel make_chain(int n, double stiffness) {
  TissueModel chain = scenes::make_chain_model(n, 1e-3, stiffness);
  chain.triangles = {{n - 3, n - 2, n - 1}};
  return chain;
}

}  // namespace

TEST_CASE("the end of a chain gives way by 1/k a spring, and cut out by 1/k for each that moves") {
  const TissueModel chain = make_chain(11, 100.0);
  const std::vector<Push> push = {{0, Vec3::UnitZ(), Vec3::UnitX()}};
  const auto compliance = [&](int most) {
    return (*compute_local_compliance(chain, chain.rest_position, push, most))(0, 0);
  };

  // the inertia of 1 g over 3 s is 0.1 mN/m on each particle
  CHECK(compliance(kAll) == Approx(10.0 / 100.0).epsilon(5e-4));
  CHECK(compliance(5) == Approx(5.0 / 100.0).epsilon(2e-4));
  CHECK(compliance(3) == Approx(3.0 / 100.0).epsilon(1e-4));
}

TEST_CASE("what is cut out has the tangent of the whole among the particles that move") {
  for (const auto& [name, model] : list_tissues()) {
    CAPTURE(name);
    const Vec3Array x = scenes::strained(model, 5e-4);
    const Eigen::MatrixXd whole = compute_stiffness(model, x, Projection::none);

    const CutOut cut = cut_out(model, x, place(model, x, find_top(model)), 30);

    REQUIRE(particle_count(cut.model) < particle_count(model));
    REQUIRE(particle_count(cut.model) - static_cast<int>(cut.model.fixed.size()) == 30);
    const Eigen::MatrixXd part = compute_stiffness(cut.model, cut.x, Projection::none);
    std::vector<bool> held(cut.x.size(), false);
    for (const int i : cut.model.fixed) held[static_cast<std::size_t>(i)] = true;
    double worst = 0.0;
    for (std::size_t i = 0; i < cut.x.size(); ++i) {
      for (std::size_t j = 0; j < cut.x.size(); ++j) {
        if (held[i] || held[j]) continue;
        const Mat3 difference = part.block<3, 3>(3 * i, 3 * j) -
                                whole.block<3, 3>(3 * cut.particle[i], 3 * cut.particle[j]);
        worst = std::max(worst, difference.cwiseAbs().maxCoeff());
      }
    }
    CHECK(worst < 1e-9 * whole.cwiseAbs().maxCoeff());
  }
}

TEST_CASE("whole, a tissue gives way as its forces say by finite differences") {
  constexpr double kForce = 1e-4;  // [N]
  for (const auto& [name, model] : list_tissues()) {
    CAPTURE(name);
    const int top = find_top(model);
    Mat3 expected;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Vec3 push = kForce * Vec3::Unit(axis);
      expected.col(axis) = (place(model, balance(model, top, push), top) -
                            place(model, balance(model, top, -push), top)) /
                           (2.0 * kForce);
    }

    const Mat3 compliance = compliance_at(model, model.rest_position, top, kAll);

    CHECK((compliance - expected).norm() < 0.01 * expected.norm());
  }
}

TEST_CASE("the compliance is symmetric and positive, and what is cut out never gives way more") {
  for (const auto& [name, model] : list_tissues()) {
    CAPTURE(name);
    const int top = find_top(model);
    const Mat3 few = compliance_at(model, model.rest_position, top, 20);
    const Mat3 many = compliance_at(model, model.rest_position, top, 60);

    CHECK((few - few.transpose()).norm() == 0.0);
    CHECK(Eigen::SelfAdjointEigenSolver<Mat3>(few).eigenvalues()[0] > 0.0);
    CHECK(Eigen::SelfAdjointEigenSolver<Mat3>(many - few).eigenvalues()[0] > -1e-9 * many.norm());
  }
}

TEST_CASE("the compliance turns with the tissue") {
  const Mat3 turn = Quaternion(0.6, 0.2, -0.5, 0.3).normalized().toRotationMatrix();
  for (const auto& [name, model] : list_tissues()) {
    CAPTURE(name);
    const Vec3Array x = scenes::strained(model, 5e-4);
    TissueModel turned = model;
    Vec3Array turned_x = x;
    for (Vec3& p : turned.rest_position) p = turn * p;
    for (Vec3& p : turned_x) p = turn * p;

    const Mat3 before = compliance_at(model, x, find_top(model), 50);
    const Mat3 after = compliance_at(turned, turned_x, find_top(model), 50);

    CHECK((after - turn * before * turn.transpose()).norm() < 1e-6 * before.norm());
  }
}

TEST_CASE("of a solid that is cut out at R there is missing what tissue moves at R, as foretold") {
  // without Poisson's effect a half space is moved by 1/(pi E R) beside 1 N on it, and by half as
  // much again below it [Boussinesq85]
  const scenes::Held held = scenes::make_held_block(6);
  TissueModel model = build_linear_solid(held.solid, held.material, held.options);
  std::ranges::fill(model.elastic.lame, 0.0);
  std::ranges::fill(model.elastic.shear, 0.5 * scenes::kBlockYoung);
  const Vec3Array& x = model.rest_position;
  const int top = find_top(model);
  const Vec3 at = place(model, x, top);
  const double whole = compliance_at(model, x, top, kAll)(2, 2);

  for (const int most : {15, 30, 60}) {
    CAPTURE(most);
    const CutOut cut = cut_out(model, x, at, most);
    double radius = 1.0;
    for (const int i : cut.model.fixed) {
      radius = std::min(radius, (cut.x[static_cast<std::size_t>(i)] - at).norm());
    }
    const double missing = whole - compliance_at(model, x, top, most)(2, 2);
    const double foretold = 1.0 / (std::numbers::pi * scenes::kBlockYoung * radius);

    CHECK(missing > 0.65 * foretold);
    CHECK(missing < 1.5 * foretold);
  }
}

TEST_CASE(
    "tissue that nothing holds is held by its inertia, and a place without particles is none") {
  TissueModel model = scenes::make_spring_organ(1);
  model.fixed.clear();
  model.home.clear();
  CHECK(compute_local_compliance(model, model.rest_position, push_axes(0), kAll).has_value());

  model.fixed = {model.triangles[0][0], model.triangles[0][1], model.triangles[0][2]};
  std::ranges::sort(model.fixed);
  CHECK_FALSE(compute_local_compliance(model, model.rest_position, push_axes(0), 0).has_value());
}
