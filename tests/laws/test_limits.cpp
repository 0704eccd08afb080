// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "laws/linear_tissue.h"
#include "palpate/sim/dynamics/state.h"

using namespace palpate;
using namespace palpate::laws;
using doctest::Approx;

namespace {

constexpr int kSteps = 10000;

struct Scene {
  std::string name;
  TissueModel model;
  double amplitude;  ///< [m] of the particle that moves most
};

/// The springs of the first two are straight and stay so: linear until an end passes the other, a
/// thousand amplitudes away. The organs move by a billionth of an edge, linear to as many digits.
std::vector<Scene> make_scenes() {
  std::vector<Scene> scenes;
  scenes.push_back({"oscillator", scenes::make_oscillator_model(), 1e-5});
  scenes.push_back({"chain", scenes::make_chain_model(20), 1e-5});
  scenes.push_back({"mass-spring organ", scenes::make_spring_organ(2), 5e-12});
  scenes.push_back({"molecular organ", scenes::make_molecular_organ(2), 5e-12});
  return scenes;
}

State excite(const Scene& scene, const LinearTissue& tissue, const Mode& mode) {
  const double size = mode.shape.cwiseQuotient(tissue.root_mass).cwiseAbs().maxCoeff();
  State state(scene.model);
  displace(tissue, mode.shape * (scene.amplitude / size), VectorXd::Zero(mode.shape.size()), state);
  return state;
}

double total_energy(const TissueModel& model, const State& state) {
  return compute_energy(model, Vec3::Zero(), state).total();
}

/// The largest energy within 10,000 steps, over the first; stops once it is a thousandfold.
double find_largest_growth(const TissueModel& model, Integrator integrator, double dt,
                           State state) {
  const double start = total_energy(model, state);
  double largest = 0.0;
  for (int s = 0; s < kSteps && largest <= 1000.0; ++s) {
    step(model, Load(), dt, integrator, state);
    const double energy = total_energy(model, state) / start;
    if (!std::isfinite(energy)) return INFINITY;
    largest = std::max(largest, energy);
  }
  return largest;
}

constexpr Integrator kExplicit[] = {Integrator::explicit_euler, Integrator::symplectic_euler,
                                    Integrator::midpoint, Integrator::runge_kutta_4,
                                    Integrator::symplectic_euler_implicit_damping};

/// [s] Beyond every limit of these tissues: damping that is taken implicitly lengthens a step to
/// 8.5/w at zeta = 2, and a mode of its own that is damped more by more.
double find_beyond(const LinearTissue& tissue, Integrator integrator) {
  const double w = find_top_mode(tissue).frequency;
  return (integrator == Integrator::symplectic_euler_implicit_damping ? 1000.0 : 4.0) / w;
}

std::vector<Scene> make_damped_scenes() {
  TissueModel chain = scenes::make_chain_model(8, 1e-3, 100.0, 0.1);
  chain.springs.damping[2] = 0.4;
  std::vector<Scene> all;
  all.push_back({"oscillator", scenes::make_oscillator_model(1e-3, 100.0, 0.13), 1e-5});
  all.push_back({"overdamped oscillator", scenes::make_oscillator_model(1e-3, 100.0, 0.9), 1e-5});
  all.push_back({"chain", chain, 1e-5});
  all.push_back(
      {"organ, links damped", scenes::make_spring_organ(0, {.damping_ratio = 0.2}), 5e-12});
  all.push_back({"organ, drag", scenes::make_molecular_organ(0, {.drag = 300.0}), 5e-12});
  return all;
}

}  // namespace

TEST_CASE("symplectic Euler keeps within its bound at 0.98 of 2/w and passes 1000 E0 at 1.05") {
  for (const Scene& scene : make_scenes()) {
    CAPTURE(scene.name);
    const LinearTissue tissue(scene.model);
    const Mode top = find_top_mode(tissue);
    const State start = excite(scene, tissue, top);
    const double limit = 2.0 / top.frequency;

    // x' (v' - dt w² x'/2) is conserved, so energy varies between 1 ± w dt/2 times one number
    const double bound = (1.0 + 0.98) / (1.0 - 0.98);
    CHECK(find_largest_growth(scene.model, Integrator::symplectic_euler, 0.98 * limit, start) <
          1.001 * bound);
    CHECK(find_largest_growth(scene.model, Integrator::symplectic_euler, 1.05 * limit, start) >
          1000.0);
  }
}

