// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "palpate/sim/grasp/private/jaws.h"
#include "palpate/sim/model/tissue_model.h"
#include "scenes/grasped.h"

// The geometry of jaws, the layer between them and their anchors [contact: jaws].

using namespace palpate;

namespace {

const Quaternion kTurned(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()));

/// Pressed evenly with `force` [N] all along a jaw.
Pressed press_evenly(double force, double modulus = kLayerPressure, double thickness = kLayer) {
  constexpr double length = scenes::kJawLength;
  return {force, force * length / 2.0, force * length * length / 3.0, force * modulus,
          force * thickness};
}

}  // namespace

TEST_CASE("jaws open about their hinge, one each way, and points go with them") {
  const Tool tool = scenes::make_grasper(0.5, 5.0);
  const OpenJaws jaws(tool, kTurned, 0.3);
  for (const int j : {0, 1}) {
    CAPTURE(j);
    const Vec3 tip = tool.capsules[std::size_t(j)].from;
    const Vec3 at = jaws.to_scene(j, tip);
    CHECK((at - jaws.axis_of(j).from).norm() < 1e-15);
    CHECK((jaws.to_jaw(j, at) - tip).norm() < 1e-15);
    // by hand: a hinge 22.4 mm behind the tip, an axis 1.2 mm aside
    const Vec3 own = kTurned.conjugate() * at;
    const double side = j == 0 ? 1.0 : -1.0, c = std::cos(0.3), s = std::sin(0.3);
    CHECK(own.y() == doctest::Approx(side * (0.0012 * c + 0.0224 * s)));
    CHECK(own.z() == doctest::Approx(0.0224 - 0.0224 * c + 0.0012 * s));
    // dy/da by finite differences
    const double step = 1e-6;
    const Vec3 more = OpenJaws(tool, kTurned, 0.3 + step).to_scene(j, tip);
    const Vec3 less = OpenJaws(tool, kTurned, 0.3 - step).to_scene(j, tip);
    CHECK(((more - less) / (2.0 * step) - jaws.move(j, at)).norm() < 1e-9);
  }
}

// By hand: the points of an equilateral triangle of edge h have the variance h²/24 along every line
// in its plane, and a line of the length l evenly pressed l²/12.
TEST_CASE("what is touched of a pad has the whole of its triangles, however few there are") {
  constexpr double h = 0.006, r = scenes::kJawRadius, length = scenes::kJawLength;
  const std::array<Vec3, 3> x{Vec3(0, 0, 0), Vec3(h, 0, 0), Vec3(0.5 * h, std::sqrt(0.75) * h, 0)};
  const Triangle t{0, 1, 2};
  for (const double angle : {0.0, 0.4, 1.3}) {
    const Vec3 along(std::cos(angle), std::sin(angle), 0.0);
    CHECK(find_extent(t, x, along) == doctest::Approx(h * h / 24.0));
  }
  CHECK(find_extent(t, x, Vec3::UnitZ()) == doctest::Approx(0.0));

  const Tool tool = scenes::make_grasper(0.5, 5.0);
  const double width = tool.jaws->pad_area / length;
  Pressed point{.force = 2.0, .at = 2.0 * 0.01, .spread = 2.0 * 1e-4};  // in the middle
  CHECK(find_covered(tool, point) == doctest::Approx(2.0 * r * width));
  const double half = std::sqrt(3.0 * h * h / 24.0) + r;
  CHECK(find_covered(tool, point, 2.0 * h * h / 24.0) == doctest::Approx(2.0 * half * width));
  CHECK(find_covered(tool, press_evenly(3.0)) == doctest::Approx(tool.jaws->pad_area));
  CHECK(find_covered(tool, press_evenly(3.0), 3.0 * h * h) == doctest::Approx(tool.jaws->pad_area));
}

