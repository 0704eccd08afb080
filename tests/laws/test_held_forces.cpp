// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "laws/linear_tissue.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/kernels.h"

// What a force does that is held while what it follows from moves on: over the substeps of a tick
// it feeds the tissue, over the ticks of a slow simulation the hand [stability: held forces].

using namespace palpate;
using namespace palpate::laws;
using doctest::Approx;

namespace {

// ------------------------------------------------------------------ a coupling, over the substeps

constexpr int kSubsteps = 8;

/// A particle of an organ held by a spring [N/m], as a tool that is fastened to it holds it.
struct HeldOrgan {
  HeldOrgan()
      : model(scenes::make_spring_organ(1, {.damping_ratio = 0.1, .drag = 50.0})),
        tissue(model),
        dt(0.5 * stable_step(model)) {
    for (int p = 1; p < static_cast<int>(tissue.particles.size()); ++p) {
      if (height(p) > height(held)) held = p;
    }
  }

  double height(int p) const {
    return model.rest_position[tissue.particles[static_cast<std::size_t>(p)]].z();
  }

  TissueModel model;
  LinearTissue tissue;
  double dt;     ///< [s] of a substep
  int held = 0;  ///< of the free particles, the highest
};

/// What a tick of substeps multiplies (x, v) by. Of a force on the particle that is found once, as
/// -K x of the tick's start, each substep adds (dt² f, dt f).
MatrixXd build_tick_matrix(const HeldOrgan& organ, double coupling, bool once) {
  LinearTissue tissue = organ.tissue;
  const Eigen::Index n = tissue.stiffness.rows();
  MatrixXd pull = MatrixXd::Zero(n, n);
  for (int c = 0; c < 3; ++c) {
    const double root = tissue.root_mass[3 * organ.held + c];
    pull(3 * organ.held + c, 3 * organ.held + c) = coupling / (root * root);
  }
  if (!once) tissue.exact_stiffness += pull;
  const MatrixXd step = build_step_matrix(tissue, Integrator::symplectic_euler, organ.dt);
  MatrixXd force = MatrixXd::Zero(2 * n, 2 * n);
  if (once) {
    force.topLeftCorner(n, n) = -organ.dt * organ.dt * pull;
    force.bottomLeftCorner(n, n) = -organ.dt * pull;
  }
  MatrixXd tick = MatrixXd::Identity(2 * n, 2 * n);
  for (int s = 0; s < kSubsteps; ++s) tick = step * tick + force;
  return tick;
}

/// [N/m] the coupling beyond which a motion grows, by halving an interval.
double predict_coupling(const HeldOrgan& organ, bool once) {
  double stable = 1.0, unstable = 1e4;
  for (int halving = 0; halving < 11; ++halving) {
    const double middle = std::sqrt(stable * unstable);
    const double radius = compute_spectral_radius(build_tick_matrix(organ, middle, once));
    (radius <= kNoGrowth ? stable : unstable) = middle;
  }
  return stable;
}

/// How a motion grows in a tick: as foretold by the eigenvalue of largest size, and as measured
/// from the tissue itself, which begins with that motion.
struct Growth {
  double foretold = 0.0, measured = 0.0;  ///< [-] logarithms
};

Growth find_growth(const HeldOrgan& organ, double coupling, bool once) {
  const Eigen::EigenSolver<MatrixXd> solver(build_tick_matrix(organ, coupling, once));
  Eigen::Index most = 0;
  const double radius = solver.eigenvalues().cwiseAbs().maxCoeff(&most);
  const VectorXd motion = solver.eigenvectors().col(most).real();
  const Eigen::Index n = organ.tissue.stiffness.rows();
  State state(organ.model);
  const double size = 1e-9 / motion.head(n).cwiseQuotient(organ.tissue.root_mass).norm();
  displace(organ.tissue, size * motion.head(n), size * motion.tail(n), state);

  const int particle = organ.tissue.particles[static_cast<std::size_t>(organ.held)];
  int triangle = 0;
  Vec3 weights = Vec3::Zero();
  for (; weights.isZero(); ++triangle) {
    for (int c = 0; c < 3; ++c) weights[c] = organ.model.triangles[triangle][c] == particle;
  }
  Load load(1);
  const int ticks = std::clamp(static_cast<int>(5.0 / std::abs(std::log(radius))), 100, 20000);
  double early = 0.0, late = 0.0;
  for (int t = 0; t < ticks; ++t) {
    for (int s = 0; s < kSubsteps; ++s) {
      if (s == 0 || !once) {
        load.clear();
        load.add({triangle - 1, weights,
                  coupling * (organ.model.rest_position[particle] - state.position[particle])});
      }
      step(organ.model, load, organ.dt, state);
    }
    const double far = scenes::max_difference(state.position, organ.model.rest_position);
    // over many turns of the motion
    if (t < ticks / 5) early += far / (ticks / 5);
    if (t >= ticks - ticks / 5) late += far / (ticks / 5);
  }
  return {std::log(radius), std::log(late / early) / (ticks - ticks / 5)};
}

// ------------------------------------------------------------------ a force, over the ticks

constexpr double kTick = 1e-3;                  // [s]
constexpr double kMass = 0.12, kDamping = 0.1;  // [kg], [N·s/m] of a device without a hand

/// How a device swings about where it is pushed to: `push(x)` is the force [N] at a place [m], told
/// every `period` ticks, and felt `late` periods later until the next one comes. The widest swing
/// in the last second over how far it was let go from there.
template <class Push>
double swing_device(Push push, int period, int late, double seconds) {
  std::deque<double> told;
  constexpr double kStart = 1e-4;
  double x = kStart, v = 0.0, widest = 0.0, force = 0.0;
  // of m v' = F - b v over a tick, exactly
  const double left = std::exp(-kDamping / kMass * kTick);
  const int ticks = static_cast<int>(seconds / kTick);
  for (int t = 0; t < ticks; ++t) {
    if (t % period == 0) {
      told.push_back(push(x));
      if (static_cast<int>(told.size()) > late) {
        force = told.front();
        told.pop_front();
      }
    }
    const double end = force / kDamping;
    x += end * kTick + (v - end) * (1.0 - left) * kMass / kDamping;
    v = end + (v - end) * left;
    if (t >= ticks - 1000) widest = std::max(widest, std::abs(x));
    if (std::abs(x) > 1.0) return INFINITY;
  }
  return widest / kStart;
}

/// [N/m] the stiffest spring that calms so, by halving an interval.
double find_stiffest(int period, int late) {
  double calm = 0.0, grows = 1000.0;
  for (int halving = 0; halving < 14; ++halving) {
    const double middle = 0.5 * (calm + grows);
    const double swing = swing_device([&](double x) { return -middle * x; }, period, late, 40.0);
    (swing < 1.0 ? calm : grows) = middle;
  }
  return calm;
}

/// A tissue under a tool that has pressed into it, and what it answers to where the hand goes.
struct PressedTissue {
  PressedTissue() : scene(make_scene()), world(scene) {
    for (int t = 0; t < 600; ++t) press(1e-2 * std::max(0.0, 1.0 - t / 300.0));
    rest_force = press(0.0);
    // slow enough that tissue and tool keep up
    for (int t = 0; t < 400; ++t) press(1e-4 * std::min(1.0, t / 100.0));
    stiffness = (press(1e-4) - rest_force) / -1e-4;
    for (int t = 0; t < 400; ++t) press(1e-4 * std::max(0.0, 1.0 - t / 100.0));
  }

