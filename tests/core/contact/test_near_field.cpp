// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <numbers>
#include <stdexcept>

#include "palpate/sim/contact/private/local_press.h"
#include "palpate/sim/contact/private/near_contact.h"
#include "palpate/sim/response/response.h"
#include "scenes/linear_solids.h"

using namespace palpate;

namespace {

constexpr double kModulus = 6270.0;  ///< [Pa]

}  // namespace

TEST_CASE("the half space is Hertz's at small depth, and its slope the derivative of its force") {
  const LocalPress half{kModulus, 0.003, 0.0, 0.0};
  const double s = 1e-6;
  CHECK(half.compute_force(s) ==
        doctest::Approx(4.0 / 3.0 * kModulus * std::sqrt(0.003) * std::pow(s, 1.5)).epsilon(1e-3));
  // 69 % of Hertz's at two radii
  const double deep = 4.0 / 3.0 * kModulus * std::sqrt(0.003) * std::pow(0.006, 1.5);
  CHECK(half.compute_force(0.006) == doctest::Approx(0.69 * deep).epsilon(0.01));
  for (const double at : {1e-5, 1e-3, 4e-3, 5.9e-3, 7e-3}) {
    const double step = 1e-9;
    const double slope = (half.compute_force(at + step) - half.compute_force(at - step)) / 2e-9;
    CAPTURE(at);
    CHECK(half.compute_slope(at) == doctest::Approx(slope).epsilon(1e-5));
  }
  // a dome gives way more: 1 / R is the sum of both
  const LocalPress dome{kModulus, 0.003, 1.0 / 0.006, 0.0};
  CHECK(dome.compute_force(s) / half.compute_force(s) ==
        doctest::Approx(std::sqrt(2.0 / 3.0)).epsilon(1e-9));
}

TEST_CASE("the depth of a local press solves its equation, whatever the mesh has taken") {
  const double radius = 0.003;
  for (const double compliance : {-0.05, -0.01, 0.0, 0.01, 0.03}) {
    const LocalPress press{kModulus, radius, 10.0, compliance};
    for (const double depth : {1e-7, 1e-4, 1e-3, 2e-3}) {
      const double area = std::numbers::pi * depth * (2.0 * radius - depth);
      const double s = press.find_depth(depth, area), y = depth / s;
      const double touched = std::sqrt((0.5 + 0.625 * (1.0 - y)) * area / std::numbers::pi);
      const LocalPress flat{kModulus, radius, 0.0, 0.0};
      const double whole = std::sqrt(0.5 * measure_cut(radius, s));
      CAPTURE(compliance);
      CAPTURE(depth);
      const double hertz = 4.0 / 3.0 * kModulus * s * whole;
      const double more = 1.0 + y * (flat.compute_force(s) / hertz - 1.0);
      CHECK(s - 4.0 / 3.0 * kModulus * touched * compliance * more * s ==
            doctest::Approx(depth).epsilon(1e-6));
    }
  }
}

TEST_CASE("a mesh as soft as tissue leaves a fifth of the dent, and the press is felt whole") {
  // the mean displacement under Hertz's pressure is 4/5 of the depth, F = 4/3 E* a d
  const double radius = 0.02, depth = 0.002, a = std::sqrt(radius * depth);
  const double compliance = 0.8 * 0.75 / (kModulus * a);
  const LocalPress press{kModulus, radius, 0.0, compliance};
  CHECK(press.find_depth(0.2 * depth, std::numbers::pi * a * a) ==
        doctest::Approx(depth).epsilon(0.02));
  // one that is softer still is too soft, and no contact makes up for that
  const LocalPress soft{kModulus, radius, 0.0, 3.0 * compliance};
  CHECK(soft.find_depth(depth, std::numbers::pi * a * a) == doctest::Approx(depth / 0.15));
}

TEST_CASE("where the barrier begins, the slope of a contact is the derivative of its force") {
  NearField near;
  near.modulus = kModulus;
  const Tool tool{.radius = 0.003, .stiffness = 3e7};
  const Vec3 a(-0.01, -0.01, 0.0), b(0.01, -0.01, 0.0), c(0.0, 0.01, 0.0);
  const auto touch = [&](double depth) {
    const Vec3 centre(0.0, -0.004, tool.radius - depth);
    Contact closest, contact;
    REQUIRE(find_contact(tool, 2e-4, centre, a, b, c, closest));
    REQUIRE(find_near_contact(near, {tool, {}}, closest, centre, 1.0, a, b, c, {}, contact));
    return contact;
  };
  for (const double x : {0.5, 0.7, 0.76, 0.8, 0.85, 0.89}) {
    CAPTURE(x);
    const double depth = x * tool.radius, h = 1e-7;
    const double slope = (touch(depth + h).force - touch(depth - h).force) / (2.0 * h);
    CHECK(touch(depth).stiffness == doctest::Approx(slope).epsilon(0.02));
  }
}

TEST_CASE("a near field has the compliance of the mesh along normals, as its response has it") {
  const TissueModel model = scenes::make_linear_organ(4, 0.9);
  const NearField near = build_near_field(model, kModulus, 0.003);
  const Response response = build_response(model);

  const Vec3Array normals = compute_vertex_normals(model.rest_position, model.triangles);
  int compared = 0;
  for (std::size_t v = 0; v < model.rest_position.size(); ++v) {
    for (int k = near.first[v]; k < near.first[v + 1]; ++k) {
      const int u = near.neighbour[static_cast<std::size_t>(k)];
      const double compliance = near.compliance[static_cast<std::size_t>(k)];
      const int row = response.row[static_cast<std::size_t>(u)], column = response.column[v];
      if (row < 0 || column < 0) {
        CHECK(compliance == 0.0);
        continue;
      }
      double expected = 0.0;
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          const auto at = static_cast<std::size_t>(3 * column + i) * 3u *
                              static_cast<std::size_t>(response.size.moved) +
                          static_cast<std::size_t>(3 * row + j);
          expected += normals[v][i] * static_cast<double>(response.compliance[at]) *
                      normals[static_cast<std::size_t>(u)][j];
        }
      }
      CHECK(compliance == doctest::Approx(expected).epsilon(1e-4).scale(1e-3));
      ++compared;
    }
  }
  CHECK(compared > 200);
}

