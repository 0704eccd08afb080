// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "palpate/sim/base/types.h"
#include "palpate/sim/device/device.h"
#include "palpate/sim/tick/scene.h"
#include "palpate/sim/tick/tick_log.h"
#include "palpate/sim/tick/world.h"
#include "palpate/sim/tree/aabb_tree.h"

/// What a trainee is asked to do in a scene, in numbers, and the judge of it, which is called after
/// every tick: live, in a replay and in a test it comes to the same verdict at the same tick.
namespace palpate {

/// From least to most, both included.
struct Band {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// Where a step or a limit is. The first three are of a tissue at rest and move with it: what
/// counts is which point of the tissue is touched, not where that has been pushed to.
enum class PlaceKind {
  region,  ///< a set of vertices of the surface
  path,    ///< a line over it, followed from its first point to its last
  ball,    ///< all of it within a radius of a point
  object,  ///< a rigid body, wherever that is
  space,   ///< a sphere that stands still in the scene's frame
};

struct TaskPlace {
  PlaceKind kind = PlaceKind::ball;
  int body = 0;                    ///< of the scene; of an object: of Scene::rigid
  std::vector<int> vertices = {};  ///< of a region: of the body's surface
  Vec3Array points = {};           ///< [m] of a path two or more, of a ball or a space its centre
  /// [m] of a ball or a space; of a path, how far beside it still counts as on it
  double radius = 0.0;

