// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/private/hold.h"
#include "scenes/scenes.h"

using namespace palpate;

namespace {

struct Pressed {
  SurfaceMesh mesh = scenes::make_sheet(6, 6, 0.010);
  Tool tool{.radius = 0.003, .stiffness = 3e7};
  Candidates candidates{50};
  ToolState state{50};
  std::vector<double> mass, scratch;

  Pressed() {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      mass.push_back(1e-5 * (1.0 + 0.5 * scenes::scatter(static_cast<std::uint32_t>(i))));
    }
    scratch.assign(mass.size(), std::numeric_limits<double>::quiet_NaN());
    candidates.count = static_cast<int>(mesh.triangles.size());
    for (int t = 0; t < candidates.count; ++t) {
      candidates.triangles[static_cast<std::size_t>(t)] = t;
      candidates.areas[static_cast<std::size_t>(t)] = 2e-6;
    }
    state.placed = true;
    state.position = {0.0052, 0.0047, 0.0018};
  }
  const Vec3& corner(int t, std::size_t c) const {
    const Triangle& k = mesh.triangles[static_cast<std::size_t>(t)];
    return mesh.vertices[static_cast<std::size_t>(k[c])];
  }
  double bound() {
    return bound_contact_stiffness(tool, candidates, mesh.triangles, mesh.vertices, mass, state,
                                   scratch);
  }
  /// The bound of as many tools as there are places, together.
  double bound(std::span<const Vec3> places) {
    std::ranges::fill(scratch, 0.0);
    ContactRows rows{mass, scratch};
    for (const Vec3& place : places) {
      state.position = place;
      const TouchableSurface surface{candidates, mesh.triangles, mesh.vertices, nullptr, 0};
      add_shape_rows({tool, {}}, true, surface, state, 0.0, rows);
    }
    return rows.largest;
  }
  double exact() const { return exact({&state.position, 1}); }
  /// The largest eigenvalue of M⁻¹K with tools at these places standing still.
  double exact(std::span<const Vec3> places) const {
    const auto n = static_cast<Eigen::Index>(3 * mass.size());
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
    const auto add = [&](int t, const Vec3& w, const Mat3& block) {
      const Triangle& corners = mesh.triangles[static_cast<std::size_t>(t)];
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          k.block<3, 3>(3 * corners[static_cast<std::size_t>(i)],
                        3 * corners[static_cast<std::size_t>(j)]) += w[i] * w[j] * block;
        }
      }
    };
    for (const Vec3& place : places) {
      for (int t = 0; t < candidates.count; ++t) {
        Contact contact;
        if (find_contact(tool, 2e-6, place, corner(t, 0), corner(t, 1), corner(t, 2), contact)) {
          add(t, contact.weights,
              contact.stiffness * contact.direction * contact.direction.transpose());
        }
      }
    }
    for (int h = 0; h < state.hold_count; ++h) {
      const ToolState::Hold& hold = state.holds[static_cast<std::size_t>(h)];
      add(hold.triangle, hold.weights, hold.stiffness * Mat3::Identity());
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        k(i, j) /= std::sqrt(mass[static_cast<std::size_t>(i / 3)] *
                             mass[static_cast<std::size_t>(j / 3)]);
      }
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues().maxCoeff();
  }
};

}  // namespace

TEST_CASE("a push on one corner adds its stiffness over the corner's mass") {
  Pressed p;
  p.candidates.count = 0;
  p.state.hold_count = 1;
  p.state.holds[0] = {0, {0.0, 1.0, 0.0}, 200.0, Vec3::Zero()};
  const auto i = static_cast<std::size_t>(p.mesh.triangles[0][1]);

  CHECK(p.bound() == doctest::Approx(200.0 / p.mass[i]));
}

TEST_CASE("the bound on contact stiffness lies above the exact eigenvalue and not far above") {
  Pressed p;
  for (const double height : {0.0028, 0.002, 0.001, 0.0003}) {
    p.state.position.z() = height;
    CHECK(p.exact() > 0.0);
    CHECK(p.bound() >= p.exact());
    CHECK(p.bound() <= 4.0 * p.exact());
  }

  p.state.hold_count = 3;
  for (int h = 0; h < 3; ++h) {
    p.state.holds[static_cast<std::size_t>(h)] = {20 + h, {0.2, 0.3, 0.5}, 150.0, Vec3::Zero()};
  }
  CHECK(p.bound() >= p.exact());
}

TEST_CASE("tools that share no vertex ask for the larger of their bounds, others for a sum") {
  Pressed p;
  p.tool.radius = 0.002;
  const std::array<Vec3, 2> apart = {Vec3(0.0008, 0.0008, 0.0015), Vec3(0.0092, 0.0092, 0.0010)};
  const double first = p.bound({&apart[0], 1}), second = p.bound({&apart[1], 1});
  REQUIRE(first > 0.0);
  REQUIRE(second > first);
  CHECK(p.bound(apart) == second);
  CHECK(p.bound(apart) >= p.exact(apart));

  // side by side, and from either side of the same place
  const std::array<Vec3, 2> beside = {Vec3(0.0042, 0.0047, 0.0010), Vec3(0.0062, 0.0047, 0.0010)};
  CHECK(p.bound(beside) > std::max(p.bound({&beside[0], 1}), p.bound({&beside[1], 1})));
  CHECK(p.bound(beside) <= p.bound({&beside[0], 1}) + p.bound({&beside[1], 1}));
  CHECK(p.bound(beside) >= p.exact(beside));
  const std::array<Vec3, 2> same = {beside[0], beside[0]};
  CHECK(p.bound(same) == doctest::Approx(2.0 * p.bound({&beside[0], 1})));
  CHECK(p.bound(same) >= p.exact(same));
}

TEST_CASE("what touches nothing adds no stiffness") {
  Pressed p;
  p.state.position.z() = 0.004;

  CHECK(p.bound() == 0.0);
}
