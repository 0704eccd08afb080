// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/tick/press_scene.h"
#include "palpate/sim/dynamics/forces.h"
#include "palpate/sim/dynamics/private/laws.h"
#include "palpate/sim/grasp/private/tear.h"
#include "palpate/sim/model/build_solid.h"
#include "scenes/grasped.h"

// Links that instruments hold tear where they are stretched too far [contact: tear].

using namespace palpate;
using namespace palpate::testing;
using doctest::Approx;
using scenes::GraspingHand;

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

SoftBody make_surface(bool molecular) {
  const SurfaceMesh mesh = scenes::make_ellipsoid({0.030, 0.025, 0.020}, 2);
  const Material wall{.damping_ratio = 0.3, .wall_thickness = 0.003};
  SurfaceOptions options;
  options.fixed = {0};
  SoftBody body;
  body.tissue =
      molecular
          ? build_molecular(
                mesh, wall,
                {.bond_stiffness = 20.0, .bend_stiffness = 1e-5, .stretch_coupling = 1e-3}, options)
          : build_mass_spring(mesh, wall, 100.0, options);
  body.tear_stretch = 1.5;
  return body;
}

struct Kind {
  std::string name;
  SoftBody body;
};

std::vector<Kind> make_kinds() {
  const Tool pinch = scenes::make_grasper(0.5, 1.0);
  std::vector<Kind> kinds;
  kinds.push_back({"springs", make_surface(false)});
  kinds.push_back({"molecular", make_surface(true)});
  kinds.push_back({"prisms", scenes::make_grasped_wall(pinch, 500.0).bodies[0]});
  kinds.push_back({"solid", scenes::make_grasped_block(pinch, 500.0, build_solid).bodies[0]});
  for (Kind& kind : kinds) kind.body.tear_stretch = 1.5;
  return kinds;
}

/// All of the tissue stretched to `stretch`, and every particle shaken by a twentieth of a
/// millimetre, so that no force is zero by symmetry. Nothing moves.
State stretch_out(const TissueModel& tissue, double stretch) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  State state(tissue);
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const Vec3 shaken(part(random), part(random), part(random));
    state.position[i] = stretch * state.position[i] + 5e-5 * shaken;
  }
  return state;
}

/// Ticks in which all around a particle is watched, at one place.
void grow(int ticks, int particle, const TissueModel& tissue, const State& state, Tear& tear,
          Guard& guard) {
  static long tick = 0;
  for (int i = 0; i < ticks; ++i) {
    tear.begin_watch(++tick);
    tear.watch(particle);
    tear.grow(tissue, state.position, 1e-3, guard);
  }
}

Guard make_guard(const TissueModel& tissue) {
  Guard guard;
  guard.torn_links.assign(tissue.springs.ends.size() + tissue.bonds.ends.size(), 0);
  return guard;
}

/// A particle that is free, with the largest x.
int find_tip(const TissueModel& tissue) {
  int tip = -1;
  for (int i = 0; i < particle_count(tissue); ++i) {
    const bool held = std::ranges::find(tissue.fixed, i) != tissue.fixed.end();
    if (held) continue;
    if (tip < 0 || tissue.rest_position[at(i)].x() > tissue.rest_position[at(tip)].x()) tip = i;
  }
  return tip;
}

/// [N] Of springs, bonds, angles and prisms.
Vec3Array compute_links(const TissueModel& tissue, const State& state) {
  Vec3Array f(state.position.size(), Vec3::Zero());
  accumulate_link_forces(tissue.springs, tissue.damping_law, state.position, state.velocity, f);
  accumulate_link_forces(tissue.bonds, tissue.damping_law, state.position, state.velocity, f);
  accumulate_angle_forces(tissue.angles, state.position, f);
  accumulate_prism_forces(tissue.prisms, state.position, state.velocity, f);
  return f;
}

double find_largest(const Vec3Array& f) {
  double largest = 0.0;
  for (const Vec3& each : f) largest = std::max(largest, each.norm());
  return largest;
}

}  // namespace

TEST_CASE("a tick that is begun again watches again") {
  const SoftBody body = make_surface(false);
  const int tip = find_tip(body.tissue);
  Tear tear(body.tissue, body.tear_stretch);
  const auto watch = [&](long tick) {
    tear.begin_watch(tick);
    tear.watch(tip);
    int particles = 0;
    tear.for_each_particle([&](int) { ++particles; });
    return particles;
  };

  const int first = watch(7);

  CHECK(first > 0);
  CHECK(watch(7) == first);
  CHECK(watch(8) == first);
}