  static Scene make_scene() {
    Scene scene;
    scene.bodies[0].kernel = scenes::kernel_under_test();
    SurfaceOptions options;
    options.drag = 100.0;
    options.home_stiffness = 3e5;
    const SurfaceMesh mesh = scenes::make_organ_mesh(2);
    options.fixed = scenes::find_base(mesh);
    scene.bodies[0].tissue = build_mass_spring(mesh, {}, 60.0, options);
    return build_scene(std::move(scene));
  }

  /// [N] upwards on a hand that is `height` [m] above where it has pressed 4 mm deep.
  double press(double height) {
    HapticSample hand;
    hand.time = time;
    hand.position = Vec3(0.001, 0.0015, 0.03 + Tool{}.radius - 4e-3 + height);
    time += kTick;
    return tick(scene, hand, kTick, world).force.z();
  }

  Scene scene;
  World world;
  double time = 0.0;
  double rest_force = 0.0;  ///< [N] at rest
  double stiffness = 0.0;   ///< [N/m] of the tissue there
};

/// The same from a simulation that takes `period` ticks: it begins with the hand where it then is,
/// lets the tissue come to rest there, and what it found is known once it has ended.
struct SlowTissue {
  struct Answer {
    double force = 0.0;      ///< [N] beyond that at rest
    double place = 0.0;      ///< [m] of the hand that it is of
    double stiffness = 0.0;  ///< [N/m] there
  };

