// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "laws/linear_tissue.h"
#include "palpate/sim/device/simulated_devices.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/kernels.h"
#include "scenes/tissues.h"

// What the hand feels over time: it settles when held, it blows up where it must, and it never
// gives back more than it was given.

using namespace palpate;
using namespace palpate::laws;

namespace {

/// An organ and where it is touched: `touch` [m] on its surface at rest, `out` away from it.
struct Organ {
  std::string name;
  TissueModel tissue;
  Vec3 touch, out;
};

template <class Predicate>
std::vector<int> find_vertices(const SurfaceMesh& mesh, Predicate predicate) {
  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i) {
    if (predicate(mesh.vertices[static_cast<std::size_t>(i)])) found.push_back(i);
  }
  return found;
}

/// The mass-spring and the molecular model of one surface.
void add_both(const std::string& name, const SurfaceMesh& mesh, const Material& material,
              const SurfaceOptions& options, const Vec3& touch, const Vec3& out,
              std::vector<Organ>& organs) {
  const MolecularConstants constants{
      .bond_stiffness = 60.0, .bend_stiffness = 1e-4, .stretch_coupling = 1e-2};
  organs.push_back(
      {name + ", springs", build_mass_spring(mesh, material, 60.0, options), touch, out});
  organs.push_back(
      {name + ", molecular", build_molecular(mesh, material, constants, options), touch, out});
}

/// A closed solid, an open hollow tube and a sheet, 160 to 230 vertices each. The tip touches
/// between the vertices, as tips do. Drag as in tests/laws/test_contact.cpp: what rings on for
/// longer is the tissue, not the contact.
std::vector<Organ> make_organs() {
  std::vector<Organ> organs;
  SurfaceOptions options;
  options.drag = 30.0;
  options.home_stiffness = 1.5e5;
  const SurfaceMesh solid = scenes::make_organ_mesh(2);
  options.fixed = scenes::find_base(solid);
  add_both("solid", solid, {}, options, {0.001, 0.0015, 0.03}, Vec3::UnitZ(), organs);

  options.home_stiffness.reset();  // the builders' own, by the wall
  const SurfaceMesh tube = scenes::make_tube(0.015, 0.08, 18, 11);
  options.fixed = find_vertices(tube, [](const Vec3& x) { return x.z() < 0.001 || x.z() > 0.079; });
  add_both("tube", tube, {.wall_thickness = 0.003}, options, {0.015, 0.001, 0.041}, Vec3::UnitX(),
           organs);

  const SurfaceMesh sheet = scenes::make_sheet(15, 15, 0.1);
  options.fixed = find_vertices(sheet, [](const Vec3& x) {
    return std::min(x.x(), x.y()) < 0.001 || std::max(x.x(), x.y()) > 0.099;
  });
  add_both("sheet", sheet, {.wall_thickness = 0.003}, options, {0.051, 0.049, 0.0}, Vec3::UnitZ(),
           organs);
  return organs;
}

Scene make_scene(const Organ& organ, double coupling) {
  Scene scene;
  scene.bodies[0].kernel = scenes::kernel_under_test();
  scene.bodies[0].tissue = organ.tissue;
  scene.instruments[0].coupling.stiffness = coupling;
  return build_scene(std::move(scene));
}

/// [m] where the hand is when it is `depth` deeper than where the tip first touches.
Vec3 hand_at(const Organ& organ, double depth) {
  return organ.touch + (Tool{}.radius - depth) * organ.out;
}

struct Range {
  double low = 1e9, high = 0.0, sum = 0.0;
  int count = 0;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
    sum += value;
    ++count;
  }
  double mean() const { return sum / count; }
};

/// [N] the force while the hand stays at `depth` for 2 s after it came there in 0.3 s, from 0.5 s
/// of these on. Attached from there on, and pulled out by `pull` [m], if that is more than 0.
Range hold(const Scene& scene, const Organ& organ, double depth, double pull, Alarm& alarm) {
  std::vector<KeyFrame> frames = {{0.0, hand_at(organ, -0.01), 0}, {0.3, hand_at(organ, depth), 0}};
  if (pull > 0.0) {
    frames.push_back({0.5, hand_at(organ, depth), kAttachButton});
    frames.push_back({0.8, hand_at(organ, -pull), kAttachButton});
  }
  ScriptedDevice hand(frames);
  const int still = static_cast<int>(std::lround(hand.duration() * scene.rate));
  World world(scene);
  world.recovers = false;  // the limit of the scene as it is
  Range range;
  for (int i = 0; i < still + 2000; ++i) {
    const double force =
        tick(scene, hand.read(i / scene.rate), 1.0 / scene.rate, world).force.norm();
    if (i >= still + 500) range.add(force);
  }
  alarm = world.alarm;
  return range;
}

/// 4 - 2 dt C - dt² (K + coupling at free particle p) is positive [motion: step].
bool is_stable(const LinearTissue& tissue, double dt, double coupling, int p) {
  const Eigen::Index n = tissue.stiffness.rows();
  MatrixXd rest =
      4.0 * MatrixXd::Identity(n, n) - 2.0 * dt * tissue.damping - dt * dt * tissue.stiffness;
  for (int axis = 0; axis < 3; ++axis) {
    const double root = tissue.root_mass[3 * p + axis];
    rest(3 * p + axis, 3 * p + axis) -= dt * dt * coupling / (root * root);
  }
  return Eigen::LLT<MatrixXd>(rest).info() == Eigen::Success;
}