TEST_CASE("a spring tears after five ticks beyond its stretch, and fades over fifty") {
  const SoftBody body = make_surface(false);
  const TissueModel& tissue = body.tissue;
  const int tip = find_tip(tissue);
  Tear tear(body.tissue, body.tear_stretch);
  Guard guard = make_guard(tissue);
  State state(tissue);
  // one spring alone is too long
  const auto link = std::ranges::find_if(
      tissue.springs.ends, [tip](const auto& ends) { return ends[0] == tip || ends[1] == tip; });
  const std::size_t l = at(static_cast<int>(link - tissue.springs.ends.begin()));
  const int other = (*link)[0] == tip ? (*link)[1] : (*link)[0];
  const Vec3 along = state.position[at(other)] - state.position[at(tip)];
  state.position[at(other)] = state.position[at(tip)] + 1.6 * along;

  grow(4, tip, tissue, state, tear, guard);
  CHECK_FALSE(tear.has_torn());
  grow(1, tip, tissue, state, tear, guard);
  REQUIRE(tear.torn_count() >= 1);
  CHECK(guard.torn_links[l] == 1);

  // the fifth tick is the first of the fade
  for (int tick = 1; tick < 50; ++tick) {
    CHECK(tear.damage()[0] == Approx(tick / 50.0));
    grow(1, tip, tissue, state, tear, guard);
  }
  CHECK(tear.damage()[0] == 1.0);
  grow(10, tip, tissue, state, tear, guard);
  CHECK(tear.damage()[0] == 1.0);
}

TEST_CASE("a particle is as torn as the most torn part around it") {
  const SoftBody body = make_surface(false);
  const TissueModel& tissue = body.tissue;
  const int tip = find_tip(tissue);
  Tear tear(tissue, body.tear_stretch);
  Guard guard = make_guard(tissue);
  State state(tissue);
  std::vector<float> damage(state.position.size(), 0.5F);
  tear.write_damage(damage);
  CHECK(std::ranges::all_of(damage, [](float d) { return d == 0.0F; }));

  // all springs of the tip are too long, later those of another as well
  state.position[at(tip)] *= 3.0;
  grow(20, tip, tissue, state, tear, guard);
  REQUIRE(tear.torn_count() > 1);
  tear.write_damage(damage);
  for (int i = 0; i < static_cast<int>(damage.size()); ++i) {
    const bool beside = std::ranges::any_of(tissue.springs.ends, [&](const auto& ends) {
      return (ends[0] == i && ends[1] == tip) || (ends[1] == i && ends[0] == tip);
    });
    CHECK(damage[at(i)] == (i == tip || beside ? Approx(16.0 / 50.0) : Approx(0.0)));
  }
}

TEST_CASE("a spring that is too long for four ticks at a time does not tear") {
  const SoftBody body = make_surface(false);
  const int tip = find_tip(body.tissue);
  Tear tear(body.tissue, body.tear_stretch);
  Guard guard = make_guard(body.tissue);
  const State rest(body.tissue);
  State state = rest;
  state.position[at(tip)].x() += 0.02;
  for (int round = 0; round < 10; ++round) {
    grow(4, tip, body.tissue, state, tear, guard);
    grow(1, tip, body.tissue, rest, tear, guard);
  }
  // nor one that is let go of and grasped again each time
  for (int round = 0; round < 10; ++round) {
    grow(4, tip, body.tissue, state, tear, guard);
    grow(1, 0, body.tissue, rest, tear, guard);
  }

  CHECK_FALSE(tear.has_torn());
}