  // filled in by build_task
  std::vector<std::uint8_t> members = {};  ///< of a region: per vertex of the surface 1 or 0
  std::vector<double> arc_length = {};     ///< [m] of a path: per point, from its beginning
  /// Of a region or a ball: vertices of the surface by which a camera sees it, at most
  /// kMostSeenPoints
  std::vector<int> seen = {};
};

/// What a step asks for. `at` its place means that at least half of the contact force is there, of
/// what is held at least half of the hold's stiffness.
enum class TaskVerb {
  touch,    ///< contact at the place
  hold,     ///< contact there, and the force within its band
  push,     ///< contact there, and force and depth within their bands
  pull,     ///< a hold there, moved outwards, and force and distance within their bands
  grasp,    ///< a hold there
  release,  ///< no hold there; anywhere, for no place
  trace,    ///< a share of a path touched in order, with the force within its band
  find,     ///< a click, a button that goes down, while what is touched is there
  look,     ///< the place in the middle of a camera's picture, half of it or more not hidden
  remove,   ///< an object wholly outside a space
  carry,    ///< the middle of an object inside a space
};

struct TaskStep {
  TaskVerb verb = TaskVerb::touch;
  int instrument = 0;       ///< of the scene
  int place = -1;           ///< of the task; -1 for none, which only release may have
  int space = -1;           ///< of the task: that remove is from, and carry into; else -1
  Band force = {};          ///< [N] size of what the hand feels
  Band depth = {};          ///< [m] of the tip below the surface at rest
  Band distance = {};       ///< [m] of what is held from where it is at rest; to look, of the lens
  double duration = 0.0;    ///< [s] for which it must be so; gaps of up to 0.1 s are left out
  double share = 1.0;       ///< [-] of a path, 0 to 1
  double time_limit = 0.0;  ///< [s] since it began; once longer is an error. 0 for none
  std::vector<int> after = {};  ///< steps that must be done before it begins
};

/// What a limit watches.
enum class TaskMeasure {
  force,       ///< [N] what the hand feels; with a place, the part of the contact force there
  force_rate,  ///< [N/s] of the force on the hand, over 20 ms
  contact,     ///< [N] any contact at the place at all: above 0
  depth,       ///< [m] of the tip below the surface at rest; 0 without contact
  distance,    ///< [m] of what is held from where it is at rest; 0 where nothing is
  speed,       ///< [m/s] of the tool, over 20 ms
  clearance,   ///< [m] from the tip's surface to a ball, where that is at rest; 0 inside
  off_path,    ///< [m] from what is touched to a path; 0 without contact
  /// [-] the largest principal one of what the tool touches or holds, there or anywhere; with an
  /// object, of all that is pushed within 2 mm of it, whatever pushes
  strain,
  loose,  ///< [-] 1 where the jaws do not hold an object between them, else 0: above 0
  /// [-] 1 where no camera has the tip in its picture, or it is hidden: above 0; with a space,
  /// while the tip is in that
  out_of_view,
  object_force,  ///< [N] all with which tissue pushes an object
  pad_pressure,  ///< [Pa] of jaws on what is touched of their pads
  torn,          ///< [-] 1 once a tissue has torn, else 0: above 0
};

/// Whether what it watches is or is not, so that its bound is 0 and it is wrong above that.
inline bool is_yes_or_no(TaskMeasure measure) noexcept {
  return measure == TaskMeasure::contact || measure == TaskMeasure::loose ||
         measure == TaskMeasure::out_of_view || measure == TaskMeasure::torn;
}

enum class LimitConsequence { warn, error, end };

/// Open once the measure has been beyond the bound for its duration, closed once it has been below
/// nine tenths of that for 0.1 s: one long press is one error, and a tremor at the bound as well.
struct TaskLimit {
  TaskMeasure measure = TaskMeasure::force;
  int instrument = 0;
  int place = -1;          ///< -1 for none
  bool above = true;       ///< wrong above the bound; else below it
  double bound = 0.0;      ///< in the unit of the measure
  double duration = 0.02;  ///< [s]
  LimitConsequence then = LimitConsequence::error;
  std::vector<int> during = {};  ///< steps while one of which it is watched; empty for always
};

/// A body's surface at rest.
struct TaskSurface {
  Vec3Array vertices;  ///< [m] (n, 3)
  Vec3Array normals;   ///< unit, outwards, (n, 3)
  std::vector<Triangle> triangles;
};

/// What is no tissue of a scene: its scenery, then its rigid bodies, as the surfaces that tools
/// touch are counted after the bodies.
struct TaskObject {
  int rigid = -1;             ///< of Scene::rigid; -1 of scenery
  Vec3Array vertices;         ///< [m] in its own frame, of scenery the scene's
  AabbTree tree;              ///< over these
  Vec3Array sphere_centres;   ///< [m] of a rigid body, in its own frame
  std::vector<double> radii;  ///< [m] of these
  RigidState start;           ///< of a rigid body
};

/// The lens of an instrument, in the tool's frame. What is hidden from it is hidden by tissue or
/// scenery, not by instruments or rigid bodies.
struct TaskCamera {
  int instrument = 0;             ///< of the scene
  Vec3 at = Vec3::Zero();         ///< [m]
  Vec3 forward = -Vec3::UnitZ();  ///< unit
  double field_of_view = 1.22;    ///< [rad] the whole angle of the round picture
};

inline constexpr int kMostSeenPoints = 32;

/// All that judge() knows of a task, and never changes.
struct Task {
  std::vector<TaskPlace> places;
  std::vector<TaskStep> steps;
  std::vector<TaskLimit> limits;
  double time_limit = 0.0;  ///< [s] of ticks, positive
  int errors_at_most = -1;  ///< with more the task has failed; -1 for any number
  std::vector<TaskCamera> cameras = {};