TEST_CASE("Runge-Kutta 4 loses energy at 0.98 of 2.828/w and passes 1000 E0 at 1.05") {
  for (const Scene& scene : make_scenes()) {
    CAPTURE(scene.name);
    const LinearTissue tissue(scene.model);
    const Mode top = find_top_mode(tissue);
    const State start = excite(scene, tissue, top);
    const double limit = 2.0 * std::sqrt(2.0) / top.frequency;

    CHECK(find_largest_growth(scene.model, Integrator::runge_kutta_4, 0.98 * limit, start) <= 1.0);
    CHECK(find_largest_growth(scene.model, Integrator::runge_kutta_4, 1.05 * limit, start) >
          1000.0);
  }
}

TEST_CASE("damped, every explicit integrator is stable just up to where its step matrix is") {
  for (const Scene& scene : make_damped_scenes()) {
    for (const Integrator integrator : kExplicit) {
      CAPTURE(scene.name);
      CAPTURE(std::string(integrator_name(integrator)));
      const LinearTissue tissue(scene.model);
      const Mode top = find_top_mode(tissue);
      const double limit = find_limit(tissue, integrator, find_beyond(tissue, integrator));
      // every mode takes part; an offset across a chain would meet no stiffness at all
      State start = excite(scene, tissue, top);
      for (std::size_t p = 0; p < tissue.particles.size(); ++p) {
        start.position[tissue.particles[p]].x() +=
            scene.amplitude * scenes::scatter(static_cast<std::uint32_t>(p));
      }

      CHECK(find_largest_growth(scene.model, integrator, 0.98 * limit, start) < 100.0);
      CHECK(find_largest_growth(scene.model, integrator, 1.05 * limit, start) > 1000.0);
    }
  }
}

TEST_CASE("stable_step of every explicit integrator lies between 0.4 and 1.0 of where it fails") {
  for (const Scene& scene : make_damped_scenes()) {
    for (const Integrator integrator : kExplicit) {
      CAPTURE(scene.name);
      CAPTURE(std::string(integrator_name(integrator)));
      const LinearTissue tissue(scene.model);
      const double exact = find_limit(tissue, integrator, find_beyond(tissue, integrator));

      const double step = stable_step(scene.model, integrator);

      CHECK(step <= exact);
      CHECK(step >= 0.4 * exact);
      CHECK(compute_spectral_radius(build_step_matrix(tissue, integrator, step)) <= kNoGrowth);
    }
  }
}

TEST_CASE("stable_step is 0 where an integrator has none, and infinite where it has no limit") {
  const TissueModel undamped = scenes::make_spring_organ(1);
  CHECK(stable_step(undamped, Integrator::explicit_euler) < 1e-12);
  CHECK(stable_step(undamped, Integrator::midpoint) < 1e-12);
  CHECK(stable_step(undamped, Integrator::symplectic_euler) == stable_step(undamped));
  for (const Integrator integrator : {Integrator::implicit_euler_linear, Integrator::implicit_euler,
                                      Integrator::implicit_midpoint}) {
    CHECK(std::isinf(stable_step(undamped, integrator)));
  }
}

