// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/model/tissue_model.h"
#include "scenes/linear_solids.h"

using namespace palpate;
using doctest::Approx;

namespace {

constexpr double kShares[] = {0.0, 0.4, 1.0};

Vec3Array elastic_forces(const TissueModel& model, const Vec3Array& x, const Vec3Array& v) {
  Vec3Array f(x.size(), Vec3::Zero());
  accumulate_elastic_forces(model.elastic, model.rest_position, x, v, f);
  return f;
}

Vec3Array elastic_forces(const TissueModel& model, const Vec3Array& x) {
  return elastic_forces(model, x, Vec3Array(x.size(), Vec3::Zero()));
}

double energy_at(const TissueModel& model, const Vec3Array& x) {
  State state(model);
  state.position = x;
  return compute_energy(model, Vec3::Zero(), state).elastic();
}

Eigen::VectorXd stack(const Vec3Array& points) {
  return Eigen::Map<const Eigen::VectorXd>(points[0].data(), 3 * Eigen::Index(points.size()));
}

}  // namespace

TEST_CASE("a tetrahedron drawn out by a tenth of its height pulls back by (lambda + 2 mu)/60") {
  // strain 0.1 along z, stress (lambda + 2 mu)/10, and a third of the face below is 1/6 m²
  for (const double share : kShares) {
    const Vec3Array rest = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Elastic elastic = build_elastic(4, {{0, 1, 2, 3}}, {200.0}, {50.0}, share);
    Vec3Array x = rest, f(4, Vec3::Zero());
    x[3].z() = 1.1;

    accumulate_elastic_forces(elastic, rest, x, Vec3Array(4, Vec3::Zero()), f);

    CHECK(f[3].z() == Approx(-300.0 / 60.0));
    CHECK(f[1].x() == Approx(-200.0 / 60.0));  // held thick, it pulls inward with lambda/10
    CHECK(scenes::sum(f).norm() < 1e-13);
  }
}

TEST_CASE("where it is moved or turned a little a linear solid exerts no force") {
  for (const double share : kShares) {
    const TissueModel model = scenes::make_linear_organ(3, share);
    Vec3Array moved = model.rest_position, turned = moved;
    for (Vec3& x : moved) x += Vec3(0.1, -0.2, 0.3);
    for (Vec3& x : turned) x += Vec3(1e-3, 2e-3, -1e-3).cross(x);

    CHECK(scenes::max_norm(elastic_forces(model, moved)) < 1e-12);
    CHECK(scenes::max_norm(elastic_forces(model, turned)) < 1e-12);
  }
}

TEST_CASE("turned far a linear solid is strained, with the square of the angle") {
  // the fault of the model: strain in the plane of turning is cos(angle) - 1
  const TissueModel model = scenes::make_linear_organ(3, 0.9);
  const auto force_at = [&](double angle) {
    const Quaternion turn(Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()));
    Vec3Array x = model.rest_position;
    for (Vec3& p : x) p = turn * p;
    return scenes::max_norm(elastic_forces(model, x));
  };

  CHECK(force_at(0.2) == Approx((1.0 - std::cos(0.2)) / (1.0 - std::cos(0.1)) * force_at(0.1)));
  CHECK(force_at(0.5) > 1e-2);
}

TEST_CASE("a linear solid keeps momentum, and angular momentum about the places at rest") {
  for (const double share : kShares) {
    const TissueModel model = scenes::make_linear_organ(3, share);

    const Vec3Array f = elastic_forces(model, scenes::strained(model, 2e-3));

    CHECK(scenes::sum(f).norm() < 1e-12 * scenes::max_norm(f));
    CHECK(scenes::compute_torque(model.rest_position, f).norm() < 1e-13 * scenes::max_norm(f));
  }
}

TEST_CASE("the forces of a linear solid are the negative slope of its energy") {
  for (const double share : kShares) {
    const TissueModel model = scenes::make_linear_organ(2, share);
    Vec3Array x = scenes::strained(model, 2e-3);
    const Vec3Array f = elastic_forces(model, x);
    for (const int i : {13, 20, 26}) {
      for (int axis = 0; axis < 3; ++axis) {
        constexpr double kShift = 1e-5;  // the energy is a parabola: no step is too long
        const double middle = x[i][axis];
        x[i][axis] = middle + kShift;
        const double above = energy_at(model, x);
        x[i][axis] = middle - kShift;
        const double below = energy_at(model, x);
        x[i][axis] = middle;

        CHECK(f[i][axis] == Approx((below - above) / (2.0 * kShift)).epsilon(1e-8));
      }
    }
  }
}

TEST_CASE("the tangent of a linear solid is its law, at any displacement") {
  for (const double share : kShares) {
    TissueModel model = scenes::make_linear_organ(2, share);
    model.fixed.clear();
    const Vec3Array x = scenes::strained(model, 5e-3);
    const Eigen::VectorXd u = stack(x) - stack(model.rest_position);

    const auto k = compute_stiffness(model, x, Projection::none);

    const Eigen::VectorXd f = stack(elastic_forces(model, x));
    CHECK((k * u + f).norm() < 1e-12 * f.norm());
    CHECK((Eigen::SparseMatrix<double>(k.transpose()) - k).norm() < 1e-14 * k.norm());
  }
}

TEST_CASE("damping of a linear solid counts a rate of strain as so much strain") {
  const TissueModel model = scenes::make_linear_organ(2, 0.9, 0.3);
  const Vec3Array x = scenes::strained(model, 1e-3);
  Vec3Array v(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    v[i] = (x[i] - model.rest_position[i]) / model.elastic.damping_time;
  }

  const Vec3Array still = elastic_forces(model, x), moving = elastic_forces(model, x, v);

  for (std::size_t i = 0; i < x.size(); ++i) {
    CHECK((moving[i] - 2.0 * still[i]).norm() < 1e-12 * scenes::max_norm(still));
  }
  const auto c = compute_damping(model, x);
  const auto k = compute_stiffness(model, x, Projection::none);
  CHECK((c - model.elastic.damping_time * k).norm() < 1e-14 * c.norm());
}