  // filled in by build_task
  std::vector<TaskSurface> surfaces = {};  ///< per body
  std::vector<double> tool_radii = {};     ///< [m] per instrument
  std::vector<TaskObject> objects = {};    ///< every scenery, then every rigid body
};
static_assert(alignof(Task) == 8);

inline constexpr int kMostSteps = 200;
inline constexpr int kMostLimits = 100;
inline constexpr int kMostPlaces = 100;

/// Whether its verdict depends on where all of a tissue is, so that World::follows_all must be on.
bool watches_sight(const Task& task) noexcept;

/// Checks a task once and fills in what is derived from it and the scene. Throws
/// std::invalid_argument naming the field, what it got and what was expected.
Task build_task(const Scene& scene, Task task);

/// How an attempt at a task came out. The first three are performance, the others are not.
enum class Outcome {
  running,
  done,
  failed,        ///< more errors than it may have, or a limit that ends it
  timed_out,     ///< of ticks: a pause takes no time
  left,          ///< ended by the trainee
  device_fault,  ///< the device failed, or gave no force any more
  diverged,      ///< an alarm: the tissue could not be simulated on
  interrupted,   ///< the program ended, and the record has no end
};

enum class StepStatus { waiting, active, done };

/// Kinds of an Event that a judge tells of; a record has them beside those of EventKind. `source`
/// is the instrument of the step or the limit.
enum class TaskEvent : std::int32_t {
  step_begun = 32,    ///< index: step
  step_done = 33,     ///< index: step; value: how long [s] it has taken
  step_overdue = 34,  ///< index: step; value: its time limit [s]
  click_missed = 35,  ///< index: step; value: how far [m] from the place, -1 where nobody can tell
  limit_opened = 36,  ///< index: limit; value: of its measure
  limit_closed = 37,  ///< index: limit; value: how long [s] it was open
  task_ended = 38,    ///< index: Outcome; value: [s] since the task began
};

/// Whether an event is one of these.
inline bool is_of_task(const Event& event) noexcept {
  const auto kind = static_cast<std::int32_t>(event.kind);
  return kind >= static_cast<std::int32_t>(TaskEvent::step_begun) &&
         kind <= static_cast<std::int32_t>(TaskEvent::task_ended);
}
inline bool is_kind(const Event& event, TaskEvent kind) noexcept {
  return static_cast<std::int32_t>(event.kind) == static_cast<std::int32_t>(kind);
}

struct StepState {
  StepStatus status = StepStatus::waiting;
  double dwell = 0.0;            ///< [s] for which what it asks has been so
  double progress = 0.0;         ///< [-] of a path: the share touched so far
  std::int64_t from_tick = -1;   ///< it began; -1 before
  std::int64_t until_tick = -1;  ///< it was done; -1 before
  bool overdue = false;          ///< it has taken longer than its time limit
};

struct LimitState {
  bool open = false;
  int count = 0;          ///< how often it has opened
  double duration = 0.0;  ///< [s] open in all
  double excess = 0.0;    ///< integral over that time of what lies beyond the bound
  double worst = 0.0;     ///< the value farthest beyond the bound so far, in the measure's unit
};

/// How far a trainee has come.
struct TaskState {
  Outcome outcome = Outcome::running;
  std::int64_t ticks = 0;  ///< judged
  double time = 0.0;       ///< [s]
  int errors = 0;
  int warnings = 0;
  double peak_force = 0.0;  ///< [N] the largest that was held for 10 ms, of any instrument
  std::vector<StepState> steps;
  std::vector<LimitState> limits;
};

/// What judge() remembers of an instrument.
struct JudgeSignals {
  static constexpr int kHistory = 21;  ///< ticks, of 20 ms at 1 kHz

  std::array<double, kHistory> forces{};                    ///< [N] of the last ticks, in turn
  Vec3Array positions = Vec3Array(kHistory, Vec3::Zero());  ///< [m] of the tool, likewise
  std::uint8_t buttons = 0;                                 ///< of the last tick
};

/// What judge() remembers of a step or a limit beside its state, in ticks.
struct JudgeTimer {
  int held = 0;   ///< for which it has been so
  int quiet = 0;  ///< since it was so last
};

/// A running task: everything that judge() needs is allocated here, once.
struct Progress {
  /// Throws std::invalid_argument for a task that is not from build_task.
  explicit Progress(const Task& task);

  TaskState state;
  std::vector<Event> events;  ///< of the last judge(), in order, `event_count` of them
  int event_count = 0;

  std::vector<JudgeSignals> signals;  ///< per instrument
  std::vector<JudgeTimer> step_timers, limit_timers;
  std::vector<double> reached;  ///< [m] per step: of its path, from the beginning
};
static_assert(alignof(Progress) == 8);

/// Judges a tick that has just been done: to be called once after every tick() with what that took
/// and gave, one of each for each instrument. Nothing changes once the outcome is no longer
/// `running`. Does not allocate, lock, log or throw.
void judge(const Task& task, const World& world, std::span<const HapticSample> samples,
           std::span<const HapticCommand> commands, double dt, Progress& progress) noexcept;

}  // namespace palpate
