// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cstddef>

#include "palpate/sim/grasp/private/jaws.h"
#include "palpate/sim/tree/queries.h"
#include "scenes/grasped.h"

// Jaws whose force may change by little in a tick do not end behind what they press
// [contact: jaws].

using namespace palpate;

namespace {

/// Jaws on a fold that gives nowhere, 40 mm wide and 1.6 mm thick, each of which may touch all of
/// it.
struct OnFold {
  OnFold() : first(static_cast<int>(mesh.triangles.size())), load(8 * first.triangles.size()) {
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

  void move_hand(const Vec3& hand, int substeps, double most_fall = 0.0) {
    for (int i = 0; i < substeps; ++i) {
      first.to = second.to = hand;
      first.from = second.from = state.position;
      const TouchedSurface one{&first, mesh.triangles, mesh.vertices, &load};
      TouchedSurface other = one;
      other.candidates = &second;
      felt = balance_jaws(tool, coupling, hand, {{{&one, 1}, {&other, 1}}}, 5e-5, state, most_fall);
      CHECK_FALSE(is_through());
    }
  }

  /// Whether a jaw's axis is in the fold, or has been drawn through it to the other side.
  bool is_through() const {
    const OpenJaws jaws(tool, state.orientation, state.jaw_angle);
    for (int j = 0; j < 2; ++j) {
      const Capsule& axis = jaws.axis_of(j);
      for (int k = 0; k <= 10; ++k) {
        const Vec3 p = state.position + axis.from + 0.1 * k * (axis.to - axis.from);
        if (p.z() < 0.0 && p.head<2>().norm() < 0.019) return true;
        if (compute_winding_number(mesh.triangles, mesh.vertices, p) > 0.5) return true;
      }
    }
    return false;
  }

  SurfaceMesh mesh = scenes::make_ellipsoid({0.02, 0.02, 0.0008}, 3);
  Tool tool = scenes::make_grasper(0.5, 5.0);
  Coupling coupling{.stiffness = 1000.0, .force_max = 5.0};
  Candidates first, second;
  Load load;
  ToolState state{0, 0, 4096};
  Vec3 felt = Vec3::Zero();
};

/// Closed jaws that lie along the fold, one above the other, pressed on it by 4 mm.
void press(OnFold& fold) {
  Mat3 turn;
  turn.col(2) = Vec3::UnitX();
  turn.col(1) = Vec3::UnitZ();
  turn.col(0) = turn.col(1).cross(turn.col(2));
  fold.state.orientation = Quaternion(turn);
  const double above = 0.0008 + 2.0 * scenes::kJawRadius + 2e-5;
  fold.state.position = Vec3(-0.01, 0.0, above);
  fold.move_hand({-0.01, 0.0, above - 0.004}, 200);
  REQUIRE(fold.felt.norm() > 3.0);
  REQUIRE(fold.felt.norm() < 4.5);
}

}  // namespace

// Held back, the tool stood where it was, and the lower jaw turned on into the fold.
TEST_CASE("jaws that open under a hand that may feel no more do not turn into what they press") {
  OnFold fold;
  press(fold);
  const Vec3 before = fold.felt;
  fold.state.felt_before = before;
  fold.state.felt_change = 0.01;
  fold.state.jaw_wanted = fold.tool.jaws->open;
  fold.move_hand({-0.01, 0.0, 0.0008 + 2.0 * scenes::kJawRadius + 2e-5 - 0.004}, 200);
  CHECK((fold.felt - before).norm() <= 0.01 * (1.0 + 1e-9));
}

TEST_CASE("nor do jaws that a hand draws off faster than what it feels may fall") {
  OnFold fold;
  press(fold);
  fold.state.felt_before = fold.felt;
  fold.state.jaw_wanted = fold.tool.jaws->open;
  const double above = 0.0008 + 2.0 * scenes::kJawRadius + 2e-5;
  for (int i = 1; i <= 20; ++i) {
    fold.move_hand({-0.01, 0.0, above - 0.004 + 0.0005 * i}, 20, 0.1);
    fold.state.felt_before = fold.felt;
  }
}
