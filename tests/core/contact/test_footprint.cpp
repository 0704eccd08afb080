// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "palpate/sim/contact/private/footprint.h"
#include "scenes/scenes.h"

using namespace palpate;

namespace {

constexpr double kModulus = 6270.0;  ///< [Pa] E 5 kPa, nu 0.45
constexpr double kHard = 3e7;        ///< [N/m³]

NearPressure make_law(double radius) { return {kModulus, radius, kHard}; }

/// [N] Hertz's force, with what deep presses of a neo-Hookean half space take off.
double compute_half_space(double radius, double depth) {
  const double x = depth / radius;
  return 4.0 / 3.0 * kModulus * std::sqrt(radius * depth) * depth *
         (1.0 - 0.1327 * x - 0.0104 * x * x);
}

/// A flat square of `side` [m] at z = 0, of right triangles whose legs are `edge` [m] long, turned
/// by an angle that no direction of the tests has.
SurfaceMesh make_plane(double side, double edge) {
  SurfaceMesh mesh;
  const int n = static_cast<int>(std::ceil(side / edge));
  const Eigen::AngleAxisd turn(0.4, Vec3::UnitZ());
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      mesh.vertices.push_back(turn * Vec3((i - 0.43 * n) * edge, (j - 0.57 * n) * edge, 0.0));
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int k = i + j * (n + 1);
      mesh.triangles.push_back({k, k + 1, k + n + 2});
      mesh.triangles.push_back({k, k + n + 2, k + n + 1});
    }
  }
  return mesh;
}

struct Total {
  Vec3 force = Vec3::Zero();   ///< [N] on the ball
  Vec3 moment = Vec3::Zero();  ///< [N m] of the normal forces about the origin, on the surface
  double stiffness = 0.0;      ///< [N/m]
};

Total press(const SurfaceMesh& mesh, double radius, const Vec3& centre) {
  Total total;
  Footprint part;
  for (const Triangle& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) -> const Vec3& {
      return mesh.vertices[static_cast<std::size_t>(t[k])];
    };
    if (!integrate_footprint(make_law(radius), centre, corner(0), corner(1), corner(2), part)) {
      continue;
    }
    total.force += part.force;
    total.stiffness += part.stiffness;
    Vec3 at = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) at += part.weights[Eigen::Index(k)] * corner(k);
    total.moment += at.cross(Vec3(0.0, 0.0, -part.normal_force));
  }
  return total;
}

}  // namespace

TEST_CASE("on a rigid plane the footprint gives the half space's force whatever its triangles") {
  for (const double radius : {0.002, 0.003, 0.005, 0.008}) {
    for (const double edge : {0.001, 0.0025, 0.005, 0.010, 0.020}) {
      const SurfaceMesh mesh = make_plane(0.06, edge);
      for (const double part : {0.05, 0.2, 0.5, 0.9}) {
        CAPTURE(radius);
        CAPTURE(edge);
        CAPTURE(part);
        const double depth = part * radius;
        const Total total = press(mesh, radius, {0.0011, 0.0007, radius - depth});
        CHECK(total.force.z() == doctest::Approx(compute_half_space(radius, depth)).epsilon(0.03));
      }
    }
  }
}

TEST_CASE("sliding over a rigid plane the force neither ripples nor pulls aside") {
  const double radius = 0.003, depth = 0.001;
  for (const double edge : {0.001, 0.0025, 0.005, 0.020}) {
    const SurfaceMesh mesh = make_plane(0.06, edge);
    double least = 1e9, most = 0.0, aside = 0.0;
    for (int i = 0; i <= 400; ++i) {
      const double s = 0.010 * i / 400.0;
      const Total total = press(mesh, radius, {s, 0.3 * s, radius - depth});
      least = std::min(least, total.force.z());
      most = std::max(most, total.force.z());
      aside = std::max(aside, total.force.head<2>().norm() / total.force.z());
    }
    CAPTURE(edge);
    CHECK(most - least < 0.01 * most);
    CHECK(aside < 0.01);
  }
}

