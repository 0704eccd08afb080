// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "laws/linear_tissue.h"
#include "palpate/sim/dynamics/step.h"

using namespace palpate;
using namespace palpate::laws;
using doctest::Approx;

namespace {

struct Named {
  std::string name;
  TissueModel model;
};

/// Every scene under every kind of loss.
std::vector<Named> make_every_tissue() {
  std::vector<Named> all;
  const std::vector<std::pair<const char*, scenes::Losses>> losses = {
      {"undamped", {}},
      {"links damped", {.damping_ratio = 0.2}},
      {"links damped hard", {.damping_ratio = 1.5}},
      {"damped isotropically, with drag",
       {.damping_ratio = 0.3, .drag = 20.0, .law = DampingLaw::isotropic}},
      {"drag alone", {.drag = 300.0}}};
  for (const auto& [name, loss] : losses) {
    all.push_back({name, scenes::make_spring_organ(1, loss)});
    all.push_back({name, scenes::make_molecular_organ(1, loss)});
    all.push_back({name, scenes::make_sheet_tissue(loss)});
    all.push_back({name, scenes::make_hollow_tissue(loss)});
  }
  all.push_back({"oscillator", scenes::make_oscillator_model()});
  all.push_back({"damped oscillator", scenes::make_oscillator_model(1e-3, 100.0, 0.2)});
  all.push_back({"chain", scenes::make_chain_model(20)});
  TissueModel uneven = scenes::make_chain_model(20);
  for (int i = 0; i < 20; ++i) uneven.mass[i] *= 1.0 + 0.9 * scenes::scatter(i);
  uneven.springs.damping[3] = 0.7;  // one damper, far from the fastest mode
  all.push_back({"uneven chain", uneven});
  return all;
}

bool is_definite(const MatrixXd& matrix) {
  return Eigen::LLT<MatrixXd>(matrix).info() == Eigen::Success;
}

/// 4 - 2 dt C - dt² (K + coupling at free particle p); none for p = -1.
bool is_stable(const LinearTissue& tissue, double dt, double coupling = 0.0, int p = -1) {
  const Eigen::Index n = tissue.stiffness.rows();
  MatrixXd rest =
      4.0 * MatrixXd::Identity(n, n) - 2.0 * dt * tissue.damping - dt * dt * tissue.stiffness;
  for (int c = 0; p >= 0 && c < 3; ++c) {
    const double root = tissue.root_mass[3 * p + c];
    rest(3 * p + c, 3 * p + c) -= dt * dt * coupling / (root * root);
  }
  return is_definite(rest);
}

}  // namespace

TEST_CASE(
    "the step matrix of symplectic Euler is stable just while 4 - 2 dt C - dt² K is positive") {
  TissueModel chain = scenes::make_chain_model(8);
  chain.springs.damping[1] = 0.9;
  const std::vector<TissueModel> models = {
      scenes::make_spring_organ(0, {.damping_ratio = 0.3}), scenes::make_molecular_organ(0),
      scenes::make_spring_organ(0, {.damping_ratio = 0.2, .drag = 100.0}), chain};
  for (const TissueModel& model : models) {
    const LinearTissue tissue(model);
    const double limit =
        find_limit(tissue, Integrator::symplectic_euler, 4.0 / find_top_mode(tissue).frequency);

    CHECK(is_stable(tissue, limit * 0.9999));
    CHECK_FALSE(is_stable(tissue, limit * 1.0001));
  }
}

TEST_CASE("the stable step of an oscillator is a little less than 2 / w") {
  const TissueModel model = scenes::make_oscillator_model(0.25, 100.0);

  CHECK(stable_step(model) == Approx(0.9 * 2.0 / 20.0).epsilon(1e-6));
}

TEST_CASE("damping shortens the stable step to 2/w (sqrt(1 + z²) - z)") {
  const double w = 20.0, z = 0.7;
  const TissueModel model = scenes::make_oscillator_model(0.25, 100.0, 2.0 * z * w * 0.25);

  CHECK(stable_step(model) == Approx(0.9 * 2.0 / w * (std::sqrt(1.0 + z * z) - z)).epsilon(1e-6));
}

TEST_CASE("the spectrum of a chain is 4 k/m sin²: the largest by formula") {
  const int n = 20;
  const TissueModel model = scenes::make_chain_model(n, 1e-3, 100.0, 0.05);
  const double sine = std::sin((2 * n - 3) * std::numbers::pi / (4 * n - 2));

  const Spectrum spectrum = estimate_spectrum(model);

  CHECK(spectrum.stiffness == Approx(4e5 * sine * sine).epsilon(1e-3));
  CHECK(spectrum.damping == Approx(4.0 * 50.0 * sine * sine).epsilon(1e-3));
}

TEST_CASE("the stable step lies between 0.6 and 1.0 of the exact limit on every tissue") {
  for (const auto& each : make_every_tissue()) {
    CAPTURE(each.name);
    const TissueModel& model = each.model;
    const LinearTissue tissue(model);

    const double dt = stable_step(model);

    CHECK(is_stable(tissue, dt));
    CHECK_FALSE(is_stable(tissue, dt / 0.6));
    CHECK_FALSE(is_stable(tissue, dt / 0.85));  // which without coupling it always reaches
  }
}

