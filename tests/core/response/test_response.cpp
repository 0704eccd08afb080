// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>

#include "core/model/refusal.h"
#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/response/private/relax.h"
#include "palpate/sim/response/response.h"
#include "scenes/linear_solids.h"

using namespace palpate;
using doctest::Approx;

namespace {

/// [-] What a float leaves of a compliance, beside the largest of its kind.
constexpr double kFloatError = 1e-6;

/// [m/N] (3 moved, 3 pushed), as a matrix.
Eigen::MatrixXd compliance_of(const Response& response) {
  using Table = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Table>(response.compliance.data(), 3 * response.size.pushed,
                                 3 * response.size.moved)
      .cast<double>()
      .transpose();
}

/// A bar of 10 x 10 x 100 mm without Poisson's effect, held at its lower end; E = 2 mu = 5 kPa.
TissueModel make_bar() {
  const SolidMesh solid = scenes::make_block({0.01, 0.01, 0.1}, {2, 2, 10});
  TissueModel model = build_linear_solid(solid, {}, {.nodal_share = 0.5});
  std::fill(model.elastic.lame.begin(), model.elastic.lame.end(), 0.0);
  std::fill(model.elastic.shear.begin(), model.elastic.shear.end(), 2500.0);
  for (int i = 0; i < particle_count(model); ++i) {
    if (model.rest_position[i].z() < -0.0499) model.fixed.push_back(i);
  }
  return model;
}

/// The particle whose rest is nearest to a point.
int find_particle(const TissueModel& model, const Vec3& point) {
  const auto nearest = std::min_element(
      model.rest_position.begin(), model.rest_position.end(),
      [&](const Vec3& a, const Vec3& b) { return (a - point).norm() < (b - point).norm(); });
  return static_cast<int>(nearest - model.rest_position.begin());
}

/// Pushes all of the surface's triangles, each in its own way.
Load push_everywhere(const TissueModel& model, double force) {
  Load load(static_cast<int>(model.triangles.size()));
  for (int t = 0; t < static_cast<int>(model.triangles.size()); ++t) {
    load.add({t, Vec3(0.2, 0.3, 0.5),
              force * Vec3(scenes::scatter(3 * t), scenes::scatter(3 * t + 1),
                           scenes::scatter(3 * t + 2))});
  }
  return load;
}

}  // namespace

TEST_CASE("a bar under an end load becomes longer by F L/(E A)") {
  // 1 mN on 1 cm² of 5 kPa: 0.2 % of 100 mm
  const TissueModel bar = make_bar();
  const Response response = build_response(bar);
  Load load(static_cast<int>(bar.triangles.size()));
  for (int t = 0; t < static_cast<int>(bar.triangles.size()); ++t) {
    const auto& [a, b, c] = bar.triangles[t];
    const Vec3Array& x = bar.rest_position;
    if (std::min({x[a].z(), x[b].z(), x[c].z()}) < 0.0499) continue;
    const double area = 0.5 * (x[b] - x[a]).cross(x[c] - x[a]).norm();
    load.add({t, Vec3::Constant(1.0 / 3.0), Vec3(0.0, 0.0, 1e-3 * area / 1e-4)});
  }
  ResponseState state(response);
  Vec3Array x = bar.rest_position;

  relax(response, bar, load, 1.0, state);
  settle(response, bar, state, x);

  for (const double z : {-0.03, 0.0, 0.05}) {
    const int i = find_particle(bar, {0.005, 0.005, z});
    CHECK((x[i] - bar.rest_position[i]).z() == Approx(0.002 * (z + 0.05)).epsilon(1e-5));
    CHECK(std::abs((x[i] - bar.rest_position[i]).x()) < 1e-9);
  }
}

TEST_CASE("the response is the inverse of the stiffness, and works both ways alike") {
  for (const double share : {0.0, 0.9}) {
    const TissueModel model = scenes::make_linear_organ(2, share);
    const Response response = build_response(model);
    Eigen::MatrixXd k = compute_stiffness(model, model.rest_position, Projection::none);
    for (const int i : model.fixed) k.diagonal().segment<3>(3 * i).setOnes();
    const Eigen::MatrixXd inverse = k.inverse();
    Eigen::MatrixXd expected(3 * response.size.moved, 3 * response.size.moved);
    for (int r = 0; r < response.size.moved; ++r) {
      for (int c = 0; c < response.size.moved; ++c) {
        expected.block<3, 3>(3 * r, 3 * c) =
            inverse.block<3, 3>(3 * response.particle[r], 3 * response.particle[c]);
      }
    }

    const Eigen::MatrixXd g = compliance_of(response);

    const double largest = expected.cwiseAbs().maxCoeff();
    CHECK((g - expected).cwiseAbs().maxCoeff() < kFloatError * largest);
    // Maxwell and Betti
    CHECK((g - g.transpose()).cwiseAbs().maxCoeff() < kFloatError * largest);
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(expected).eigenvalues()[0] > 0.0);
  }
}

TEST_CASE("a smaller reach has the same answers, of fewer pushes") {
  const TissueModel model = scenes::make_covered_linear_organ(3, 0.9);
  const TissueModel limited = limit_reach(model, {0, 1, 2});
  const Response whole = build_response(model), part = build_response(limited);

  CHECK(part.size.moved == whole.size.moved);
  CHECK(part.size.pushed < whole.size.pushed);
  CHECK(part.size.bytes == 36u * part.size.moved * part.size.pushed);
  const Eigen::MatrixXd all = compliance_of(whole), some = compliance_of(part);
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    if (part.column[i] < 0) continue;
    CHECK(some.middleCols(3 * part.column[i], 3) == all.middleCols(3 * whole.column[i], 3));
  }
  CHECK(part.self_compliance[0] == Approx(whole.self_compliance[0]));
  CHECK(part.self_compliance.back() < whole.self_compliance.back());
}

