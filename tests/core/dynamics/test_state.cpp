// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/model/load.h"
#include "scenes/tissues.h"

using namespace palpate;

TEST_CASE("a state begins at rest at time zero with all its work space") {
  const TissueModel model = scenes::make_spring_organ(1);

  const State state(model);

  CHECK(state.time == 0.0);
  CHECK(state.position == model.rest_position);
  CHECK(scenes::max_norm(state.velocity) == 0.0);
  CHECK(state.force.size() == model.mass.size());
  for (const Vec3Array* space : {&state.scratch.position, &state.scratch.velocity,
                                 &state.scratch.slope_position, &state.scratch.slope_velocity}) {
    CHECK(space->size() == model.mass.size());
  }
}

TEST_CASE("a load takes pushes up to its capacity and then says no") {
  Load load(2);

  CHECK(load.add({0, {1, 0, 0}, {0, 0, 1}}));
  CHECK(load.add({1, {1, 0, 0}, {0, 0, 2}}));
  CHECK_FALSE(load.add({2, {1, 0, 0}, {0, 0, 3}}));
  CHECK(load.pushes().size() == 2);
  CHECK(load.pushes()[1].force.z() == 2.0);

  load.clear();

  CHECK(load.pushes().empty());
}
