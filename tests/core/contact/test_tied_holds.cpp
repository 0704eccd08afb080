// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "palpate/sim/contact/private/local_press.h"
#include "palpate/sim/contact/private/touched_surface.h"
#include "rigid_surface.h"

// A tool that holds on to tissue with a near field [contact: hold], on a plane that gives nowhere:
// all that gives way is the near field's, and the hold's own spring.

using namespace palpate;

namespace {

constexpr double kModulus = RigidSurface::kModulus;  ///< [Pa]
constexpr double kHold = 500.0;                      ///< [N/m]
constexpr double kSideways = 0.71;
constexpr Tool kTool{.radius = 0.004};
constexpr Coupling kCoupling{.stiffness = 20000.0, .force_max = 5.0};
const Vec3 kPlace(0.0011, 0.0007, 0.0);

/// A plane of 60 mm, and a tool on a stiff hand.
struct Plane : RigidSurface {
  explicit Plane(double edge = 0.005, double mesh = 0.0) : RigidSurface(0.06, edge, 0.0, 0.0) {
    near.ties_holds = true;
    // a mesh that gives nowhere has done the opposite of what the body gives way elsewhere
    near.far_compliance.assign(x.size(), -mesh);
    candidates.count = static_cast<int>(triangles.size());
    for (int t = 0; t < candidates.count; ++t) {
      candidates.triangles[static_cast<std::size_t>(t)] = t;
      candidates.areas[static_cast<std::size_t>(t)] = 0.5 * edge * edge;
    }
  }

  TouchedSurface surface() { return {&candidates, triangles, x, &load, &near, {}}; }

  /// [N] On the tool, once it is where the hand is but for the hand's spring.
  Vec3 move_to(const Vec3& tool) {
    Vec3 hand = tool, felt = Vec3::Zero();
    for (int i = 0; i < 400; ++i) {
      candidates.near.knows_compliance = false;
      candidates.from = state.placed ? state.position : hand;
      candidates.to = hand;
      const TouchedSurface one = surface();
      felt = balance_tool(kTool, kCoupling, hand, {&one, 1}, state);
      hand += 0.5 * (tool - state.position);
    }
    return felt;
  }

  /// [N] The ball's lowest point `depth` [m] deep, and `aside` [m] along x.
  Vec3 press(double depth, double aside = 0.0) {
    return move_to(kPlace + Vec3(aside, 0.0, kTool.radius - depth));
  }

  bool take_hold() {
    const TouchedSurface one = surface();
    return attach_tool({&one, 1}, kHold, state);
  }

  Load load{2000};
  ToolState state{2000};
};

/// [N/m] Springs of kHold, shared out as the pressures are, on a disc of so many [N/m]: at 28 times
/// as many as the disc's they let it give way by 1.055 of what it would under a rigid one, of
/// solutions of the half space.
double series(double disc) { return 1.0 / (1.0 / kHold + 1.055 / disc); }

const LocalPress kHalf{kModulus, kTool.radius, 0.0, 0.0};

}  // namespace

TEST_CASE("a tied hold is the tangent of the press at the grip: a disc on a half space, by hand") {
  constexpr double kGrip = 0.0005;
  Plane plane;
  const Vec3 before = plane.press(kGrip);
  REQUIRE(plane.take_hold());
  const Vec3 after = plane.press(kGrip);

  // nothing changes when it takes hold
  CHECK((after - before).norm() < 1e-3 * before.norm());
  CHECK(before.z() == doctest::Approx(kHalf.compute_force(kGrip)).epsilon(0.02));

  // E* = 6270 Pa, a = sqrt(4 mm 0.5 mm) = 1.414 mm: 2 E* a = 17.7 N/m, in series with 500 N/m,
  // and 5.5 % softer
  const double disc = 2.0 * kModulus * std::sqrt(kTool.radius * kGrip);
  CHECK(disc == doctest::Approx(17.73).epsilon(1e-3));
  const double stiffness = series(disc);
  for (const double up : {0.0002, 0.0005, 0.001, 0.003}) {
    CAPTURE(up);
    const Vec3 felt = plane.press(kGrip - up);
    CHECK(felt.z() == doctest::Approx(before.z() - stiffness * up).epsilon(0.03));
    CHECK(felt.head<2>().norm() < 0.01 * std::abs(felt.z()));
  }
}

TEST_CASE("sideways a tied disc is softer, by 2 (1 - nu)/(2 - nu)") {
  constexpr double kGrip = 0.0005;
  Plane plane;
  plane.press(kGrip);
  REQUIRE(plane.take_hold());
  const double disc = kSideways * 2.0 * kModulus * std::sqrt(kTool.radius * kGrip);
  CHECK(kSideways == doctest::Approx(2.0 * 0.55 / 1.55).epsilon(1e-3));

  for (const double aside : {0.0005, 0.002}) {
    CHECK(-plane.press(kGrip, aside).x() == doctest::Approx(series(disc) * aside).epsilon(0.03));
  }
}

