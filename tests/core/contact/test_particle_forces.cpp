// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/contact/private/particle_forces.h"
#include "scenes/linear_solids.h"

using namespace palpate;

namespace {

/// A force [N] on all coordinates of the free.
Eigen::VectorXd spread(const ParticleForces& forces, std::size_t f, Eigen::Index size) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(size);
  for (int k = forces.first[f]; k < forces.first[f + 1]; ++k) {
    const auto at = static_cast<std::size_t>(k);
    all.segment<3>(3 * Eigen::Index{forces.particle[at]}) += forces.part[at];
  }
  return all;
}

}  // namespace

TEST_CASE("the compliance between forces is that of one solution for each of them") {
  const TissueModel model = scenes::make_linear_organ(3, 0.9);
  const FreeStiffness stiffness(model);
  Factors factors;
  REQUIRE(factor(stiffness, factors));

  // one particle alone, many of them, one twice, none at all
  ParticleForces forces;
  forces.particle = {4};
  forces.part = {Vec3(1.0, -2.0, 0.5)};
  forces.end();
  for (int p = 0; p < stiffness.count; p += 2) {
    forces.particle.push_back(p);
    forces.part.push_back(Vec3(0.1 * p, 1.0, -0.3));
  }
  forces.end();
  forces.particle.insert(forces.particle.end(), {1, 1});
  forces.part.insert(forces.part.end(), {Vec3(0.0, 0.0, 1.0), Vec3(2.0, 0.0, 0.0)});
  forces.end();
  forces.end();
  const ForcePairs pairs{{0, 4, 6, 7, 8}, {0, 1, 2, 3, 1, 2, 2, 0}};

  const std::vector<double> found = solve_compliances(stiffness, factors, forces, pairs);

  const Eigen::Index size = stiffness.matrix.rows();
  REQUIRE(found.size() == pairs.other.size());
  for (std::size_t f = 0; f < forces.count(); ++f) {
    const Eigen::VectorXd u = factors.solve(spread(forces, f, size));
    for (int k = pairs.first[f]; k < pairs.first[f + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const auto g = static_cast<std::size_t>(pairs.other[at]);
      CHECK(found[at] == doctest::Approx(u.dot(spread(forces, g, size))).epsilon(1e-9));
    }
  }
  CHECK(found[0] > 0.0);
  CHECK(found[3] == 0.0);
}
