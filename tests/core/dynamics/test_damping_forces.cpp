// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/law.h"
#include "palpate/sim/dynamics/state.h"
#include "scenes/hyperelastic_solids.h"
#include "scenes/linear_solids.h"
#include "scenes/shells.h"
#include "scenes/tissues.h"

using namespace palpate;
using doctest::Approx;

namespace {

struct Damped {
  const char* name;
  TissueModel model;
};

std::vector<Damped> make_damped() {
  std::vector<Damped> all;
  for (const DampingLaw law : {DampingLaw::axis, DampingLaw::isotropic}) {
    all.push_back({"links", scenes::make_molecular_organ(1, {.damping_ratio = 0.3, .law = law})});
  }
  all.push_back({"drag", scenes::make_spring_organ(1, {.drag = 40.0})});
  all.push_back({"prisms", scenes::make_damped_prism()});
  all.push_back({"linear solid", scenes::make_linear_organ(3, 0.9, 0.3)});
  for (const scenes::FiniteLaw& law : scenes::kFiniteLaws) {
    all.push_back({"solid", scenes::make_finite_organ(law, 3, 0.9, {.damping_ratio = 0.3})});
  }
  return all;
}

}  // namespace

TEST_CASE("what damps is all that velocities change of the forces, law by law") {
  for (const auto& [name, model] : make_damped()) {
    CAPTURE(std::string(name));
    State state(model);
    scenes::shake(model, 1e-4, 0.5, state);
    const std::size_t count = state.position.size();
    Vec3Array moving(count), still(count), damping(count, Vec3::Zero());
    compute_forces(model, Load(), state.position, state.velocity, moving);
    compute_forces(model, Load(), state.position, Vec3Array(count, Vec3::Zero()), still);

    accumulate_damping(model, state.position, state.velocity, damping);

    double power = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 expected = moving[i] - still[i];
      CHECK((damping[i] - expected).norm() <= 1e-11 * (moving[i].norm() + still[i].norm()) + 1e-15);
      power += damping[i].dot(state.velocity[i]);
    }
    CHECK(scenes::max_norm(damping) > 0.0);
    CHECK(power < 0.0);
  }
}

TEST_CASE("a damper between two particles pulls by c times the rate, along the link by its part") {
  TissueModel model = scenes::make_oscillator_model(1e-3, 100.0, 0.2);
  const Vec3Array v = {Vec3::Zero(), Vec3(0.3, 0.4, 0.0)};  // the link lies along x
  Vec3Array f(2, Vec3::Zero());

  accumulate_damping(model, model.rest_position, v, f);
  CHECK((f[1] - Vec3(-0.06, 0.0, 0.0)).norm() < 1e-15);
  CHECK((f[0] + f[1]).norm() == 0.0);

  model.damping_law = DampingLaw::isotropic;
  f.assign(2, Vec3::Zero());
  accumulate_damping(model, model.rest_position, v, f);
  CHECK((f[1] - Vec3(-0.06, -0.08, 0.0)).norm() < 1e-15);
}
