// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "laws/linear_tissue.h"

using namespace palpate;
using namespace palpate::laws;
using doctest::Approx;
using std::numbers::pi;

namespace {

constexpr double kMass = 1e-3, kStiffness = 100.0, kSpacing = 0.01;
/// [1/s] of a spring between two of the masses' halves; every frequency of a chain is below 2 of it
const double kRate = std::sqrt(kStiffness / kMass);

/// [rad/s] of mode j = 1 .. n - 1 of a chain of n particles, the first held.
double chain_frequency(int n, int j) {
  return 2.0 * kRate * std::sin((2 * j - 1) * pi / (4 * n - 2));
}

/// How far particle i moves in that mode, relative to the largest.
double chain_shape(int n, int j, int i) { return std::sin((2 * j - 1) * pi * i / (2 * n - 1)); }

/// The smallest eigenvalues of a matrix, ascending.
VectorXd eigenvalues(const MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix).eigenvalues();
}

/// [m] of every particle from its rest place along x.
std::vector<double> offsets(const TissueModel& model, const State& state) {
  std::vector<double> u;
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    u.push_back(state.position[i].x() - model.rest_position[i].x());
  }
  return u;
}

/// Where the squares of the offsets have their middle, in spacings.
double find_middle(const std::vector<double>& u) {
  double sum = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    sum += u[i] * u[i];
    moment += u[i] * u[i] * static_cast<double>(i);
  }
  return moment / sum;
}

/// A packet of waves of `phase` [rad] per spacing about particle `centre`, going towards +x.
State make_packet(const TissueModel& model, double phase, double centre, double width) {
  const double frequency = 2.0 * kRate * std::sin(0.5 * phase);
  State state(model);
  for (int i = 1; i < particle_count(model); ++i) {
    const double off = (i - centre) / width, hill = 1e-6 * std::exp(-0.5 * off * off);
    state.position[i].x() += hill * std::cos(phase * (i - centre));
    state.velocity[i].x() += hill * frequency * std::sin(phase * (i - centre));
  }
  return state;
}

/// A rod of rubber standing on its end, cut into n equal springs: what it is made of, not how.
TissueModel make_rod(int n) {
  const double length = 0.1, section = 1e-4, young_modulus = 1e5, density = 1000.0;
  const double piece = length / n;
  TissueModel model = scenes::make_chain_model(n + 1, density * section * piece,
                                               young_modulus * section / piece, 0.0, piece);
  model.mass.back() *= 0.5;  // the free end has a piece on one side only
  return model;
}

}  // namespace

TEST_CASE("a damped oscillator rings at w sqrt(1 - zeta²) and fades as exp(-zeta w t)") {
  for (const double zeta : {0.05, 0.3, 0.9}) {
    CAPTURE(zeta);
    const TissueModel model =
        scenes::make_oscillator_model(kMass, kStiffness, 2.0 * zeta * kRate * kMass);
    State state(model);
    state.position[1].x() += 1e-3;
    const double ring = kRate * std::sqrt(1.0 - zeta * zeta), end = 2.0 / kRate;

    for (int s = 0; s < 1000; ++s)
      step(model, Load(), end / 1000, Integrator::runge_kutta_4, state);

    const double fade = std::exp(-zeta * kRate * end);
    const double expected = std::cos(ring * end) + zeta * kRate / ring * std::sin(ring * end);
    CHECK(offsets(model, state)[1] == Approx(1e-3 * fade * expected).epsilon(1e-8));
  }
}

TEST_CASE("the modes of a chain have the frequencies of the formula, and none across") {
  const int n = 12;
  const VectorXd found =
      eigenvalues(LinearTissue(scenes::make_chain_model(n, kMass, kStiffness)).stiffness);

  CHECK(found.head(2 * (n - 1)).cwiseAbs().maxCoeff() < 1e-6 * kRate * kRate);
  for (int j = 1; j < n; ++j) {
    CAPTURE(j);
    CHECK(std::sqrt(found[2 * (n - 1) + j - 1]) == Approx(chain_frequency(n, j)).epsilon(1e-6));
  }
}

TEST_CASE("a mode of a chain keeps its shape and turns with its own frequency") {
  const int n = 12;
  const TissueModel model = scenes::make_chain_model(n, kMass, kStiffness);
  for (const int j : {1, 2, 5, 11}) {
    CAPTURE(j);
    State state(model);
    for (int i = 1; i < n; ++i) state.position[i].x() += 1e-5 * chain_shape(n, j, i);
    const double third = 2.0 * pi / chain_frequency(n, j) / 3.0;  // its cosine is -1/2

    for (int s = 0; s < 500; ++s) {
      step(model, Load(), third / 500, Integrator::runge_kutta_4, state);
    }

    const std::vector<double> u = offsets(model, state);
    for (int i = 1; i < n; ++i) {
      CAPTURE(i);
      CHECK(std::abs(u[i] + 0.5e-5 * chain_shape(n, j, i)) < 1e-10);
    }
  }
}

TEST_CASE("a stretched chain between two walls sounds as the string of its tension") {
  const int n = 11;
  const double stretch = 1.3;
  TissueModel model = scenes::make_chain_model(n, kMass, kStiffness, 0.0, kSpacing);
  for (Vec3& x : model.rest_position) x *= stretch;
  model.fixed = {0, n - 1};
  const double tension = kStiffness * (stretch - 1.0) * kSpacing;

  const VectorXd found = eigenvalues(LinearTissue(model).stiffness);

  // of the two directions across, before those along, which are stiffer
  for (int j = 1; j < 3; ++j) {
    CAPTURE(j);
    const double expected = 2.0 * std::sqrt(tension / (kMass * stretch * kSpacing)) *
                            std::sin(j * pi / (2.0 * (n - 1)));
    CHECK(std::sqrt(found[2 * j - 2]) == Approx(expected).epsilon(1e-6));
    CHECK(std::sqrt(found[2 * j - 1]) == Approx(expected).epsilon(1e-6));
  }
}

TEST_CASE("a packet of waves travels with l sqrt(k/m) cos(q l / 2)") {
  const int n = 400;
  const TissueModel model = scenes::make_chain_model(n, kMass, kStiffness, 0.0, kSpacing);
  for (const double phase : {0.2, 1.0, 2.0}) {
    CAPTURE(phase);
    State state = make_packet(model, phase, 100.0, 20.0);
    const double start = find_middle(offsets(model, state));
    // the packet holds phases a few hundredths off, slower or faster by a quarter of their square
    const double distance = 100.0, speed = kRate * std::cos(0.5 * phase),
                 duration = distance / speed;

    for (int s = 0; s < 4000; ++s) {
      step(model, Load(), duration / 4000, Integrator::runge_kutta_4, state);
    }

    CHECK(find_middle(offsets(model, state)) - start == Approx(distance).epsilon(0.01));
  }
}

TEST_CASE("what a rod does converges with the square of the piece it is cut into") {
  const double length = 0.1, speed = std::sqrt(1e5 / 1000.0);  // sqrt(E / rho)
  const double exact = pi * speed / (2.0 * length);
  double before = 0.0;
  for (const int n : {5, 10, 20, 40}) {
    CAPTURE(n);
    const VectorXd found = eigenvalues(LinearTissue(make_rod(n)).stiffness);
    const double error = 1.0 - std::sqrt(found[2 * n]) / exact;

    CHECK(error > 0.0);
    if (before > 0.0) CHECK(std::log2(before / error) == Approx(2.0).epsilon(0.01));
    before = error;
  }
  CHECK(before < 1e-4);
}