TEST_CASE("the layer between two jaws resists as it is pressed, and not where one alone touches") {
  const Tool tool = scenes::make_grasper(0.5, 5.0);
  const std::array both{press_evenly(1.0), press_evenly(1.0)};
  const auto squeeze = [&](double angle) {
    return find_squeeze(tool, OpenJaws(tool, kTurned, angle), both);
  };
  // s = 12.4 mm at the middle and 1.2 mm aside, g = 2 s sin a; L = 2 mm
  const double s = std::hypot(0.0124, 0.0012), area = tool.jaws->pad_area;
  CHECK(squeeze(0.09).force == 0.0);
  const double angle = std::asin(0.001 / (2.0 * s));
  CHECK(squeeze(angle).force == doctest::Approx(kLayerPressure * area));
  CHECK(squeeze(0.0).force == doctest::Approx(9.0 * kLayerPressure * area));
  // torque = minus the gradient of the energy of p over the gap, slope = minus that of the torque
  const double a = 0.03, step = 1e-6;
  const double change = squeeze(a + step).torque - squeeze(a - step).torque;
  const double falls = squeeze(a).force * 2.0 * s * std::sin(a);
  CHECK(-change / (2.0 * step) == doctest::Approx(squeeze(a).slope + falls).epsilon(1e-5));

  CHECK(find_squeeze(tool, OpenJaws(tool, kTurned, 0.0), {press_evenly(1.0), {}}).force == 0.0);
  // a wall of prisms of twice 1.5 mm
  const std::array wall{press_evenly(1.0, 1e5, 0.003), press_evenly(1.0, 1e5, 0.003)};
  const OpenJaws at(tool, kTurned, std::asin(0.0015 / (2.0 * s)));
  CHECK(find_squeeze(tool, at, wall).force == doctest::Approx(1e5 * area));
}

TEST_CASE("on a skin jaws add what they hang on the particles under it") {
  const Tool tool = scenes::make_grasper(0.5, 5.0);
  // two tetrahedra with one face in common; a skin of four vertices, one of them beside its own
  TissueModel tissue;
  tissue.mass = {1e-4, 3e-4, 2e-4, 5e-4, 4e-4};
  tissue.skin.corners = {{0, 1, 2, 3}, {0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3, 4}};
  tissue.skin.weights = {
      {1.0, 0.0, 0.0, 0.0}, {0.3, 0.3, 0.4, 0.0}, {0.2, 0.5, 0.2, 0.1}, {-0.2, 0.5, 0.4, 0.3}};
  tissue.triangles = {{0, 1, 2}, {1, 3, 2}};
  Candidates none;
  const std::array<TouchedSurface, 1> surface{{{&none, tissue.triangles, {}, nullptr}}};
  const JawSurfaces surfaces{surface, surface};
  ToolState state(0, 0, 2);
  std::vector<double> scratch(tissue.mass.size(), 0.0);
  const auto bound = [&] {
    std::ranges::fill(scratch, 0.0);
    ParticleRows rows{tissue, scratch};
    add_jaws_on_skin(tool, surfaces, 0, state, rows);
    return rows.largest;
  };
  CHECK(bound() == 0.0);

  // by hand: all of 200 N/m on the particle of 0.1 g
  state.anchor_count = 1;
  state.anchors[0].triangle = 0;
  state.anchors[0].weights = {1.0, 0.0, 0.0};
  state.anchors[0].stiffness = 200.0;
  CHECK(bound() == doctest::Approx(200.0 / 1e-4));

  // no less than the largest eigenvalue of M⁻¹K
  state.anchor_count = 2;
  state.anchors[0].weights = {0.2, 0.3, 0.5};
  state.anchors[1] = state.anchors[0];
  state.anchors[1].jaw = 1;
  state.anchors[1].triangle = 1;
  state.anchors[1].weights = {0.1, 0.8, 0.1};
  state.anchors[1].stiffness = 500.0;
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(5, 5);
  for (int a = 0; a < 2; ++a) {
    const ToolState::Anchor& anchor = state.anchors[std::size_t(a)];
    Eigen::VectorXd row = Eigen::VectorXd::Zero(5);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto v = std::size_t(tissue.triangles[std::size_t(anchor.triangle)][c]);
      for (std::size_t n = 0; n < 4; ++n) {
        row[tissue.skin.corners[v][n]] += anchor.weights[int(c)] * tissue.skin.weights[v][n];
      }
    }
    k += anchor.stiffness * row * row.transpose();
  }
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      k(i, j) /= std::sqrt(tissue.mass[std::size_t(i)] * tissue.mass[std::size_t(j)]);
    }
  }
  const double exact = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues().maxCoeff();
  CHECK(bound() >= exact);
  CHECK(bound() <= 4.0 * exact);
}

