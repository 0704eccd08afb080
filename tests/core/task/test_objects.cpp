// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/task/staged_world.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

constexpr double kStone = 0.004;  // [m] the radius of its two spheres,
constexpr double kApart = 0.002;  // [m] each so far from its middle along x
constexpr int kGrasper = 0, kScope = 1;

/// The sheet in z = 0, a stone 20 mm over its middle, a plate far off, a grasper and a scope whose
/// lens is its position and looks along -z.
Scene stone_scene() {
  Scene scene = sheet_scene();
  scene.bodies[0].substeps = scene.bodies[0].substeps_max = 0;
  RigidBody stone;
  stone.sphere_centres = {{-kApart, 0.0, 0.0}, {kApart, 0.0, 0.0}};
  stone.sphere_radii = {kStone, kStone};
  stone.mass = 1e-3;
  stone.inertia = Vec3::Constant(1e-8);
  stone.position = {0.02, 0.02, 0.02};
  scene.rigid = {stone};
  Scenery plate;
  plate.mesh.vertices = {{0.1, 0.0, 0.03}, {0.14, 0.0, 0.03}, {0.12, 0.04, 0.03}};
  plate.mesh.triangles = {{0, 1, 2}};
  scene.scenery = {plate};
  Instrument grasper;
  grasper.tool.radius = 0.001;
  grasper.tool.friction = 0.5;
  grasper.tool.capsules = {{{0, 0.001, 0}, {0, 0.001, 0.02}}, {{0, -0.001, 0}, {0, -0.001, 0.02}}};
  grasper.tool.jaws = Jaws{};
  Instrument scope;
  scope.tool.capsules = {{{0, 0, 0}, {0, 0, 0.02}}};
  scene.instruments = {grasper, scope};
  return build_scene(std::move(scene));
}

Task stone_task(TaskStep step) {
  Task task;
  task.places = {region_of({12}),
                 {.kind = PlaceKind::object, .body = 0},
                 {.kind = PlaceKind::space, .points = {{0.02, 0.02, 0.02}}, .radius = 0.01}};
  task.cameras = {{.instrument = kScope, .field_of_view = std::numbers::pi / 2.0}};
  task.steps = {step};
  task.time_limit = 60.0;
  return task;
}

/// Judges ticks of both instruments, of which nothing is felt.
class StagedStone : public StagedWorld {
 public:
  explicit StagedStone(Task asked) : StagedWorld(std::move(asked), stone_scene()) {
    world.instruments[kScope].tool.placed = true;
    look_from({0.02, 0.02, 0.06});
  }

  void look_from(const Vec3& at) { world.instruments[kScope].tool.position = at; }
  void put_stone(const Vec3& at) { world.rigid[0].position = at; }

  /// Jaws stick to triangle 0 of the stone, one or both.
  void pinch_stone(int jaws) {
    ToolState& tool = world.instruments[kGrasper].tool;
    tool.anchor_count = jaws;
    tool.pinches = jaws == 2;
    for (int j = 0; j < jaws; ++j) {
      ToolState::Anchor& anchor = tool.anchors[static_cast<std::size_t>(j)];
      anchor = {};
      anchor.body = 2;  // the sheet, the plate, the stone
      anchor.jaw = j;
      anchor.weights = Vec3::UnitX();
      anchor.stiffness = 100.0;
    }
  }

  void judge(int ticks = 1) {
    const HapticSample samples[2];
    const HapticCommand commands[2];
    for (int t = 0; t < ticks; ++t) {
      ++world.tick_count;
      palpate::judge(task, world, samples, commands, kTick, progress);
    }
  }
};

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

/// The sentence with which a task is refused.
std::string refusal_of(const Scene& scene, const Task& task) {
  try {
    build_task(scene, task);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "not refused";
}

std::string refusal(const std::function<void(Task&)>& change) {
  Task task = stone_task({.verb = TaskVerb::look, .instrument = kScope, .place = 1});
  change(task);
  return refusal_of(stone_scene(), task);
}

}  // namespace

