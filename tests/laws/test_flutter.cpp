// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "laws/linear_tissue.h"
#include "palpate/sim/dynamics/tangent.h"
#include "palpate/sim/model/definiteness.h"

// Where the molecular model fails: Eq 10 flutters on uneven triangles [laws: eq10], Eq 11 gives way
// beyond its bound [laws: definite].

using namespace palpate;
using namespace palpate::laws;
using doctest::Approx;

namespace {

/// A ball of 60 mm whose vertices are moved along it by up to `uneven` of an edge: 42 vertices.
SurfaceMesh make_ball(double uneven) {
  SurfaceMesh ball = scenes::make_ellipsoid(Vec3::Ones(), 1);
  const double edge =
      (ball.vertices[ball.triangles[0][0]] - ball.vertices[ball.triangles[0][1]]).norm();
  const Vec3Array moves = scenes::scatter_vectors(ball.vertices.size(), uneven * edge, 3);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    ball.vertices[i] = 0.03 * (ball.vertices[i] + moves[i]).normalized();
  }
  return ball;
}

/// Bonds of 50 N/m under Eq 10 with K10 [N], held at its base, its links damped.
TissueModel make_eq10_ball(double uneven, double k10, double damping_ratio) {
  const SurfaceMesh mesh = make_ball(uneven);
  const scenes::Losses losses{.damping_ratio = damping_ratio};
  SurfaceOptions options = scenes::make_options(losses, scenes::find_base(mesh));
  options.home_stiffness = 0.0;
  return build_molecular(
      mesh, scenes::make_material(losses),
      {.bond_stiffness = 50.0, .bend_stiffness = k10, .angle_law = AngleLaw::eq10}, options);
}

struct Growth {
  double rate = 0.0;          ///< [1/s]
  VectorXd offset, velocity;  ///< of the motion that grows so, in scaled coordinates
};

/// The motion that grows fastest: the eigenvalue of (x, v)' = ((0, 1), (-K, -C)) (x, v) with the
/// largest real part, Eq 10's K as it is measured, without symmetry.
Growth find_fastest_growth(const LinearTissue& tissue) {
  const Eigen::Index n = tissue.stiffness.rows();
  MatrixXd slope(2 * n, 2 * n);
  slope << MatrixXd::Zero(n, n), MatrixXd::Identity(n, n), -tissue.exact_stiffness, -tissue.damping;
  const Eigen::EigenSolver<MatrixXd> solver(slope);
  Eigen::Index most = 0;
  const double rate = solver.eigenvalues().real().maxCoeff(&most);
  const VectorXd motion = solver.eigenvectors().col(most).real();
  return {rate, motion.head(n), motion.tail(n)};
}

/// [1/s] at which that motion grows when the tissue itself is stepped for `seconds`: from the
/// largest offsets in the first and in the last fifth of it.
double measure_growth(const TissueModel& model, const LinearTissue& tissue, const Growth& start,
                      double seconds) {
  State state(model);
  const double size = start.offset.cwiseQuotient(tissue.root_mass).cwiseAbs().maxCoeff();
  displace(tissue, start.offset * (1e-9 / size), start.velocity * (1e-9 / size), state);
  const double dt = 0.02 * stable_step(model);
  const int steps = static_cast<int>(seconds / dt);
  double early = 0.0, late = 0.0;
  for (int s = 0; s < steps; ++s) {
    step(model, Load(), dt, state);
    const double offset = scenes::max_difference(state.position, model.rest_position);
    if (s < steps / 5) early = std::max(early, offset);
    if (s >= steps - steps / 5) late = std::max(late, offset);
  }
  return std::log(late / early) / (0.8 * seconds);
}

/// The damping ratio of links at which nothing grows any more, by halving an interval.
double predict_calming_ratio(double uneven, double k10) {
  double growing = 0.0, calm = 0.2;
  for (int halving = 0; halving < 12; ++halving) {
    const double middle = 0.5 * (growing + calm);
    const LinearTissue tissue(make_eq10_ball(uneven, k10, middle));
    (find_fastest_growth(tissue).rate > 0.0 ? growing : calm) = middle;
  }
  return calm;
}

constexpr double kUneven = 0.45, kFlutter = 0.5;  // [-], [N]

/// Three particles: a corner with two arms of 10 mm, on bonds of k and an angle alone.
TissueModel make_corner(double bond, double bend, double coupling) {
  TissueModel model;
  model.rest_position = {{0, 0, 0}, {0.01, 0, 0}, {0.005, 0.008, 0}};
  model.mass.assign(3, 1e-3);
  model.triangles = {{0, 1, 2}};
  model.angles = scenes::make_angles(model.triangles, model.rest_position, 0.0, 0.0);
  model.angles.bend_stiffness = {{bend, 0.0, 0.0}};
  model.angles.stretch_coupling = {{coupling, 0.0, 0.0}};
  for (const int end : {1, 2}) {
    model.bonds.ends.push_back({0, end});
    model.bonds.rest_length.push_back(model.rest_position[end].norm());
    model.bonds.stiffness.push_back(bond);
    model.bonds.damping.push_back(0.0);
  }
  return model;
}