TEST_CASE("an anchor pulls as a spring, slips at mu N, and goes with what presses it") {
  const Tool tool = scenes::make_grasper(0.5, 5.0);
  const std::array<Triangle, 1> triangles = {{{0, 1, 2}}};
  std::vector<Vec3> x = {{0.0, 0.0, 0.0}, {0.002, 0.0, 0.0}, {0.0, 0.002, 0.0}};
  Load load(8);
  Candidates candidates(1, 1);
  const TouchedSurface surface{&candidates, triangles, x, &load};
  const OpenJaws jaws(tool, Quaternion::Identity(), 0.1);
  ToolState state(0, 0, 4);
  state.position = Vec3(0.001, 0.0, 0.005);
  const Vec3 middle = Vec3::Constant(1.0 / 3.0);
  const double stiffness = kBristle * 3e7 * 2e-6;

  const auto substep = [&](double pressed) {
    load.clear();
    const int sorted = state.anchor_count;
    unpress_anchors(state);
    if (pressed > 0.0) {
      press_anchor(tool, jaws, {&surface, 1}, {0, 0, 0, middle, pressed}, sorted, state);
    }
    return pull_anchors(tool, jaws, {&surface, 1}, sorted, state);
  };
  CHECK(substep(0.1).norm() == doctest::Approx(0.0));
  REQUIRE(state.anchor_count == 1);
  CHECK(state.anchors[0].stiffness == doctest::Approx(stiffness));

  for (Vec3& corner : x) corner += Vec3(1e-4, 0.0, 3e-4);  // aside by 0.1 mm, and away
  Vec3 force = substep(0.1);
  CHECK((force - Vec3(stiffness * 1e-4, 0.0, 0.0)).norm() < 1e-12);
  REQUIRE(load.push_count == 1);
  CHECK((load.pushes()[0].force + force).norm() == 0.0);
  CHECK(state.held_load == doctest::Approx(force.norm()));

  for (Vec3& corner : x) corner += Vec3(0.001, 0.0, 0.0);
  CHECK((substep(0.1) - Vec3(0.05, 0.0, 0.0)).norm() < 1e-12);  // mu N
  for (Vec3& corner : x) corner -= Vec3(1e-4, 0.0, 0.0);        // and back: a spring again
  CHECK((substep(0.1) - Vec3(0.05 - stiffness * 1e-4, 0.0, 0.0)).norm() < 1e-12);
  CHECK((substep(0.02) - Vec3(0.01, 0.0, 0.0)).norm() < 1e-12);
  CHECK(substep(0.0).norm() == 0.0);
  CHECK(state.anchor_count == 0);
  CHECK_FALSE(state.pinches);
}

namespace {

/// Closed jaws above a ball that gives nowhere, each of which may touch all of it.
struct Poke {
  explicit Poke(double force_max)
      : coupling{.stiffness = 1000.0, .force_max = force_max},
        first(static_cast<int>(mesh.triangles.size())),
        load(8 * static_cast<int>(mesh.triangles.size())) {
    for (const Triangle& t : mesh.triangles) {
      const Vec3 &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
      first.triangles[static_cast<std::size_t>(first.count)] = first.count;
      first.areas[static_cast<std::size_t>(first.count++)] = 0.5 * (b - a).cross(c - a).norm();
    }
    second = first;
    state.placed = true;
    state.grip_limit = tool.jaws->grip;
  }
  const Vec3& corner(const Triangle& t, std::size_t c) const {
    return mesh.vertices[static_cast<std::size_t>(t[c])];
  }

  Vec3 move_hand(const Vec3& hand) {
    first.to = second.to = hand;
    first.from = second.from = state.position;
    const TouchedSurface one{&first, mesh.triangles, mesh.vertices, &load};
    TouchedSurface other = one;
    other.candidates = &second;
    return balance_jaws(tool, coupling, hand, {{{&one, 1}, {&other, 1}}}, 5e-5, state, most_fall);
  }
  Vec3 move_hand_for(const Vec3& hand, int ticks) {
    Vec3 felt = Vec3::Zero();
    for (int i = 0; i < ticks; ++i) felt = move_hand(hand);
    return felt;
  }
  Vec3 push() const {
    Vec3 sum = Vec3::Zero();
    for (const Push& push : load.pushes()) sum += push.force;
    return sum;
  }