TEST_CASE("damped oscillators have the limits that the formulas say") {
  const double w = std::sqrt(1e5), mass = 1e-3;
  for (const double z : {0.05, 0.2, 0.5, 0.9, 2.0}) {
    CAPTURE(z);
    const LinearTissue tissue(scenes::make_oscillator_model(mass, 100.0, 2.0 * z * w * mass));
    const auto limit = [&](Integrator integrator) {
      return w * find_limit(tissue, integrator, find_beyond(tissue, integrator));
    };
    const double slow = z + std::sqrt(std::max(0.0, z * z - 1.0));

    CHECK(limit(Integrator::explicit_euler) ==
          Approx(z < 1.0 ? 2.0 * z : 2.0 / slow).epsilon(1e-3));
    CHECK(limit(Integrator::symplectic_euler) ==
          Approx(2.0 * (std::sqrt(1.0 + z * z) - z)).epsilon(1e-3));
    CHECK(limit(Integrator::symplectic_euler_implicit_damping) ==
          Approx(2.0 * (std::sqrt(1.0 + z * z) + z)).epsilon(1e-3));
    if (z > 1.0) {
      CHECK(limit(Integrator::midpoint) == Approx(2.0 / slow).epsilon(1e-3));
      CHECK(limit(Integrator::runge_kutta_4) == Approx(2.785 / slow).epsilon(1e-3));
    }
  }
}

TEST_CASE("undamped, explicit Euler and midpoint gain energy at every step at the rate foretold") {
  for (const Scene& scene : make_scenes()) {
    const LinearTissue tissue(scene.model);
    const Mode top = find_top_mode(tissue);
    for (const double h : {0.02, 0.1, 0.3, 1.0}) {
      CAPTURE(scene.name);
      CAPTURE(h);
      const auto measure_rate = [&](Integrator integrator, double foretold) {
        State state = excite(scene, tissue, top);
        const double start = total_energy(scene.model, state);
        // until the energy has doubled, or 10,000 steps
        const int steps = std::clamp(static_cast<int>(std::log(2.0) / foretold), 1, kSteps);
        for (int s = 0; s < steps; ++s)
          step(scene.model, Load(), h / top.frequency, integrator, state);
        return std::log(total_energy(scene.model, state) / start) / steps;
      };
      const double euler = std::log1p(h * h), midpoint = std::log1p(h * h * h * h / 4.0);

      CHECK(measure_rate(Integrator::explicit_euler, euler) == Approx(euler).epsilon(0.05));
      CHECK(measure_rate(Integrator::midpoint, midpoint) == Approx(midpoint).epsilon(0.05));
    }
  }
}

TEST_CASE("no implicit method gains energy at w dt = 100") {
  for (const Scene& scene : make_scenes()) {
    const LinearTissue tissue(scene.model);
    const Mode top = find_top_mode(tissue);
    for (const Integrator integrator :
         {Integrator::implicit_euler_linear, Integrator::implicit_euler,
          Integrator::implicit_midpoint}) {
      CAPTURE(scene.name);
      CAPTURE(std::string(integrator_name(integrator)));
      State state = excite(scene, tissue, top);
      const double start = total_energy(scene.model, state);
      ImplicitStepper stepper(scene.model, integrator);
      double largest = 0.0;
      for (int s = 0; s < 30; ++s) {
        stepper.step(Load(), 100.0 / top.frequency, state);
        largest = std::max(largest, total_energy(scene.model, state));
      }

      CHECK(largest <= (1.0 + 1e-3) * start);
    }
  }
}

TEST_CASE("implicit steps at w dt = 100 stay calm in a tissue that is shaken hard") {
  const TissueModel model = scenes::make_molecular_organ(1, {.damping_ratio = 0.1});
  const double w = find_top_mode(LinearTissue(model)).frequency;
  for (const Integrator integrator :
       {Integrator::implicit_euler_linear, Integrator::implicit_euler}) {
    CAPTURE(std::string(integrator_name(integrator)));
    State state(model);
    scenes::shake(model, 2e-3, 0.2, state);
    const double start = total_energy(model, state);
    ImplicitStepper stepper(model, integrator);
    double largest = 0.0;
    for (int s = 0; s < 50; ++s) {
      stepper.step(Load(), 100.0 / w, state);
      largest = std::max(largest, total_energy(model, state));
    }

    CHECK(largest < start);
  }
}