/// A triangle of the given sides [m] with bonds of 50 N/m and one K_btheta at its corners.
TissueModel make_triangle(const Vec3& sides, double bend, double coupling) {
  TissueModel model;
  const double along =
      (sides[1] * sides[1] + sides[2] * sides[2] - sides[0] * sides[0]) / (2.0 * sides[2]);
  model.rest_position = {
      {0, 0, 0}, {sides[2], 0, 0}, {along, std::sqrt(sides[1] * sides[1] - along * along), 0}};
  model.mass.assign(3, 1e-3);
  model.triangles = {{0, 1, 2}};
  model.angles = scenes::make_angles(model.triangles, model.rest_position, 0.0, 0.0);
  model.angles.bend_stiffness = {{bend, bend, bend}};
  model.angles.stretch_coupling = {{coupling, coupling, coupling}};
  model.angles.bond_share = {{50.0, 50.0, 50.0}};
  for (const auto& [i, j] : {std::array{0, 1}, {0, 2}, {1, 2}}) {
    model.bonds.ends.push_back({i, j});
    model.bonds.rest_length.push_back((model.rest_position[i] - model.rest_position[j]).norm());
    model.bonds.stiffness.push_back(50.0);
    model.bonds.damping.push_back(0.0);
  }
  return model;
}

/// [1/s²] M⁻¹K at rest by the tangent, in the scaled free coordinates of a LinearTissue: a bound is
/// sharper than differences of forces are.
MatrixXd build_rest_stiffness(const TissueModel& model, const LinearTissue& tissue) {
  const MatrixXd all = compute_stiffness(model, model.rest_position, Projection::none);
  const Eigen::Index n = tissue.stiffness.rows();
  MatrixXd free(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const int p = tissue.particles[static_cast<std::size_t>(i / 3)];
      const int q = tissue.particles[static_cast<std::size_t>(j / 3)];
      free(i, j) = all(3 * p + i % 3, 3 * q + j % 3) / (tissue.root_mass[i] * tissue.root_mass[j]);
    }
  }
  return free;
}

/// [1/s²] its least eigenvalue, below 0 where the tissue gives way.
double find_least(const TissueModel& model, VectorXd* shape = nullptr) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
      build_rest_stiffness(model, LinearTissue(model)));
  if (shape != nullptr) *shape = solver.eigenvectors().col(0);
  return solver.eigenvalues()[0];
}

/// Holds that a tissue is at rest for good within its bound, and beyond it leaves at the rate
/// sqrt(-lambda): `make(coupling)` with the bound that is foretold [N].
template <class Make>
void check_bound(double bound, Make make) {
  const TissueModel within = make(0.95 * bound), beyond = make(1.05 * bound);
  const double stiff = find_top_mode(LinearTissue(within)).frequency;
  // rounding leaves rigid motions a little beside 0
  CHECK(find_least(within) > -1e-10 * stiff * stiff);

  VectorXd shape;
  const double least = find_least(beyond, &shape);
  REQUIRE(least < -1e-9 * stiff * stiff);
  const double rate = std::sqrt(-least);
  const LinearTissue tissue(beyond);
  State state(beyond);
  const double size = shape.cwiseQuotient(tissue.root_mass).cwiseAbs().maxCoeff();
  displace(tissue, shape * (1e-8 / size), shape * (rate * 1e-8 / size), state);
  const double start = scenes::max_difference(state.position, beyond.rest_position);
  const double dt = 0.02 / find_top_mode(tissue).frequency;
  const int steps = static_cast<int>(4.0 / (rate * dt));
  for (int s = 0; s < steps; ++s) step(beyond, Load(), dt, state);
  const double moved = scenes::max_difference(state.position, beyond.rest_position);
  CHECK(std::log(moved / start) / (steps * dt) == Approx(rate).epsilon(0.05));
}

}  // namespace