TEST_CASE("what has torn to its end bears nothing, whatever it is made of") {
  for (const Kind& kind : make_kinds()) {
    CAPTURE(kind.name);
    const TissueModel& tissue = kind.body.tissue;
    const int tip = find_tip(tissue);
    Tear tear(tissue, kind.body.tear_stretch);
    Guard guard = make_guard(tissue);
    const State state = stretch_out(tissue, 2.0);
    grow(60, tip, tissue, state, tear, guard);
    REQUIRE(tear.has_torn());
    CHECK(tear.damage()[0] == 1.0);

    // of the particle in the middle of it all has torn but the pillar of a wall, which is measured
    // by nobody, and no law but that of springs and bonds pulls here
    Vec3Array f = compute_links(tissue, state);
    if (!tissue.prisms.corners.empty()) {
      Vec3Array pillars(f.size(), Vec3::Zero());
      accumulate_link_forces(tissue.springs, tissue.damping_law, state.position, state.velocity,
                             pillars);
      for (std::size_t i = 0; i < f.size(); ++i) f[i] -= pillars[i];
    }
    const double before = f[at(tip)].norm();
    for (const auto& [particle, force] : tear.cancel(tissue, state.position)) {
      f[at(particle)] += force;
    }
    CHECK(before > 1e-3);
    CHECK(f[at(tip)].norm() < 1e-12 * find_largest(f) + 1e-12);
  }
}

TEST_CASE("what cancels a torn part is inner forces, the gradient of the energy it had") {
  for (const Kind& kind : make_kinds()) {
    CAPTURE(kind.name);
    const TissueModel& tissue = kind.body.tissue;
    Tear tear(tissue, kind.body.tear_stretch);
    Guard guard = make_guard(tissue);
    State state = stretch_out(tissue, 2.0);
    grow(20, find_tip(tissue), tissue, state, tear, guard);  // not to its end
    REQUIRE(tear.has_torn());

    // held particles are none of those that are pulled, so a tip away from them is looked at
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    double size = 0.0;
    const auto pulled = tear.cancel(tissue, state.position);
    const std::vector<ParticleForce> forces(pulled.begin(), pulled.end());
    for (const auto& [particle, force] : forces) {
      sum += force;
      moment += state.position[at(particle)].cross(force);
      size += force.norm();
    }
    CHECK(sum.norm() < 1e-12 * size);
    CHECK(moment.norm() < 1e-12 * size * 0.1);

    constexpr double kStep = 1e-8;
    for (const auto& [particle, force] : forces) {
      for (int axis = 0; axis < 3; ++axis) {
        double& x = state.position[at(particle)][axis];
        const double was = x;
        x = was + kStep;
        const double more = tear.compute_energy(state.position);
        x = was - kStep;
        const double less = tear.compute_energy(state.position);
        x = was;
        // the other way than the law pulls
        CHECK(force[axis] == Approx((more - less) / (2.0 * kStep)).epsilon(1e-4).scale(size));
      }
    }
  }
}

TEST_CASE("a stretch at which nothing could tear is refused, by name") {
  const auto refused = [](double stretch, SoftBody body, const std::string& part) {
    body.tear_stretch = stretch;
    try {
      check_tear(body.tissue, body.tear_stretch, "scene: tear_stretch");
    } catch (const std::invalid_argument& error) {
      const std::string said = error.what();
      return said.find("scene: tear_stretch: got") == 0 && said.find(part) != std::string::npos;
    }
    return false;
  };
  const SoftBody springs = make_surface(false);
  for (const double stretch : {-1.0, 0.5, 1.0, 10.5, std::nan(""), HUGE_VAL}) {
    CHECK(refused(stretch, springs, "1.01 to 10"));
  }
  SoftBody relaxing = springs;
  relaxing.tissue.maxwell.ratio = 0.5;
  CHECK(refused(1.5, relaxing, "relaxes"));
  const Tool pinch = scenes::make_grasper(0.5, 1.0);
  CHECK(refused(1.5, scenes::make_grasped_block(pinch, 500.0, build_linear_solid).bodies[0],
                "only springs"));
  CHECK_NOTHROW(check_tear(springs.tissue, springs.tear_stretch, "tear_stretch"));
  Scene scene = press_scene();
  scene.bodies[0].tear_stretch = 0.5;
  CHECK_THROWS_WITH_AS(build_scene(std::move(scene)), doctest::Contains("tear_stretch"),
                       std::invalid_argument);
}

namespace {

/// How a pull that went far ended.
struct Drawn {
  double peak = 0.0, last = 0.0, step = 0.0;  // [N]
  int torn = 0;
  AlarmKind alarm = AlarmKind::none;
  std::array<std::uint64_t, 2> hash{};