TEST_CASE("implicit Euler's amplitude decays by ln(1 + (w dt)²)/2 a step") {
  for (const Scene& scene : make_scenes()) {
    const LinearTissue tissue(scene.model);
    const Mode top = find_top_mode(tissue);
    for (const Integrator integrator :
         {Integrator::implicit_euler_linear, Integrator::implicit_euler}) {
      for (const double h : {0.3, 1.0, 3.0}) {
        CAPTURE(scene.name);
        CAPTURE(h);
        const double foretold = 0.5 * std::log1p(h * h);
        State state = excite(scene, tissue, top);
        const double start = total_energy(scene.model, state);
        ImplicitStepper stepper(scene.model, integrator);
        const int steps = std::max(1, static_cast<int>(2.0 / foretold));
        for (int s = 0; s < steps; ++s) stepper.step(Load(), h / top.frequency, state);

        const double measured = -0.5 * std::log(total_energy(scene.model, state) / start) / steps;
        CHECK(measured == Approx(foretold).epsilon(0.01));
      }
    }
  }
}

TEST_CASE("implicit midpoint keeps the energy of what is linear, and nearly of what is not") {
  for (const double h : {0.3, 1.0, 10.0}) {
    const TissueModel chain = scenes::make_chain_model(20);
    State state(chain);
    for (int i = 1; i < 20; ++i) {
      state.position[i].x() += 1e-3 * scenes::scatter(static_cast<std::uint32_t>(i));
    }
    const double start = total_energy(chain, state);
    ImplicitStepper stepper(chain, Integrator::implicit_midpoint);
    for (int s = 0; s < 200; ++s) {
      stepper.step(Load(), h / find_top_mode(LinearTissue(chain)).frequency, state);
    }
    CHECK(total_energy(chain, state) == Approx(start).epsilon(1e-8));
  }

  const TissueModel organ = scenes::make_molecular_organ(1);
  State state(organ);
  scenes::shake(organ, 5e-4, 0.05, state);
  const double start = total_energy(organ, state);
  ImplicitStepper stepper(organ, Integrator::implicit_midpoint);
  const double dt = 1.0 / find_top_mode(LinearTissue(organ)).frequency;
  for (int s = 0; s < 300; ++s) stepper.step(Load(), dt, state);
  CHECK(total_energy(organ, state) == Approx(start).epsilon(0.05));
}

TEST_CASE("implicit midpoint chatters at w dt >> 1, and damping stops it as foretold") {
  const double mass = 1e-3, w = std::sqrt(1e5);
  for (const double h : {10.0, 100.0}) {
    CAPTURE(h);
    // from one step to the next it turns by 2 atan(h/2), nearly half a turn
    const TissueModel undamped = scenes::make_oscillator_model(mass, 100.0);
    State state(undamped);
    state.position[1].x() += 1e-5;
    ImplicitStepper stepper(undamped, Integrator::implicit_midpoint);
    for (int s = 1; s <= 10; ++s) {
      stepper.step(Load(), h / w, state);
      const double offset = state.position[1].x() - undamped.rest_position[1].x();
      CHECK(offset / 1e-5 == Approx(std::cos(2.0 * s * std::atan(0.5 * h))).epsilon(0.05));
    }

    for (const double zeta : {0.1, 0.5}) {
      CAPTURE(zeta);
      const double foretold =
          std::log((1.0 + zeta * h + 0.25 * h * h) / (1.0 - zeta * h + 0.25 * h * h));
      const TissueModel damped = scenes::make_oscillator_model(mass, 100.0, 2.0 * zeta * w * mass);
      State fading(damped);
      fading.position[1].x() += 1e-5;
      const double start = total_energy(damped, fading);
      ImplicitStepper fade(damped, Integrator::implicit_midpoint);
      const int steps = static_cast<int>(15.0 / foretold);
      for (int s = 0; s < steps; ++s) fade.step(Load(), h / w, fading);
      const double measured = -std::log(total_energy(damped, fading) / start) / steps;
      CHECK(measured == Approx(foretold).epsilon(0.05));
    }
  }
}