TEST_CASE("memory is said before anything is solved, and refused where it is too much") {
  const TissueModel model = scenes::make_linear_organ(3, 0.9);
  const ResponseSize size = measure_response(model);
  const Response response = build_response(model);

  // 64 particles, 8 of them inside and 16 held below
  CHECK(size.moved == 40);
  CHECK(size.bytes == 4u * 120 * 120);
  CHECK(response.compliance.size() * sizeof(float) == size.bytes);
  CHECK(find_refusal([&] { build_response(model, Vec3::Zero(), 57599); }) ==
        "linear solid: response: got 0.0576 MB for 40 particles under pushes on 40, expected at "
        "most 0.057599 MB: fill with fewer tetrahedra, or limit the reach of pushes");
  CHECK(find_refusal([&] { build_response(model, Vec3::Zero(), 57600); }) == "");
}

TEST_CASE("too much memory is refused at once, however large the body") {
  // 25 000 particles, whose solution would take hours
  TissueModel model;
  const SolidMesh solid = scenes::make_block({0.1, 0.1, 0.1}, {28, 28, 28});
  model.rest_position = solid.vertices;
  model.mass.assign(solid.vertices.size(), 1e-3);
  model.triangles = find_boundary(solid);
  const std::vector<double> moduli(solid.tetrahedra.size(), 1e3);
  model.elastic = build_elastic(particle_count(model), solid.tetrahedra, moduli, moduli);
  model.fixed = {0, 1, 29};

  CHECK(find_refusal([&] { build_response(model); }).find(" MB for 4703 particles") !=
        std::string::npos);
}

TEST_CASE("a body that is not held, or is no linear solid, has no response") {
  TissueModel loose = scenes::make_linear_organ(2, 0.9), hinged = loose, held = loose;
  loose.fixed.clear();
  hinged.fixed = {0, 1};
  held.fixed.clear();
  held.home.assign(held.mass.size(), 1.0);
  const std::string expected =
      "linear solid: fixed: got a body that can move without being strained, expected particles "
      "held that do not lie on one line, or home springs";

  CHECK(find_refusal([&] { build_response(loose); }) == expected);
  CHECK(find_refusal([&] { build_response(hinged); }) == expected);
  CHECK(find_refusal([&] { build_response(held); }) == "");
  CHECK(find_refusal([] { build_response(scenes::make_solid_organ(2, 0.0)); }) ==
        "linear solid: model: got no elastic tetrahedra, expected a model of build_linear_solid");
  held.fixed = {};
  for (int i = 0; i < particle_count(held); ++i) held.fixed.push_back(i);
  CHECK(find_refusal([&] { build_response(held); }) ==
        "linear solid: reach: got no particle of the surface that moves, expected at least one");
}

TEST_CASE("what the tool may touch is where the whole will be once the tick has ended") {
  const TissueModel model = scenes::make_covered_linear_organ(3, 0.9);
  const Response response = build_response(model, Vec3(0.0, 0.0, -9.81));
  ResponseState state(response);
  Vec3Array near = model.rest_position, all = near;
  std::vector<int> particles(model.mass.size());
  for (std::size_t i = 0; i < particles.size(); ++i) particles[i] = static_cast<int>(i);

  for (int tick = 0; tick < 3; ++tick) {
    for (int s = 0; s < 4; ++s) {
      relax(response, model, push_everywhere(model, 1e-3 * (tick + s)), 0.1, state);
    }
    place_near(response, model, state, particles, near);
    settle(response, model, state, all);

    CHECK(scenes::max_difference(near, all) < kFloatError * 1e-3);
    CHECK(scenes::max_difference(all, model.rest_position) > 1e-4);
  }
}

TEST_CASE("held pushes bring a linear solid to rest where its stiffness balances them") {
  const TissueModel model = scenes::make_linear_organ(3, 0.9);
  const Vec3 gravity(0.0, 1.0, -9.81);
  const Response response = build_response(model, gravity);
  const Load load = push_everywhere(model, 1e-3);
  ResponseState state(response);
  Vec3Array x = model.rest_position;

  for (int tick = 0; tick < 100; ++tick) {
    relax(response, model, load, 0.3, state);
    settle(response, model, state, x);
  }

  Vec3Array f(x.size(), Vec3::Zero());
  accumulate_gravity(model.mass, gravity, f);
  accumulate_push_forces(model.triangles, model.skin, load.pushes(), f);
  for (const int i : model.fixed) f[i].setZero();
  const auto k = compute_stiffness(model, model.rest_position, Projection::none);
  Eigen::Map<const Eigen::VectorXd> forces(f[0].data(), 3 * particle_count(model));
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors;
  Eigen::SparseMatrix<double> held = k;
  for (const int i : model.fixed) {
    for (int axis = 0; axis < 3; ++axis) held.coeffRef(3 * i + axis, 3 * i + axis) = 1.0;
  }
  factors.compute(held);
  const Eigen::VectorXd u = factors.solve(forces);
  for (const int i : response.particle) {
    CHECK((x[i] - model.rest_position[i] - Vec3(u.segment<3>(3 * i))).norm() < 1e-5 * u.norm());
  }
}

TEST_CASE("a linear solid has no packed form, and packing it is refused") {
  const TissueModel model = build_linear_solid(scenes::make_round_block(2), {});
  CHECK_FALSE(has_packed_form(model));
  CHECK_THROWS_WITH_AS(pack(model),
                       ("elastic: got " + std::to_string(model.elastic.corners.size()) +
                        " rows, expected none: linear solids have no packed form")
                           .c_str(),
                       std::invalid_argument);
}
