// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <span>
#include <utility>
#include <vector>

#include "palpate/sim/model/private/mean_load.h"
#include "scenes/scenes.h"

using namespace palpate;

TEST_CASE("the mean of pushes keeps their force and moment, on one push a vertex") {
  const SurfaceMesh mesh = scenes::make_ellipsoid(Vec3::Constant(0.02), 1);
  MeanLoad mean(mesh.triangles, mesh.vertices.size());
  const std::vector<Push> pushes = {{3, {0.2, 0.3, 0.5}, {0.1, -0.2, 0.3}},
                                    {3, {0.6, 0.3, 0.1}, {-0.3, 0.1, 0.2}},
                                    {17, {1.0, 0.0, 0.0}, {0.0, 0.5, 0.0}}};
  mean.add(std::span(pushes).first(1));
  mean.add(std::span(pushes).last(2));
  Load load(static_cast<int>(mesh.vertices.size()));
  mean.take(4, load);

  const auto sum_up = [&](std::span<const Push> all) {
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (const Push& push : all) {
      const Triangle& t = mesh.triangles[static_cast<std::size_t>(push.triangle)];
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec3 share = push.weights[static_cast<Eigen::Index>(c)] * push.force;
        force += share;
        moment += mesh.vertices[static_cast<std::size_t>(t[c])].cross(share);
      }
    }
    return std::pair(force, moment);
  };
  const auto [force, moment] = sum_up(pushes);
  const auto [mean_force, mean_moment] = sum_up(load.pushes());
  CHECK((4.0 * mean_force - force).norm() < 1e-15);
  CHECK((4.0 * mean_moment - moment).norm() < 1e-16);
  CHECK(load.push_count <= 6);

  mean.take(4, load);
  CHECK(load.push_count == 0);
}