TEST_CASE("a stone is held where both jaws stick to it, and let go once they do not") {
  Task task = stone_task({.verb = TaskVerb::grasp, .place = 1, .duration = 0.01});
  task.steps.push_back({.verb = TaskVerb::release, .after = {0}});
  task.limits = {{.measure = TaskMeasure::loose, .place = 1, .during = {1}}};
  StagedStone staged(task);

  staged.pinch_stone(1);
  staged.judge(50);
  CHECK(staged.step(0).dwell == 0.0);

  staged.pinch_stone(2);
  staged.judge(11);
  CHECK(staged.is_done(0));
  CHECK_FALSE(staged.is_done(1));  // what is between the jaws is held, though it is no tissue
  CHECK(staged.limit(0).count == 0);

  staged.pinch_stone(0);
  staged.judge(2);
  CHECK(staged.is_done(1));
}

TEST_CASE("a stone that slips out of the jaws is loose, once each time") {
  Task task = stone_task({.verb = TaskVerb::carry, .place = 1, .space = 2});
  task.places[2].points[0] = {1.0, 1.0, 1.0};
  task.limits = {{.measure = TaskMeasure::loose, .place = 1}};
  StagedStone staged(task);

  for (int time = 0; time < 2; ++time) {
    staged.pinch_stone(2);
    staged.judge(200);
    staged.pinch_stone(time);
    staged.judge(19);
    CHECK(staged.limit(0).count == time);  // a gap of a moment is none
    staged.judge(100);
    CHECK(staged.limit(0).count == time + 1);
  }
  CHECK(staged.progress.state.errors == 2);
}

TEST_CASE("what is held and moved has gone as far as it has been moved") {
  Task task = stone_task({.verb = TaskVerb::carry, .place = 1, .space = 2});
  task.places[2].points[0] = {1.0, 1.0, 1.0};
  task.limits = {{.measure = TaskMeasure::distance, .bound = 0.0125, .duration = 0.0}};
  StagedStone staged(task);
  staged.pinch_stone(2);

  staged.put_stone(Vec3(0.02, 0.02, 0.02) + Vec3(0.0, 0.0, 0.012));
  staged.judge();
  CHECK(staged.limit(0).count == 0);
  staged.put_stone(Vec3(0.02, 0.02, 0.02) + Vec3(0.0, 0.012, 0.005));  // 13 mm
  staged.judge();
  CHECK(staged.limit(0).count == 1);
  CHECK(staged.limit(0).worst == doctest::Approx(0.013));
}

TEST_CASE("a stone is removed once all of it is out of the space, carried once its middle is in") {
  // spheres of 4 mm, 2 mm off the middle along x, and a space of 10 mm: out along x at 16 mm,
  // along y where sqrt(y² + 2²) = 14, at 13.856 mm
  StagedStone staged(stone_task({.verb = TaskVerb::remove, .place = 1, .space = 2}));
  const Vec3 middle(0.02, 0.02, 0.02);
  staged.judge();
  staged.put_stone(middle + Vec3(0.0159, 0, 0));
  staged.judge();
  staged.put_stone(middle + Vec3(0, 0.0138, 0));
  staged.judge();
  CHECK_FALSE(staged.is_done(0));
  staged.put_stone(middle + Vec3(0, 0.0139, 0));
  staged.judge();
  CHECK(staged.is_done(0));

  StagedStone carried(stone_task({.verb = TaskVerb::carry, .place = 1, .space = 2}));
  carried.put_stone(middle + Vec3(0, 0, 0.0101));
  carried.judge();
  CHECK_FALSE(carried.is_done(0));
  carried.put_stone(middle + Vec3(0, 0, 0.0099));
  carried.judge();
  CHECK(carried.is_done(0));
}

TEST_CASE("a stone is looked at in the middle of the picture, where tissue does not hide it") {
  // the whole angle is 90 degrees, so from 40 mm the picture is 40 mm to its rim, its half 20 mm
  StagedStone staged(stone_task({.verb = TaskVerb::look,
                                 .instrument = kScope,
                                 .place = 1,
                                 .distance = {.most = 0.05},
                                 .duration = 0.01}));
  staged.look_from({0.02 + 0.0201, 0.02, 0.06});  // beside the middle
  staged.judge(20);
  CHECK(staged.step(0).dwell == 0.0);
  staged.look_from({0.02, 0.02, 0.0701});  // too far
  staged.judge(20);
  CHECK(staged.step(0).dwell == 0.0);
  staged.look_from({0.02, 0.02, 0.01});  // behind the lens
  staged.judge(20);
  CHECK(staged.step(0).dwell == 0.0);
  staged.put_stone({0.02, 0.02, -0.02});  // behind the sheet
  staged.look_from({0.02, 0.02, 0.01});
  staged.judge(20);
  CHECK(staged.step(0).dwell == 0.0);
  staged.put_stone({0.0 - kApart, 0.02, -0.02});  // half of it behind its edge
  staged.look_from({0.0 - kApart, 0.02, 0.01});
  staged.judge(20);
  CHECK(staged.is_done(0));

  StagedStone free(stone_task({.verb = TaskVerb::look, .instrument = kScope, .place = 1}));
  free.look_from({0.02 + 0.0199, 0.02, 0.06});
  free.judge();
  CHECK(free.is_done(0));
}

