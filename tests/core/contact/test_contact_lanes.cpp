// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <random>

#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/find_candidates.h"
#include "palpate/sim/packed/simd_targets.h"
#include "skip.h"

using namespace palpate;

namespace {

constexpr Tool kTool = {.radius = 0.003, .stiffness = 3e7};
constexpr double kArea = 2e-6;  // [m²]
constexpr int kCount = 1003;    // no multiple of any width

using Corners = std::array<Vec3, 3>;

/// Triangles around the origin, some of them slivers, some points, some through the centre.
std::vector<Corners> scatter_triangles() {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> spread(-0.004, 0.004);
  const auto point = [&] { return Vec3(spread(random), spread(random), spread(random)); };
  std::vector<Corners> triangles;
  for (int t = 0; t < kCount; ++t) {
    const Vec3 a = point();
    if (t % 50 == 1) {
      triangles.push_back({a, a, a});
    } else if (t % 50 == 2) {
      triangles.push_back({a, a, point()});
    } else if (t % 50 == 3) {
      triangles.push_back({a, -a, Vec3(1e-9 * point())});
    } else {
      triangles.push_back({a, a + 0.4 * point(), a + 0.4 * point()});
    }
  }
  return triangles;
}

ContactLanes fill(const std::vector<Corners>& triangles, const std::string& target) {
  ContactLanes lanes(kCount, target);
  lanes.count = kCount;
  for (std::size_t lane = 0; lane < lanes.rest_area.size(); ++lane) {
    const Corners& corners = triangles[std::min<std::size_t>(lane, kCount - 1)];
    for (std::size_t k = 0; k < 9; ++k) {
      lanes.corners[k][lane] = corners[k / 3][static_cast<Eigen::Index>(k % 3)];
    }
    lanes.rest_area[lane] = kArea;
  }
  return lanes;
}

}  // namespace

TEST_CASE("contacts in lanes are those of the law, one by one, on every vector target") {
  SKIP_UNLESS(!simd_targets().empty(), "this build has no vector code");
  const std::vector<Corners> triangles = scatter_triangles();
  for (const std::string& target : simd_targets()) {
    CAPTURE(target);
    ContactLanes lanes = fill(triangles, target);

    lanes.find(lanes, kTool.radius, kTool.stiffness);

    int contacts = 0;
    for (std::size_t t = 0; t < kCount; ++t) {
      CAPTURE(t);
      const auto& [a, b, c] = triangles[t];
      Contact expected;
      if (!find_contact(kTool, kArea, lanes.centre, a, b, c, expected)) expected.force = 0.0;
      // what is seen all but edge-on may be seen from either side, and pushes with next to nothing
      const double tolerance = 1e-9 * (kTool.stiffness * kArea * kTool.radius + expected.force);
      CHECK(std::abs(lanes.force[t] - expected.force) <= tolerance);
      if (!(expected.force > 1e-6)) continue;
      ++contacts;
      CHECK(lanes.stiffness[t] == doctest::Approx(expected.stiffness).epsilon(1e-9));
      CHECK(lanes.distance[t] == doctest::Approx(expected.distance).epsilon(1e-9));
      for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        // a short arm is rounding
        const double noise = 1e-9 + 1e-16 / expected.distance;
        CHECK(std::abs(lanes.direction[k][t] - expected.direction[axis]) < noise);
        CHECK(std::abs(lanes.weights[k][t] - expected.weights[axis]) < 1e-6);
      }
    }
    CHECK(contacts > 150);
  }
}