  void follow(double before, double now) {
    peak = std::max(peak, now);
    step = std::max(step, std::abs(now - before));
    last = now;
  }
  void end(const World& world) {
    torn = world.bodies[0].torn_count;
    alarm = world.alarm.kind;
    hash = compute_hash(world);
  }
};

/// Jaws close on the rim, go outwards and stay there.
Drawn draw_out(const Scene& scene, double way) {
  GraspingHand hand(scene);
  Drawn drawn;
  hand.close();
  hand.wait(0.3);
  double before = hand.force().norm();
  hand.after_tick = [&] { drawn.follow(before, hand.force().norm()), before = drawn.last; };
  hand.go(way, 0.3);
  hand.wait(0.3);
  drawn.end(hand.world());
  return drawn;
}

/// A ball takes hold at the pole of press_scene() and goes up by so far [m].
Drawn pull_up(const Scene& scene, double way) {
  World world(scene);
  HapticSample sample;
  Drawn drawn;
  double height = 0.033, before = 0.0;
  const auto go = [&](double to, int ticks, bool counts) {
    const double from = height;
    for (int i = 1; i <= ticks; ++i) {
      height = from + (to - from) * i / ticks;
      sample.position = Vec3(0.0, 0.0, height);
      const double now = tick(scene, sample, 1e-3, world).force.norm();
      if (counts) drawn.follow(before, now);
      before = now;
    }
  };
  go(0.021, 200, false);
  sample.buttons = kAttachButton;
  go(0.023, 300, false);
  go(0.023 + way, 500, true);
  go(height, 300, true);
  drawn.end(world);
  return drawn;
}

struct Pulled {
  std::string name;
  Scene scene;
};

/// The reference kernel takes half a minute for each pull; springs are enough to say that it knows
/// what has torn.
std::vector<Pulled> make_pulled() {
  const Tool pinch = scenes::make_grasper(0.8, 3.0), gentle = scenes::make_grasper(0.8, 0.3);
  std::vector<Pulled> all;
  all.push_back({"springs", scenes::make_grasped_slab(pinch, 500.0)});
  if (scenes::kernel_under_test() == Kernel::reference) return all;
  all.push_back({"prisms", scenes::make_grasped_wall(pinch, 500.0)});
  all.push_back({"solid", scenes::make_grasped_block(gentle, 500.0, build_solid)});
  return all;
}

}  // namespace

TEST_CASE("what is held and pulled too far tears, and is felt less and less") {
  Scene scene = press_scene();
  const Drawn whole = pull_up(scene, 0.02);
  scene.bodies[0].tear_stretch = 1.3;
  const Drawn torn = pull_up(scene, 0.02);

  CHECK(whole.torn == 0);
  CHECK(torn.torn > 0);
  CHECK(torn.alarm == AlarmKind::none);
  CHECK(torn.peak < 0.7 * whole.peak);
  CHECK(torn.last < 0.5 * torn.peak);  // what is left is of the home spring
  CHECK(torn.step < 0.06 * torn.peak);
  CHECK(pull_up(scene, 0.02).hash == torn.hash);  // to the bit
}

TEST_CASE("jaws that draw tissue too far tear it without an alarm, whatever it is made of" *
          doctest::test_suite("landing")) {
  for (Pulled& each : make_pulled()) {
    CAPTURE(each.name);
    const Drawn whole = draw_out(each.scene, 0.012);
    for (const double stretch : {1.2, 1.3}) {
      CAPTURE(stretch);
      each.scene.bodies[0].tear_stretch = stretch;
      const Drawn torn = draw_out(each.scene, 0.012);
      CHECK(whole.torn == 0);
      CHECK(torn.torn > 0);
      CHECK(torn.alarm == AlarmKind::none);
      CHECK(torn.hash != whole.hash);
      if (stretch == 1.2) CHECK(draw_out(each.scene, 0.012).hash == torn.hash);
    }
  }
}

TEST_CASE("tissue that is stretched less far than it bears is the same to the bit" *
          doctest::test_suite("landing")) {
  for (Pulled& each : make_pulled()) {
    CAPTURE(each.name);
    const Drawn whole = draw_out(each.scene, 0.001);
    each.scene.bodies[0].tear_stretch = 9.0;
    const Drawn same = draw_out(each.scene, 0.001);
    CHECK(same.torn == 0);
    CHECK(same.hash == whole.hash);
  }
}

TEST_CASE("a body that has torn all around what is held is no alarm, and so for as long as it is") {
  Scene scene = press_scene();
  scene.bodies[0].tear_stretch = 1.2;
  const Drawn far = pull_up(scene, 0.1);
  CHECK(far.torn > 0);
  CHECK(far.alarm == AlarmKind::none);
}