TEST_CASE("a region and a space are looked at as well, and a plate hides them") {
  StagedStone region(stone_task({.verb = TaskVerb::look, .instrument = kScope, .place = 0}));
  CHECK(region.task.places[0].seen == std::vector<int>{12});
  region.judge();
  CHECK(region.is_done(0));

  Task task = stone_task({.verb = TaskVerb::look, .instrument = kScope, .place = 2});
  task.places[2].points[0] = {0.12, 0.02, 0.02};  // under the plate
  StagedStone space(task);
  space.look_from({0.12, 0.02, 0.06});
  space.judge();
  CHECK_FALSE(space.is_done(0));
  space.look_from({0.12, 0.02, 0.029});
  space.judge();
  CHECK(space.is_done(0));
}

TEST_CASE("a tip that the camera does not see is out of view: beside the picture, or hidden") {
  Task task = stone_task({.verb = TaskVerb::carry, .place = 1, .space = 2});
  task.places[2].points[0] = {1.0, 1.0, 1.0};
  task.limits = {{.measure = TaskMeasure::out_of_view, .instrument = kGrasper, .duration = 0.1}};
  CHECK(watches_sight(build_task(stone_scene(), task)));
  StagedStone staged(task);
  Vec3& tip = staged.world.instruments[kGrasper].tool.position;

  tip = {0.02 + 0.0299, 0.02, 0.03};  // in the picture, whose rim is 30 mm off there
  staged.judge(300);
  CHECK(staged.limit(0).count == 0);
  tip = {0.02 + 0.0301, 0.02, 0.03};
  staged.judge(101);
  CHECK(staged.limit(0).count == 1);
  tip = {0.02, 0.02, 0.03};
  staged.judge(150);
  CHECK_FALSE(staged.limit(0).open);
  tip = {0.02, 0.02, -0.01};  // behind the sheet
  staged.judge(101);
  CHECK(staged.limit(0).count == 2);

  task.places.push_back({.kind = PlaceKind::space, .points = {{0.02, 0.02, 0.0}}, .radius = 0.02});
  task.limits[0].place = 3;
  StagedStone inside(task);
  Vec3& end = inside.world.instruments[kGrasper].tool.position;
  end = {0.02, 0.02, -0.0201};  // not seen, but not where that matters
  inside.judge(300);
  CHECK(inside.limit(0).count == 0);
  end = {0.02, 0.02, -0.0199};
  inside.judge(101);
  CHECK(inside.limit(0).count == 1);
}

TEST_CASE("tissue pushes an object with a force, and what is pushed beside it is stretched") {
  Task task = stone_task({.verb = TaskVerb::carry, .place = 1, .space = 2});
  task.places[2].points[0] = {1.0, 1.0, 1.0};
  task.limits = {{.measure = TaskMeasure::object_force, .place = 1, .bound = 0.49, .duration = 0.0},
                 {.measure = TaskMeasure::strain, .place = 1, .bound = 0.19, .duration = 0.0}};
  StagedStone staged(task);
  staged.world.rigid[0].tissue_force = {0.3, 0.0, 0.4};
  staged.put_stone({0.02, 0.02, 0.005});
  // the middle vertex bears an external force, and its neighbours are 10 mm off: 6.6332 mm aside is
  // a stretch of sqrt(100 + 44) / 10 = 1.2
  staged.world.bodies[0].load.add({0, Vec3::UnitX(), Vec3(0, 0, -0.1)});
  const auto corner = static_cast<std::size_t>(staged.task.surfaces[0].triangles[0][0]);
  staged.world.bodies[0].tissue.position[corner].z() -= 0.0066332;
  staged.put_stone(staged.world.bodies[0].tissue.position[corner] + Vec3(0, 0, kStone));

  staged.judge();

  CHECK(staged.limit(0).worst == doctest::Approx(0.5));
  CHECK(staged.limit(1).count == 1);
  CHECK(staged.limit(1).worst > 0.1999);

  StagedStone apart(task);
  apart.world.bodies[0].load.add({0, Vec3::UnitX(), Vec3(0, 0, -0.1)});
  apart.world.bodies[0].tissue.position[corner].z() -= 0.0066332;
  apart.put_stone({0.02, 0.02, 0.05});
  apart.judge();
  CHECK(apart.limit(1).count == 0);
}