TEST_CASE("Eq 10 flutters on uneven triangles as its stiffness foretells, and on even ones not") {
  const TissueModel uneven = make_eq10_ball(kUneven, kFlutter, 0.0);
  const LinearTissue tissue(uneven);
  const Growth fastest = find_fastest_growth(tissue);
  const double top = find_top_mode(tissue).frequency;

  CHECK(fastest.rate > 1e-3 * top);
  CHECK(measure_growth(uneven, tissue, fastest, 4.0 / fastest.rate) ==
        Approx(fastest.rate).epsilon(0.05));

  const LinearTissue even(make_eq10_ball(0.0, kFlutter, 0.0));
  CHECK(find_fastest_growth(even).rate < 0.05 * fastest.rate);
  const TissueModel soft = make_eq10_ball(kUneven, 0.1 * kFlutter, 0.0);
  CHECK(find_fastest_growth(LinearTissue(soft)).rate < 0.3 * fastest.rate);
}

TEST_CASE("the damping that stops Eq 10's flutter is where the eigenvalues say, within 5 %") {
  const double ratio = predict_calming_ratio(kUneven, kFlutter);
  CHECK(ratio > 1e-3);

  for (const double part : {0.95, 1.05}) {
    CAPTURE(part);
    const TissueModel model = make_eq10_ball(kUneven, kFlutter, part * ratio);
    const LinearTissue tissue(model);
    const Growth fastest = find_fastest_growth(tissue);
    const double undamped =
        find_fastest_growth(LinearTissue(make_eq10_ball(kUneven, kFlutter, 0.0))).rate;
    const double measured = measure_growth(model, tissue, fastest, 10.0 / undamped);
    CHECK((measured > 0.0) == (part < 1.0));
  }
}

TEST_CASE("Eq 11 on one corner gives way beyond K_bt² = k K_theta/2, and not before") {
  for (const double bend : {1e-4, 1e-3, 1e-2}) {
    const double bond = 50.0, bound = std::sqrt(0.5 * bond * bend);
    for (const double sign : {-1.0, 1.0}) {
      CAPTURE(bend);
      check_bound(sign * bound, [&](double coupling) { return make_corner(bond, bend, coupling); });
    }
  }
}

TEST_CASE("Eq 11 on one triangle gives way where its range of K_btheta ends, and not before") {
  const double l = 0.009, root2 = std::numbers::sqrt2, root3 = std::numbers::sqrt3;
  const double bend = 1e-4;
  // by hand for equal sides: -(l/3)(k' + 9 K_theta/(4 l²))
  check_bound(-(l / 3.0) * (50.0 + 2.25 * bend / (l * l)), [&](double coupling) {
    return make_triangle({l, l, l}, bend, coupling);
  });

  for (const Vec3& shape : {Vec3(root2, 1, 1), Vec3(1, 2, root3), Vec3(root3, 1, 1)}) {
    const TissueModel model = make_triangle(l * shape, bend, 0.0);
    const auto range = find_coupling_range(model.angles, 0, {1.0, 1.0, 1.0});
    REQUIRE(range.has_value());
    for (const double end : {range->low, range->high}) {
      CAPTURE(end);
      check_bound(end, [&](double k) { return make_triangle(l * shape, bend, k); });
    }
  }
}

TEST_CASE("Eq 11 on a mesh gives way at the bound of the whole, which its triangles keep within") {
  // flat, so that its rim has uneven triangles and the range two ends
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.05, 0.035, 0.004}, 1);
  const auto make = [&](double coupling) {
    SurfaceOptions options = scenes::make_options({}, scenes::find_base(mesh));
    options.home_stiffness = 0.0;
    TissueModel model =
        build_molecular(mesh, scenes::make_material({}), {.bond_stiffness = 50.0}, options);
    for (auto& row : model.angles.stretch_coupling) row = {coupling, coupling, coupling};
    return model;
  };
  // linear in K_btheta: K0 + k K1 is singular where 1 + k times an eigenvalue of K0^-1 K1 is 0
  const TissueModel bonds = make(0.0);
  const LinearTissue tissue(bonds);
  const MatrixXd plain = build_rest_stiffness(bonds, tissue);
  const MatrixXd slope = build_rest_stiffness(make(1.0), tissue) - plain;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(slope, plain,
                                                                  Eigen::EigenvaluesOnly);
  const double low = -1.0 / solver.eigenvalues().maxCoeff();
  const double high = -1.0 / solver.eigenvalues().minCoeff();
  REQUIRE(low < 0.0);
  REQUIRE(high > 0.0);
  const Angles& angles = bonds.angles;
  double worst_low = -INFINITY, worst_high = INFINITY;
  for (int row = 0; row < static_cast<int>(angles.corners.size()); ++row) {
    const auto range = find_coupling_range(angles, row, {1.0, 1.0, 1.0});
    REQUIRE(range.has_value());
    worst_low = std::max(worst_low, range->low);
    worst_high = std::min(worst_high, range->high);
  }
  CHECK(worst_low > low);
  CHECK(worst_high < high);

  check_bound(low, make);
  check_bound(high, make);
}
