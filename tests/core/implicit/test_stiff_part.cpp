// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/implicit/private/stiff_part.h"
#include "scenes/tissues.h"

// Implicit Euler on the few particles that an explicit step is too long for [motion: ladder].

using namespace palpate;

namespace {

/// A tissue of springs, one of which is so many times as stiff as the others.
TissueModel make_uneven(double times, int subdivisions = 2) {
  TissueModel model = scenes::make_spring_organ(subdivisions, {.damping_ratio = 0.1, .drag = 5.0});
  std::vector<char> fixed(model.mass.size(), 0);
  for (const int i : model.fixed) fixed[static_cast<std::size_t>(i)] = 1;
  for (std::size_t s = model.springs.ends.size(); s-- > 0;) {
    const auto& [i, j] = model.springs.ends[s];
    if (fixed[static_cast<std::size_t>(i)] || fixed[static_cast<std::size_t>(j)]) continue;
    model.springs.stiffness[s] *= times;
    break;
  }
  return model;
}

double find_fastest(const State& state) {
  double fastest = 0.0;
  for (const Vec3& v : state.velocity) {
    if (!v.allFinite()) return std::numeric_limits<double>::infinity();
    fastest = std::max(fastest, v.norm());
  }
  return fastest;
}

State make_shaken(const TissueModel& model) {
  State state(model);
  scenes::shake(model, 1e-4, 0.02, state);
  return state;
}

}  // namespace

TEST_CASE("where steps are short enough nothing is implicit, and a step is symplectic Euler's") {
  const TissueModel model = make_uneven(1.0);
  const double dt = 0.9 * stable_step(model);
  State state = make_shaken(model), plain = state;
  StiffPart part(model, state.position, dt, {});

  REQUIRE(part.holds());
  CHECK(part.particles().empty());
  for (int i = 0; i < 20; ++i) {
    REQUIRE(part.step(model, Load(), state));
    step(model, Load(), dt, plain);
  }
  CHECK(state.position == plain.position);
  CHECK(state.velocity == plain.velocity);
  CHECK(state.time == plain.time);
}

TEST_CASE("one link that is too stiff takes a few particles, and the rest of the tissue none") {
  const TissueModel even = make_uneven(1.0), model = make_uneven(1000.0);
  const double dt = 0.9 * stable_step(even);
  REQUIRE(stable_step(model) < 0.1 * dt);
  State state = make_shaken(model), alone = state;
  StiffPart part(model, state.position, dt, {});

  REQUIRE(part.holds());
  CHECK(part.particles().size() >= 2);
  CHECK(part.particles().size() <= 16);
  for (int i = 0; i < 20'000; ++i) REQUIRE(part.step(model, Load(), state));
  CHECK(find_fastest(state) < 0.02);
  for (int i = 0; i < 200; ++i) step(model, Load(), dt, alone);
  CHECK(find_fastest(alone) > 10.0);
}

TEST_CASE("under a weight it comes to rest where short explicit steps do") {
  const TissueModel model = make_uneven(300.0);
  Load load(1);
  load.gravity = {0.0, 0.02, -0.0981};
  const double dt = 0.9 * stable_step(make_uneven(1.0));
  State state(model), fine(model);
  StiffPart part(model, state.position, dt, {});
  const double fine_dt = 0.9 * stable_step(model);

  for (double time = 0.0; time < 4.0; time += dt) REQUIRE(part.step(model, load, state));
  for (double time = 0.0; time < 4.0; time += fine_dt) step(model, load, fine_dt, fine);

  double sag = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    sag = std::max(sag, (fine.position[i] - model.rest_position[i]).norm());
    apart = std::max(apart, (fine.position[i] - state.position[i]).norm());
  }
  CHECK(sag > 1e-5);
  CHECK(apart < 0.01 * sag);
}

TEST_CASE("a tissue that needs all of its particles is stepped as implicit Euler steps it") {
  const TissueModel model = make_uneven(1.0);
  REQUIRE(model.mass.size() <= StiffPart::kMost);
  const double dt = 30.0 * stable_step(model);
  State state = make_shaken(model), whole = state;
  StiffPart part(model, state.position, dt, {});
  ImplicitStepper stepper(model, Integrator::implicit_euler_linear);

  REQUIRE(part.holds());
  CHECK(part.particles().size() == model.mass.size() - model.fixed.size());
  for (int i = 0; i < 5; ++i) {
    REQUIRE(part.step(model, Load(), state));
    REQUIRE(stepper.step(Load(), dt, whole) > 0);
  }
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    CHECK((state.position[i] - whole.position[i]).norm() < 1e-9);
  }
}

TEST_CASE("a tissue that needs more particles than there may be has no such part") {
  const TissueModel model = make_uneven(1.0, 3);
  REQUIRE(model.mass.size() > StiffPart::kMost);

  CHECK_FALSE(StiffPart(model, model.rest_position, 10.0 * stable_step(model), {}).holds());
}

TEST_CASE("a particle that a contact is too stiff for is among them") {
  const TissueModel model = make_uneven(1.0);
  const double dt = 0.9 * stable_step(model);
  std::vector<double> contact(model.mass.size(), 0.0);
  const auto free = [&](int i) { return std::ranges::find(model.fixed, i) == model.fixed.end(); };
  int touched = 0;
  while (!free(touched)) ++touched;
  contact[static_cast<std::size_t>(touched)] = 50.0 / (dt * dt);
  const StiffPart part(model, model.rest_position, dt, contact);

  REQUIRE(part.holds());
  CHECK(std::ranges::find(part.particles(), touched) != part.particles().end());
  CHECK(part.particles().size() <= 8);
}