TEST_CASE("a task at what cannot be there is refused") {
  const std::pair<std::function<void(Task&)>, const char*> refused[] = {
      {[](Task& t) { t.places[1].body = 1; }, "task: places[1].body: got 1, expected 0 to 0"},
      {[](Task& t) { t.places[2].points.clear(); },
       "places[2].points: got 0, expected 1 of a space"},
      {[](Task& t) { t.places[2].radius = 0.0; }, "places[2].radius: got 0"},
      {[](Task& t) { t.steps[0].instrument = kGrasper; }, "got one without a camera"},
      {[](Task& t) { t.cameras[0].instrument = 2; }, "task: cameras[0].instrument: got 2"},
      {[](Task& t) { t.cameras[0].field_of_view = 4.0; }, "cameras[0].field_of_view: got 4"},
      {[](Task& t) {
         t.cameras[0].forward = {0, 0, 2};
       },
       "cameras[0].forward: got 2"},
      {[](Task& t) { t.steps[0].verb = TaskVerb::touch; }, "steps[0].place: got an object"},
      {[](Task& t) { t.steps[0] = {.verb = TaskVerb::pull, .place = 2}; },
       "steps[0].place: got a space"},
      {[](Task& t) { t.steps[0] = {.verb = TaskVerb::carry, .place = 1}; },
       "steps[0].space: got -1"},
      {[](Task& t) { t.steps[0] = {.verb = TaskVerb::carry, .place = 1, .space = 0}; },
       "steps[0].space: got a region, expected a space"},
      {[](Task& t) { t.steps[0] = {.verb = TaskVerb::remove, .place = 0, .space = 2}; },
       "steps[0].place: got no object"},
      {[](Task& t) { t.steps[0].space = 2; }, "steps[0].space: got 2"},
      {[](Task& t) { t.limits = {{.measure = TaskMeasure::loose, .place = 2}}; },
       "limits[0].place: got a space, expected an object"},
      {[](Task& t) {
         t.limits = {{.measure = TaskMeasure::loose, .instrument = kScope, .place = 1}};
       },
       "limits[0].instrument: got one without jaws"},
      {[](Task& t) { t.limits = {{.measure = TaskMeasure::object_force, .bound = 1.0}}; },
       "limits[0].place: got -1"},
      {[](Task& t) { t.limits = {{.measure = TaskMeasure::out_of_view, .place = 1}}; },
       "limits[0].place: got an object, expected a space or none"},
      {[](Task& t) { t.limits = {{.measure = TaskMeasure::out_of_view, .instrument = kScope}}; },
       "limits[0].instrument: got the one that sees, expected one that another sees"},
      {[](Task& t) { t.limits = {{.measure = TaskMeasure::out_of_view, .above = false}}; },
       "true: what is not seen is what can be wrong"},
      {[](Task& t) {
         t.steps[0] = {.verb = TaskVerb::grasp, .place = 1};
         t.cameras.clear();
         t.limits = {{.measure = TaskMeasure::out_of_view}};
       },
       "no instrument sees"},
      {[](Task& t) { t.limits = {{.measure = TaskMeasure::contact, .place = 1}}; },
       "limits[0].place: got an object, expected a place on a tissue"},
  };
  for (const auto& [change, sentence] : refused) {
    const std::string said = refusal(change);
    CHECK_MESSAGE(contains(said, sentence), said);
  }
  Task task = stone_task({.verb = TaskVerb::grasp, .place = 1});
  task.cameras.clear();
  CHECK(contains(refusal_of(sheet_scene(), task), "got an object"));
}