/// [s] the exact limit of the step, with the whole coupling on the particle next to the touch.
double find_limit(const LinearTissue& tissue, const Organ& organ, double coupling) {
  const auto distance = [&](int particle) {
    return (organ.tissue.rest_position[static_cast<std::size_t>(particle)] - organ.touch).norm();
  };
  const auto nearest = std::min_element(tissue.particles.begin(), tissue.particles.end(),
                                        [&](int a, int b) { return distance(a) < distance(b); });
  const int p = static_cast<int>(nearest - tissue.particles.begin());
  double stable = 0.0, unstable = 0.1;
  while (unstable - stable > 1e-4 * unstable) {
    const double middle = 0.5 * (stable + unstable);
    (is_stable(tissue, middle, coupling, p) ? stable : unstable) = middle;
  }
  return stable;
}

/// The scene with a single substep of `dt` [s], whatever the tissue needs.
Scene with_one_substep(Scene scene, double dt) {
  scene.rate = 1.0 / dt;
  scene.bodies[0].substeps = scene.bodies[0].substeps_max = 1;
  return scene;
}

}  // namespace

TEST_CASE("a hand held still in any organ, at any depth and coupling, feels a force that settles" *
          doctest::test_suite("landing")) {
  for (const Organ& organ : make_organs()) {
    for (const double coupling : {200.0, 500.0, 1000.0}) {
      const Scene scene = make_scene(organ, coupling);
      for (const double depth : {0.002, 0.005, 0.010}) {
        CAPTURE(organ.name);
        CAPTURE(coupling);
        CAPTURE(depth);
        Alarm alarm;
        const Range force = hold(scene, organ, depth, 0.0, alarm);

        CHECK_FALSE(alarm);
        CHECK(force.low > 0.005);
        CHECK(force.high - force.low < 0.01 * force.mean());
      }
    }
  }
}

TEST_CASE("a patch pulled out of any organ and held there feels a force that settles") {
  for (const Organ& organ : make_organs()) {
    CAPTURE(organ.name);
    const Scene scene = make_scene(organ, 500.0);
    Alarm alarm;
    const Range force = hold(scene, organ, 0.003, 0.006, alarm);

    CHECK_FALSE(alarm);
    CHECK(force.low > 0.02);
    CHECK(force.high - force.low < 0.01 * force.mean());
  }
}

TEST_CASE("a deeper press and a stiffer coupling are felt harder") {
  for (const Organ& organ : make_organs()) {
    CAPTURE(organ.name);
    Alarm alarm;
    const double base = hold(make_scene(organ, 500.0), organ, 0.005, 0.0, alarm).mean();
    const double deeper = hold(make_scene(organ, 500.0), organ, 0.010, 0.0, alarm).mean();
    const double stiffer = hold(make_scene(organ, 1000.0), organ, 0.005, 0.0, alarm).mean();

    CHECK(deeper > 1.5 * base);
    CHECK(stiffer > base);
  }
}

TEST_CASE("with its substeps removed a tissue diverges where the prediction says so, only there") {
  int diverging_at_1_kHz = 0;
  for (const Organ& organ : make_organs()) {
    CAPTURE(organ.name);
    const Scene scene = make_scene(organ, 200.0);
    const LinearTissue linear(organ.tissue);
    const double at_rest = find_limit(linear, organ, 0.0);
    const double touched = find_limit(linear, organ, scene.instruments[0].coupling.stiffness);
    Alarm alarm;

    hold(with_one_substep(scene, 1.1 * at_rest), organ, 0.005, 0.0, alarm);
    CHECK(alarm);
    hold(with_one_substep(scene, 0.8 * touched), organ, 0.005, 0.0, alarm);
    CHECK_FALSE(alarm);

    if (at_rest < 0.95e-3) {
      ++diverging_at_1_kHz;
      hold(with_one_substep(scene, 1e-3), organ, 0.005, 0.0, alarm);
      CHECK(alarm);
      hold(scene, organ, 0.005, 0.0, alarm);
      CHECK_FALSE(alarm);
    }
  }
  CHECK(diverging_at_1_kHz >= 2);
}

TEST_CASE("pressing and letting go never gives the hand more than it put in") {
  for (const Organ& organ : make_organs()) {
    for (const double duration : {0.2, 1.0}) {
      CAPTURE(organ.name);
      CAPTURE(duration);
      const Scene scene = make_scene(organ, 500.0);
      const Vec3 above = hand_at(organ, -0.005), below = hand_at(organ, 0.008);
      ScriptedDevice hand({{0.0, above, 0}, {0.5 * duration, below, 0}, {duration, above, 0}});
      World world(scene);
      double work = 0.0, put_in = 0.0;
      Vec3 last_force = Vec3::Zero(), last_position = above;
      for (int i = 0; i <= std::lround(1000.0 * duration); ++i) {
        const HapticSample sample = hand.read(1e-3 * i);
        const Vec3 force = tick(scene, sample, 1e-3, world).force;
        // the force while the hand moves from the last tick to this one is between theirs
        work -= 0.5 * (last_force + force).dot(sample.position - last_position);
        put_in = std::max(put_in, work);
        last_force = force;
        last_position = sample.position;
      }

      CHECK_FALSE(world.alarm);
      CHECK(last_force == Vec3::Zero());
      CHECK(put_in > 1e-4);
      CHECK(work > 0.0);
    }
  }
}