  SurfaceMesh mesh = scenes::make_ellipsoid(Vec3::Constant(0.025), 3);
  Tool tool = scenes::make_grasper(0.5, 5.0);
  Coupling coupling;
  Candidates first, second;
  Load load;
  ToolState state{0, 0, 64};
  double most_fall = 0.0;
};

}  // namespace

TEST_CASE("what is felt of jaws that nothing holds falls by what it may") {
  Poke poke(5.0);
  const Vec3 tool(0.0, 0.0, 0.08), hand(0.0, 0.0, 0.083);  // 3 N apart, and nothing is near
  for (Candidates* none : {&poke.first, &poke.second}) none->count = 0;
  poke.state.felt_before = Vec3(0.0, 0.0, -3.0);
  for (const double most_fall : {0.5, 0.01}) {
    CAPTURE(most_fall);
    poke.most_fall = most_fall;
    poke.state.position = tool;

    const Vec3 felt = poke.move_hand(hand);

    CHECK((felt - Vec3(0.0, 0.0, most_fall - 3.0)).norm() < 1e-12);
    CHECK((poke.state.position - tool).norm() == doctest::Approx(most_fall / 1000.0));
    // of what was felt in the tick before, however many substeps it has
    CHECK((poke.move_hand(hand) - felt).norm() < 1e-12);
  }
  poke.most_fall = 0.0;
  CHECK(poke.move_hand(hand) == Vec3::Zero());
}

TEST_CASE("jaws of a weak hand that have lost the surface find it again without a blow") {
  // they go to the hand first, millimetres behind the surface, and come back in the same call
  for (const double force : {0.005, 0.05, 0.5}) {
    for (const double deep : {0.5e-3, 1e-3, 3e-3}) {
      CAPTURE(force);
      CAPTURE(deep);
      Poke poke(force);
      const double above = 0.025 + scenes::kJawRadius + 2e-5;
      poke.state.position = Vec3(0.0, 0.0, above);
      poke.move_hand({0, 0, above});
      REQUIRE(!poke.state.touching);

      const Vec3 felt = poke.move_hand({0, 0, above - deep});

      CHECK(felt.norm() <= force * (1.0 + 1e-12));
      // what is left of it goes on in the next substep; it was 20 to 30 times the weakest hand's
      CHECK(poke.push().norm() < 1.3 * force);
      CHECK(poke.state.residual.norm() < 0.3 * force);
    }
  }
}

// On a stone that is fixed, gripped by a hand far off, nothing moved and 0/0 was felt.
TEST_CASE("jaws that let go of what stands still, under a hand at its limit, stay where they are") {
  for (const double felt_change : {0.0, 1e-3, 1.0}) {
    CAPTURE(felt_change);
    Poke poke(0.5);
    const Vec3 hand(0.0, 0.0, 0.02);
    poke.state.position = Vec3(0.0, 0.0, 0.025 + scenes::kJawRadius + 2e-5);
    Vec3 felt = Vec3::Zero();
    for (int i = 0; i < 200; ++i) felt = poke.move_hand(hand);
    const Vec3 at = poke.state.position;
    REQUIRE((poke.move_hand(hand), poke.state.position == at));
    REQUIRE(felt.norm() == doctest::Approx(0.5));

    poke.state.felt_before = felt;
    poke.state.felt_change = felt_change;
    const Vec3 after = poke.move_hand(hand);

    CHECK(poke.state.position == at);
    CHECK(after == felt);
  }
}

TEST_CASE("jaws of a hand whose spring is at its limit within microns are not thrown past it") {
  for (const double way : {1e-5, 5e-5}) {
    CAPTURE(way);
    Poke poke(5.0);
    poke.coupling.stiffness = 1e6;  // 5 N at 5 um
    poke.state.position = Vec3(0.0, 0.0, 0.025 + scenes::kJawRadius + 2e-5);
    const Vec3 hand = poke.state.position - Vec3(0.0, 0.0, 3e-4), up(0.0, 0.0, way);
    const Vec3 deep = poke.move_hand_for(hand, 300);
    REQUIRE(deep.norm() < 2.5);

    const Vec3 at_once = poke.move_hand(hand + up);

    CHECK((at_once - poke.move_hand_for(hand + up, 300)).norm() < 0.05 * deep.norm());
  }
}
