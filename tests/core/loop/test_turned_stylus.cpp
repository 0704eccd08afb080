// SPDX-License-Identifier: BSD-3-Clause
// The device's gimbal and button reach the instrument: a hand turns the stylus of the simulated arm
// and presses its button; what sensors, firmware, wire and driver make of that holds a grasper,
// which takes hold of a slab and is drawn back by it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/arm/turning_hand.h"
#include "palpate/sim/arm/simulated_arm.h"
#include "palpate/sim/device/safe_device.h"
#include "palpate/sim/tick/tick.h"
#include "scenes/grasped.h"

using namespace palpate;

namespace {

constexpr double kTick = 1e-3;          // [s]
constexpr double kRim = 0.03;           // [m] height of the slab's rim
constexpr double kGrip = 3.0;           // [N]
constexpr double kClosePerTick = 0.01;  // [rad] of jaws that a button closes

/// Springs, by a hand of 5 N.
Scene make_slab_scene(const SurfaceMesh& mesh, const Tool& tool, double coupling) {
  return scenes::make_grasped_mesh(mesh, tool, coupling, 3e6, 100.0, 5.0);
}

SurfaceMesh make_flat_slab() { return scenes::make_slab({kRim, 0.03, 0.004}, 0.0015); }

/// With the rim up: jaws that open along y take it from above.
Scene make_upright_slab() {
  SurfaceMesh mesh = make_flat_slab();
  for (Vec3& x : mesh.vertices) x = Vec3(x.y(), x.z(), x.x());
  return make_slab_scene(mesh, scenes::make_grasper(0.5, kGrip), 150.0);
}

/// 0 before `from`, 1 after `to`, without a jerk between.
double rise(double time, double from, double to) {
  const double u = std::clamp((time - from) / (to - from), 0.0, 1.0);
  return u * u * u * (10.0 + u * (6.0 * u - 15.0));
}

Quaternion turn_about(double angle, const Vec3& axis) {
  return Quaternion(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// Closes and opens in the air, turns upright, goes down over the rim, closes on it, draws and
/// turns it, lets go, goes up.
HapticSample grasp_rim(double time) {
  HapticSample hand;
  hand.position.z() = kRim + 0.02 - 0.032 * rise(time, 1.0, 1.3) + 0.003 * rise(time, 1.9, 2.3) +
                      0.029 * rise(time, 2.8, 3.1);
  hand.orientation = turn_about(0.25 * rise(time, 1.9, 2.3), Vec3::UnitZ()) *
                     turn_about(0.8 * (1.0 - rise(time, 0.3, 0.9)), {1.0, -0.5, 0.8});
  const bool in_air = time > 0.1 && time < 0.2;
  const bool on_rim = time > 1.4 && time < 2.6;
  if (in_air || on_rim) hand.buttons = kAttachButton;
  return hand;
}

/// Lays a shaft on the slab, strokes with it and turns it about the upright axis.
HapticSample stroke_slab(double time) {
  HapticSample hand;
  hand.position = {0.005 * std::sin(6.0 * time), -0.01,
                   kRim + 0.012 - 0.0115 * rise(time, 1.0, 1.5)};
  hand.orientation = turn_about(0.1 * std::sin(5.0 * time), Vec3::UnitZ()) *
                     turn_about(-0.5 * std::numbers::pi, Vec3::UnitX());
  return hand;
}

/// What the world was after each tick.
struct Seen {
  std::vector<HapticSample> samples;
  std::vector<Quaternion> orientation;
  std::vector<double> jaw_angle, pinch;
  Vec3Array force;
  std::vector<bool> pinches;
};

/// The hand of `move` on the simulated arm, with the orientation that the arm tells or, without its
/// gimbal, as the hand has it.
Seen play(const Scene& scene, HapticSample (*move)(double), const Plant& plant = {},
          bool gimbal = true) {
  TurningHand hand(move);
  SimulatedArm arm(hand, Vec3(0.0, 0.0, kRim), plant);
  arm.open();
  SafeDevice safe(arm, find_safety_limits(arm.driver().calibration()));
  World world(scene);
  const ToolState& tool = world.instruments[0].tool;
  Seen seen;
  for (int k = 0; k < 3200; ++k) {
    HapticSample sample = safe.read(k * kTick);
    if (!gimbal) sample.orientation = move(k * kTick).orientation;
    const HapticCommand command = tick(scene, sample, kTick, world);
    safe.set_tool(tool.position);
    safe.write(command);
    seen.samples.push_back(sample);
    seen.orientation.push_back(tool.orientation);
    seen.jaw_angle.push_back(tool.jaw_angle);
    seen.pinch.push_back(tool.pinch);
    seen.pinches.push_back(tool.pinches);
    seen.force.push_back(safe.sent().force);
  }
  CHECK(world.alarm.kind == AlarmKind::none);
  CHECK(safe.fault() == DeviceFault::none);
  CHECK(arm.motors() == MotorState::on);
  return seen;
}

/// Of the plant as it is designed, once for all tests.
const Seen& see_grasp() {
  static const Seen seen = play(make_upright_slab(), grasp_rim);
  return seen;
}

std::size_t at(double time) { return static_cast<std::size_t>(std::lround(time / kTick)); }

/// The tick with which the button has come through the wire, at or after `time` [s].
std::size_t find_button(const Seen& seen, double time, bool pressed) {
  std::size_t k = at(time);
  while (k + 1 < seen.samples.size() && (seen.samples[k].buttons == kAttachButton) != pressed) ++k;
  return k;
}

}  // namespace

TEST_CASE("an instrument is turned as the stylus is, as far as the gimbal's sensors tell") {
  const Plant plant;
  const Seen& seen = see_grasp();
  // half a count of yaw, forearm and the three of the gimbal
  const double resolution = plant.count + 1.5 * plant.gimbal_count;
  double worst = 0.0, held = 0.0, farthest = 0.0;
  for (std::size_t k = 1; k < seen.samples.size(); ++k) {
    const Quaternion wanted = grasp_rim((double(k) - 1.0) * kTick).orientation;
    const double off = seen.orientation[k].angularDistance(wanted);
    if (k < at(1.4)) worst = std::max(worst, off);
    if (k > at(2.4) && k < at(2.6)) held = std::max(held, off);
    farthest = std::max(farthest, wanted.angularDistance(Quaternion::Identity()));
  }
  MESSAGE("free: off by ", worst, " rad at most, in tissue ", held, ", of ", farthest);
  CHECK(farthest > 0.79);
  CHECK(worst < resolution + 4e-3);  // and a millisecond of what it turns
  CHECK(held < resolution + 4e-3);
}

TEST_CASE("the stylus' button closes and opens the jaws, which take hold of tissue and feel it") {
  const Seen& seen = see_grasp();
  const double open = Jaws{}.open;
  const std::size_t closed = find_button(seen, 0.1, true), opened = find_button(seen, 0.2, false);
  CHECK(closed < at(0.1) + 5);  // a report and what it waited for
  CHECK(seen.jaw_angle[closed - 1] == doctest::Approx(open));
  for (std::size_t n = 1; n < 50; n += 7) {
    CHECK(seen.jaw_angle[closed + n - 1] == doctest::Approx(open - kClosePerTick * double(n)));
  }
  CHECK(seen.jaw_angle[closed + 53] == 0.0);
  CHECK(seen.jaw_angle[opened + 80] == doctest::Approx(open));
  CHECK_FALSE(seen.pinches[at(0.19)]);

  // on the rim: 4 mm between the jaws, which hold it with their grip
  const std::size_t grasped = find_button(seen, 1.4, true);
  CHECK(grasped < at(1.4) + 5);
  CHECK(seen.jaw_angle[grasped + 19] == doctest::Approx(open - kClosePerTick * 20));
  CHECK(seen.pinches[at(1.8)]);
  CHECK(seen.pinch[at(1.8)] == doctest::Approx(kGrip).epsilon(0.2));
  CHECK(seen.jaw_angle[at(1.8)] < 0.2);
  CHECK(seen.jaw_angle[at(1.8)] > 0.01);
  // drawn up, the slab draws the hand down
  CHECK(seen.pinches[at(2.5)]);
  MESSAGE("held with ", seen.pinch[at(2.5)], " N, felt ", seen.force[at(2.5)].z(), " N");
  CHECK(seen.force[at(2.5)].z() < -0.1);

  const std::size_t let_go = find_button(seen, 2.6, false);
  CHECK(let_go < at(2.6) + 5);
  CHECK_FALSE(seen.pinches[at(2.8)]);
  CHECK(seen.jaw_angle[at(3.1)] == doctest::Approx(open));
  CHECK(seen.force.back() == Vec3::Zero());
}

TEST_CASE("counts of the gimbal shake what is felt no more than an exact orientation would") {
  const auto find_step = [](const Seen& seen, double from, double to) {
    double sum = 0.0;
    for (std::size_t k = at(from); k < at(to); ++k) {
      sum += (seen.force[k + 1] - seen.force[k]).squaredNorm();
    }
    return std::sqrt(sum / double(at(to) - at(from)));
  };
  Plant noisy;
  noisy.noise = 0.3;
  for (const Plant& plant : {Plant{}, noisy}) {
    const Scene slab = make_upright_slab();
    const Seen counted = plant.noise > 0.0 ? play(slab, grasp_rim, plant) : see_grasp();
    const Seen exact = play(slab, grasp_rim, plant, false);
    const double held = find_step(counted, 2.4, 2.59);
    const double turned = find_step(counted, 1.9, 2.3);
    MESSAGE("jaws, noise of ", plant.noise, " counts: steps of ", held, " N held, ", turned,
            " N turned");
    CHECK(held < 1.1 * find_step(exact, 2.4, 2.59) + 1e-4);
    CHECK(turned < 1.1 * find_step(exact, 1.9, 2.3));
  }

  // a shaft along tissue, whose ends turning moves most
  SurfaceMesh mesh = make_flat_slab();
  for (Vec3& x : mesh.vertices) x += Vec3(-0.5 * kRim, 0.0, kRim);
  const Tool shaft{.radius = 0.0025, .capsules = {{Vec3::Zero(), {0.0, 0.0, 0.02}}}};
  const Scene flat = make_slab_scene(mesh, shaft, 500.0);
  const double counted = find_step(play(flat, stroke_slab), 1.6, 3.1);
  const double exact = find_step(play(flat, stroke_slab, {}, false), 1.6, 3.1);
  MESSAGE("shaft: steps of ", counted, " N, of ", exact, " N with an exact orientation");
  CHECK(exact > 1e-3);
  CHECK(counted < 1.1 * exact);
}