TEST_CASE("the far compliance of a thick block is that of a layer") {
  const SolidMesh solid = scenes::make_block({0.1, 0.1, 0.05}, {10, 10, 5});
  SolidOptions options;
  for (std::size_t i = 0; i < solid.vertices.size(); ++i) {
    if (solid.vertices[i].z() < -0.0249) options.fixed.push_back(static_cast<int>(i));
  }
  Material material = scenes::make_material({});
  material.young_modulus = 5000.0;
  material.poisson_ratio = 0.45;
  const TissueModel model = build_linear_solid(solid, material, options);
  const NearField near = build_near_field(model, kModulus, 0.003);
  const double alpha = -(1.2876 - 1.4678 * 0.45 + 1.3442 * 0.45 * 0.45) / 0.55;
  const double layer = alpha / (std::numbers::pi * kModulus * 0.05);
  const double hertz = 1.0 / (2.0 * kModulus * std::sqrt(0.003 * 0.001));
  for (std::size_t v = 0; v < model.rest_position.size(); ++v) {
    const Vec3& x = model.rest_position[v];
    if (x.z() < 0.0249 || x.head<2>().norm() > 0.015) continue;
    // what is off of it, beside the compliance of a 3 mm ball 1 mm deep
    CHECK(std::abs(near.far_compliance[v] - layer) < 0.03 * hertz);
    CHECK(std::abs(near.curvature[v]) < 1e-9);
  }
}

TEST_CASE("a far compliance that is given is kept, and what neighbours do stays that of the mesh") {
  const TissueModel model = scenes::make_linear_organ(4, 0.9);
  const NearField own = build_near_field(model, kModulus, 0.003);
  std::vector<Symmetric> far(model.rest_position.size());
  for (std::size_t v = 0; v < far.size(); ++v) {
    const double x = 1e-3 * static_cast<double>(v) - 0.01;
    far[v] = {x, 2.0 * x, 3.0 * x, 0.1 * x, 0.2 * x, 0.3 * x};
  }

  const NearField near = build_near_field(model, kModulus, 0.003, far);

  CHECK(near.far_tensor == far);
  const Vec3Array normals = compute_vertex_normals(model.rest_position, model.triangles);
  for (const std::size_t v : {3u, 11u}) {
    Mat3 tensor;
    tensor << far[v][0], far[v][3], far[v][5], far[v][3], far[v][1], far[v][4], far[v][5],
        far[v][4], far[v][2];
    CHECK(near.far_compliance[v] == doctest::Approx(normals[v].dot(tensor * normals[v])));
  }
  CHECK(own.far_tensor.empty());
  CHECK(near.compliance == own.compliance);
  CHECK(near.neighbour == own.neighbour);
  CHECK(near.curvature == own.curvature);
  far.pop_back();
  CHECK_THROWS_WITH_AS(build_near_field(model, kModulus, 0.003, far),
                       doctest::Contains("near field: far: got"), std::invalid_argument);
}

TEST_CASE("the curvature of a ball's surface is that of the ball") {
  const TissueModel model = scenes::make_covered_linear_organ(4, 0.9);
  const NearField near = build_near_field(model, kModulus, 0.003);
  // 45 x 32 x 27 mm: mean curvatures between those of the longest and the shortest axis
  for (const double curvature : near.curvature) {
    CHECK(curvature > 0.5 * 0.027 / (0.045 * 0.045));
    CHECK(curvature < 2.0 * 0.045 / (0.027 * 0.027));
  }
}

TEST_CASE("a body that nothing holds has the near field of one that is held") {
  const TissueModel held = scenes::make_linear_organ(4, 0.9);
  TissueModel loose = held;
  loose.fixed.clear();
  const NearField its = build_near_field(loose, kModulus, 0.003);
  const NearField expected = build_near_field(held, kModulus, 0.003);
  // far from what was held; beside the compliance of a 3 mm ball 1 mm deep
  const double hertz = 1.0 / (2.0 * kModulus * std::sqrt(0.003 * 0.001));
  int compared = 0;
  for (std::size_t v = 0; v < held.rest_position.size(); ++v) {
    if (held.rest_position[v].z() < 0.015 || its.first[v] == its.first[v + 1]) continue;
    const auto find_own = [v](const NearField& near) {
      for (int k = near.first[v]; k < near.first[v + 1]; ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (near.neighbour[at] == static_cast<int>(v)) {
          return static_cast<double>(near.compliance[at]) - near.far_compliance[v];
        }
      }
      return std::nan("");
    };
    CHECK(std::abs(find_own(its) - find_own(expected)) < 0.2 * hertz);
    ++compared;
  }
  CHECK(compared > 5);
}

TEST_CASE("a near field is refused with numbers that are none") {
  const TissueModel held = scenes::make_linear_organ(3, 0.9);
  CHECK_THROWS_WITH_AS(build_near_field(held, 0.0, 0.003),
                       doctest::Contains("near field: modulus [Pa]: got 0"), std::invalid_argument);
  CHECK_THROWS_WITH_AS(build_near_field(held, kModulus, -1.0),
                       doctest::Contains("near field: radius [m]: got -1"), std::invalid_argument);
}