TEST_CASE("with a coupling on any one particle the stable step holds, and is above 0.6 still") {
  for (const auto& each : make_every_tissue()) {
    const TissueModel& model = each.model;
    const LinearTissue tissue(model);
    const int count = static_cast<int>(tissue.particles.size());
    for (const double coupling : {30.0, 300.0, 3000.0}) {
      CAPTURE(each.name);
      CAPTURE(coupling);

      const double dt = stable_step(model, coupling);

      int unstable_at_dt = 0;
      bool unstable_beyond = false;
      for (int p = 0; p < count; ++p) {
        unstable_at_dt += !is_stable(tissue, dt, coupling, p);
        unstable_beyond = unstable_beyond || !is_stable(tissue, dt / 0.6, coupling, p);
      }
      CHECK(unstable_at_dt == 0);
      CHECK(unstable_beyond);
    }
  }
}

TEST_CASE("the spectrum with a coupling bounds that of every particle it may hold") {
  for (const auto& each : make_every_tissue()) {
    CAPTURE(each.name);
    const TissueModel& model = each.model;
    const LinearTissue tissue(model);
    const double coupling = 200.0;
    double largest = 0.0;
    for (int p = 0; p < static_cast<int>(tissue.particles.size()); p += 5) {
      MatrixXd k = tissue.stiffness;
      for (int c = 0; c < 3; ++c) {
        k(3 * p + c, 3 * p + c) += coupling / std::pow(tissue.root_mass[3 * p + c], 2);
      }
      const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(k, Eigen::EigenvaluesOnly);
      largest = std::max(largest, solver.eigenvalues().maxCoeff());
    }

    const Spectrum spectrum = estimate_spectrum(model, coupling);

    CHECK(spectrum.stiffness >= largest * (1.0 - 1e-6));
    CHECK(spectrum.stiffness < 3.0 * largest);
  }
}

TEST_CASE("a hundred times the stiffness gives a tenth of the stable step, over four decades") {
  const double dt = stable_step(scenes::make_chain_model(30, 1e-3, 1.0));

  for (const double stiffness : {1e1, 1e2, 1e3, 1e4}) {
    const double stiffer = stable_step(scenes::make_chain_model(30, 1e-3, stiffness));
    CHECK(stiffer == Approx(dt / std::sqrt(stiffness)).epsilon(1e-6));
  }
}

TEST_CASE("the stable step is the same bits every time, and under Eq 10 that of its angle law") {
  const TissueModel model = scenes::make_molecular_organ(2, {.damping_ratio = 0.2});

  CHECK(stable_step(model) == stable_step(model));
  CHECK(stable_step(model, 500.0) == stable_step(model, 500.0));

  TissueModel eq10 = model;
  eq10.angle_law = AngleLaw::eq10;
  for (std::size_t t = 0; t < eq10.angles.corners.size(); ++t) {
    eq10.angles.stretch_coupling[t] = {0.0, 0.0, 0.0};
    const auto& l = eq10.angles.rest_length[t];
    for (double& bend : eq10.angles.bend_stiffness[t]) bend *= 4.5 / (l[0] + l[1] + l[2]);
  }
  TissueModel law = model;
  law.angles.stretch_coupling = eq10.angles.stretch_coupling;
  CHECK(stable_step(eq10) == Approx(stable_step(law)).epsilon(0.05));
}

TEST_CASE("under Eq 10 with enough damping the step matrix is stable at the stable step") {
  const TissueModel model = scenes::make_molecular_organ(0, {.damping_ratio = 0.3}, AngleLaw::eq10);
  const LinearTissue tissue(model);
  REQUIRE(tissue.asymmetry > 1e-3);
  const auto radius_at = [&](double dt) {
    return compute_spectral_radius(build_step_matrix(tissue, Integrator::symplectic_euler, dt));
  };

  const double dt = stable_step(model);

  CHECK(radius_at(dt) <= kNoGrowth);
  CHECK(radius_at(dt / 0.6) > kNoGrowth);
}

TEST_CASE("what cannot swing has no limit") {
  TissueModel model = scenes::make_oscillator_model();
  model.fixed = {0, 1};
  TissueModel dust;
  dust.rest_position = {{0, 0, 0}, {1, 0, 0}};
  dust.mass = {0.25, 1.0};

  CHECK(std::isinf(stable_step(model)));
  CHECK(std::isinf(stable_step(dust)));
  CHECK(stable_step(dust, 100.0) == Approx(0.9 * 0.1));  // only the coupling swings: w = 20
}

TEST_CASE("on a mesh of an organ's size Lanczos and a long power iteration agree" *
          doctest::test_suite("landing")) {
  const TissueModel model = scenes::make_spring_organ(3, {.damping_ratio = 0.2});  // 642 particles
  const LinearTissue tissue(model);
  const auto by_power = [](const MatrixXd& matrix) {
    VectorXd v = VectorXd::LinSpaced(matrix.rows(), 0.5, 1.0);
    double value = 0.0;
    for (int i = 0; i < 300; ++i) {
      const VectorXd next = matrix * v;
      value = v.dot(next) / v.squaredNorm();
      v = next.normalized();
    }
    return value;
  };

  const Spectrum spectrum = estimate_spectrum(model);

  CHECK(spectrum.stiffness == Approx(by_power(tissue.stiffness)).epsilon(5e-3));
  CHECK(spectrum.damping == Approx(by_power(tissue.damping)).epsilon(5e-3));
}