TEST_CASE("what is pressed deeper than where it took hold is felt as without a hold") {
  constexpr double kGrip = 0.0005;
  Plane held, free;
  held.press(kGrip);
  REQUIRE(held.take_hold());
  for (const double depth : {0.0006, 0.001, 0.002, 0.003}) {
    CAPTURE(depth);
    CHECK(held.press(depth).z() == doctest::Approx(free.press(depth).z()).epsilon(0.02));
  }
  // and there is no hysteresis in that
  const double again = held.press(kGrip).z();
  CHECK(again == doctest::Approx(kHalf.compute_force(kGrip)).epsilon(0.02));
}

TEST_CASE("a tied hold takes off what the mesh has done already, and adds what it has not") {
  constexpr double kGrip = 0.0005;
  const double disc = 2.0 * kModulus * std::sqrt(kTool.radius * kGrip);
  for (const double mesh : {-0.02, 0.01, 0.02}) {  // [m/N], beside 0.056 of the disc
    Plane plane(0.005, mesh);
    const double before = plane.press(kGrip).z();
    // the dent of the half space there
    const double s = std::pow(before / (4.0 / 3.0 * kModulus * std::sqrt(kTool.radius)), 2.0 / 3.0);
    const double own = 2.0 * kModulus * std::sqrt(kTool.radius * s);
    REQUIRE(plane.take_hold());

    const double pulled = before - plane.press(kGrip - 0.002).z();

    CAPTURE(mesh);
    CHECK(pulled / 0.002 ==
          doctest::Approx(1.0 / (1.0 / kHold + 1.055 / own - mesh)).epsilon(0.06));
    CHECK((pulled / 0.002 > series(disc)) == (mesh > 0.0));
  }
}

TEST_CASE("a tied hold does not depend on the triangles it is fastened to") {
  double first = 0.0;
  for (const double edge : {0.001, 0.002, 0.005, 0.010, 0.020}) {
    Plane plane(edge);
    plane.press(0.0005);
    REQUIRE(plane.take_hold());
    const double felt = plane.press(-0.002).z();
    if (first == 0.0) first = felt;
    CAPTURE(edge);
    CHECK(felt == doctest::Approx(first).epsilon(0.02));
  }
}

TEST_CASE("a tool that holds gives no energy on a closed path: down, aside, up and back") {
  Plane plane;
  plane.press(0.0005);
  REQUIRE(plane.take_hold());
  // corners of the path: depth, aside [m]
  const std::array<Vec3, 5> corners = {Vec3(0, 0, -0.0005), Vec3(0, 0, -0.002),
                                       Vec3(0.002, 0, -0.002), Vec3(0.002, 0, 0.002),
                                       Vec3(0, 0, -0.0005)};
  double net = 0.0, gross = 0.0;
  Vec3 last = plane.press(0.0005);
  constexpr int kSteps = 40;
  for (std::size_t c = 0; c + 1 < corners.size(); ++c) {
    for (int i = 1; i <= kSteps; ++i) {
      const Vec3 step = (corners[c + 1] - corners[c]) / kSteps;
      const Vec3 at = corners[c] + i * step;
      const Vec3 felt = plane.press(-at.z(), at.x());
      const double work = 0.5 * (felt + last).dot(step);
      net += work;
      gross += std::abs(work);
      last = felt;
    }
  }
  CHECK(net < 0.01 * gross);
  CHECK(net > -0.25 * gross);
}

TEST_CASE("what holds push and pull on the tissue is what the hand feels") {
  Plane plane;
  plane.press(0.0005);
  REQUIRE(plane.take_hold());
  for (const double depth : {0.002, 0.0005, -0.001}) {
    const Vec3 felt = plane.press(depth, 0.0004);
    Vec3 sum = Vec3::Zero();
    for (const Push& push : plane.load.pushes()) sum += push.force;
    CHECK((sum + felt + plane.state.residual).norm() < 1e-12);
  }
}

TEST_CASE("a hold's stretch is what makes its pull, tied or not") {
  ToolState::Hold hold{.stiffness = 30.0};
  const Vec3 force(0.01, -0.02, 0.005);
  CHECK((hold.pull(hold.stretch(force)) - force).norm() < 1e-15);
  hold.normal = Vec3(1.0, 2.0, 2.0) / 3.0;
  hold.sideways = 21.0;
  CHECK((hold.pull(hold.stretch(force)) - force).norm() < 1e-15);
  CHECK(hold.pull(hold.normal).dot(hold.normal) == doctest::Approx(30.0));
  CHECK(hold.pull(hold.normal.unitOrthogonal()).norm() == doctest::Approx(21.0));
}

TEST_CASE("without ties a hold is fastened to the triangles, as in files of before") {
  Plane plane;
  plane.near.ties_holds = false;
  plane.press(0.0005);
  REQUIRE(plane.take_hold());
  CHECK(plane.candidates.near.grip.force == 0.0);
  CHECK_FALSE(plane.state.holds[0].is_tied());
  CHECK(plane.press(-0.001).z() == doctest::Approx(-kHold * 0.0015).epsilon(1e-3));
}