TEST_CASE("the force of a footprint on the ball is minus the gradient of a stored energy") {
  // a triangle that the circle cuts on all sides, and one that holds it whole
  for (const double size : {0.0022, 0.02}) {
    const Vec3 a(-size, -0.6 * size, 0.0), b(0.9 * size, -0.5 * size, 0.0), c(0.1, 0.9, 0.0);
    const Vec3 top(0.1 * size, 0.9 * size, 0.0);
    const double radius = 0.003, step = 1e-7;
    const auto force_at = [&](const Vec3& at) {
      Footprint part;
      REQUIRE(integrate_footprint(make_law(radius), at, a, b, top, part));
      return part;
    };
    const Vec3 at(0.0004, -0.0003, 0.0021);
    // of a gradient the derivatives are symmetric
    Mat3 derivative;
    for (int k = 0; k < 3; ++k) {
      const Vec3 by = step * Vec3::Unit(k);
      derivative.col(k) = (force_at(at + by).force - force_at(at - by).force) / (2.0 * step);
    }
    CAPTURE(size);
    CAPTURE(derivative);
    CHECK((derivative - derivative.transpose()).norm() < 0.02 * derivative.norm());
    CHECK(-derivative(2, 2) == doctest::Approx(force_at(at).stiffness).epsilon(0.03));
  }
}

TEST_CASE("the centre of pressure of a whole circle is its centre") {
  const double radius = 0.003, depth = 0.0008;
  const Vec3 centre(0.0013, 0.0021, radius - depth);
  for (const double edge : {0.0015, 0.004, 0.020}) {
    const Total total = press(make_plane(0.06, edge), radius, centre);
    const Vec3 moment = centre.cross(Vec3(0.0, 0.0, -total.force.z()));
    CAPTURE(edge);
    CHECK((total.moment - moment).head<2>().norm() < 0.01 * radius * total.force.z());
  }
}

TEST_CASE("a footprint is felt neither from behind nor beyond the ball nor on no area") {
  const Vec3 a(-0.01, -0.01, 0.0), b(0.01, -0.01, 0.0), c(0.0, 0.01, 0.0);
  const NearPressure law = make_law(0.003);
  Footprint part;
  CHECK(integrate_footprint(law, {0.0, 0.0, 0.002}, a, b, c, part));
  CHECK_FALSE(integrate_footprint(law, {0.0, 0.0, -0.002}, a, b, c, part));
  CHECK_FALSE(integrate_footprint(law, {0.0, 0.0, 0.0031}, a, b, c, part));
  CHECK_FALSE(integrate_footprint(law, {0.05, 0.0, 0.002}, a, b, c, part));
  CHECK_FALSE(integrate_footprint(law, {0.0, 0.0, 0.002}, a, b, b, part));
}

TEST_CASE("a ball that just touches over a corner has finite weights") {
  // by rounding the circle is next to nothing, and the corner is its very centre
  const Vec3 corner(0.0, 0.0, 0.05), at(0.0, 0.0, 0.055);
  const auto beside = [&](int k) {
    const std::array<double, 8> side = {1.0, 1.0, 0.0, -1.0, -1.0, -1.0, 0.0, 1.0};
    return Vec3(corner + 0.01 * Vec3(side[k % 8], side[(k + 6) % 8], 0.0));
  };
  for (int k = 0; k < 8; ++k) {
    for (const int step : {1, 2}) {
      for (int turn = 0; turn < 3; ++turn) {
        std::array<Vec3, 3> x = {corner, beside(k), beside(k + step)};
        std::rotate(x.begin(), x.begin() + turn, x.end());
        Footprint part;
        if (!integrate_footprint(make_law(0.005), at, x[0], x[1], x[2], part)) continue;
        CHECK(part.weights.allFinite());
        CHECK(part.force.allFinite());
      }
    }
  }
}

TEST_CASE("the near pressure is nowhere steeper than the hard law") {
  const NearPressure law = make_law(0.003);
  double last = 0.0;
  for (int i = 1; i <= 6000; ++i) {
    const double o = 1e-6 * i;
    CHECK(law.pressure(o) > last);
    CHECK(law.pressure(o) <= kHard * o);
    CHECK(law.slope(o) <= kHard);
    last = law.pressure(o);
  }
  CHECK(law.pressure(0.0) == 0.0);
  CHECK(law.pressure(-1.0) == 0.0);
}