  static constexpr int kSettling = 60;     // [ticks]
  static constexpr double kBeside = 1e-4;  // [m]

  explicit SlowTissue(int ticks) : period(ticks) {}

  Answer ask(double x) {
    if (since++ % period == 0) {
      known = found;
      double beside = 0.0;
      for (int t = 0; t < kSettling; ++t) beside = tissue.press(x + kBeside) - tissue.rest_force;
      for (int t = 0; t < kSettling; ++t) found.force = tissue.press(x) - tissue.rest_force;
      found.place = x;
      found.stiffness = (found.force - beside) / kBeside;
    }
    return known;
  }

  PressedTissue tissue;
  int period, since = 0;
  Answer known, found;
};

}  // namespace

TEST_CASE("a coupling held over the substeps diverges where foretold, evaluated in each it holds") {
  const HeldOrgan organ;
  const double once = predict_coupling(organ, true), each = predict_coupling(organ, false);
  CAPTURE(once);
  CAPTURE(each);
  CHECK(each > 5.0 * once);

  for (const double part : {0.8, 1.2}) {
    CAPTURE(part);
    const Growth held = find_growth(organ, part * once, true);
    CHECK((held.foretold > 0.0) == (part > 1.0));
    CHECK(held.measured == Approx(held.foretold).epsilon(0.05));
  }
  // as stiff as that it is calm where it is found in every substep
  CHECK(find_growth(organ, 3.0 * once, false).measured < 0.0);
  CHECK(find_growth(organ, 0.95 * each, false).measured < 0.0);
  CHECK(find_growth(organ, 1.05 * each, false).measured > 0.0);
}

TEST_CASE("a force held for a period Ts, and one late, calms a device up to K = b/(1.5 Ts)") {
  for (const int period : {10, 17, 33, 42}) {  // 100, 60, 30 and 24 Hz
    CAPTURE(period);
    CHECK(find_stiffest(period, 1) == Approx(kDamping / (1.5 * period * kTick)).epsilon(0.05));
  }
  CHECK(find_stiffest(1, 0) == Approx(2.0 * kDamping / kTick).epsilon(0.05));
}

TEST_CASE(
    "of tissue a force held at 24 to 100 Hz is not passive, its local stiffness at 1 kHz is") {
  for (const int period : {10, 17, 33, 42}) {  // 100, 60, 30 and 24 Hz
    CAPTURE(period);
    SlowTissue held(period), local(period);
    CAPTURE(held.tissue.stiffness);
    // beyond what the slow ones allow, and within what 1 kHz does
    REQUIRE(held.tissue.stiffness > 1.5 * kDamping / (1.5 * period * kTick));
    REQUIRE(held.tissue.stiffness < 2.0 * kDamping / kTick);

    CHECK(swing_device([&](double x) { return held.ask(x).force; }, 1, 0, 5.0) > 3.0);
    const auto follow = [&](double x) {
      const SlowTissue::Answer answer = local.ask(x);
      return answer.force - answer.stiffness * (x - answer.place);
    };
    CHECK(swing_device(follow, 1, 0, 5.0) < 0.7);
  }
  PressedTissue full;
  CHECK(swing_device([&](double x) { return full.press(x) - full.rest_force; }, 1, 0, 5.0) < 0.7);
}
