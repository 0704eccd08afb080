// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/task/private/objects.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {
namespace {

/// [-] Of the picture's radius: what is farther out is not looked at.
constexpr double kMiddle = 0.5;
/// [-] Of a place's points: so many must not be hidden.
constexpr double kHalf = 0.5;
/// [m] What hides a point lies before it by more than this: a point of a surface does not hide
/// itself.
constexpr double kBefore = 2e-4;

/// A lens where its instrument is.
class Eye {
 public:
  Eye(const Task& task, const World& world, const TaskCamera& camera) noexcept
      : task_(task), world_(world), tangent_(std::tan(0.5 * camera.field_of_view)) {
    const ToolState& tool = world.instruments[static_cast<std::size_t>(camera.instrument)].tool;
    at_ = tool.position + tool.orientation * camera.at;
    forward_ = tool.orientation * camera.forward;
  }

  double measure_distance(const Vec3& point) const noexcept { return (point - at_).norm(); }

  /// [-] From the middle of the picture: 1 at its rim, infinite behind the lens.
  double measure_offset(const Vec3& point) const noexcept {
    const Vec3 side = point - at_;
    const double deep = side.dot(forward_);
    if (!(deep > 0.0)) return std::numeric_limits<double>::infinity();
    return (side - deep * forward_).norm() / (deep * tangent_);
  }

  bool sees(const Vec3& point) const noexcept {
    return measure_offset(point) <= 1.0 && !is_hidden(point);
  }

 private:
  bool is_hidden(const Vec3& point) const noexcept {
    const Vec3 side = point - at_;
    const double far = side.norm();
    if (!(far > kBefore)) return false;
    const Vec3 end = at_ + side * ((far - kBefore) / far);
    for (const SoftState& body : world_.bodies) {
      if (find_segment_hit(body.tree, surface_position(body), at_, end)) return true;
    }
    return std::ranges::any_of(task_.objects, [&](const TaskObject& object) noexcept {
      return object.rigid < 0 && find_segment_hit(object.tree, object.vertices, at_, end);
    });
  }

  const Task& task_;
  const World& world_;
  double tangent_;
  Vec3 at_, forward_;
};

/// Calls `visit` with the points [m] by which a place is seen.
template <class Visit>
void for_each_seen(const Task& task, const World& world, const TaskPlace& place,
                   Visit visit) noexcept {
  if (place.kind == PlaceKind::object) {
    const TaskObject& object = find_rigid(task, place.body);
    for (const Vec3& centre : object.sphere_centres) visit(find_now(object, world, centre));
  } else if (place.kind == PlaceKind::space) {
    visit(place.points[0]);
  } else {
    const std::span<const Vec3> x =
        surface_position(world.bodies[static_cast<std::size_t>(place.body)]);
    for (const int vertex : place.seen) visit(x[static_cast<std::size_t>(vertex)]);
  }
}

}  // namespace

bool is_looked_at(const Task& task, const World& world, const TaskCamera& camera,
                  const TaskPlace& place, const Band& distance) noexcept {
  if (!world.instruments[static_cast<std::size_t>(camera.instrument)].tool.placed) return false;
  const Eye eye(task, world, camera);
  Vec3 middle = Vec3::Zero();
  int count = 0;
  for_each_seen(task, world, place, [&](const Vec3& point) noexcept {
    middle += point;
    ++count;
  });
  middle /= std::max(count, 1);
  const double far = eye.measure_distance(middle);
  if (count == 0 || !(far >= distance.least && far <= distance.most)) return false;
  if (eye.measure_offset(middle) > kMiddle) return false;
  int seen = 0;
  for_each_seen(task, world, place,
                [&](const Vec3& point) noexcept { seen += eye.sees(point) ? 1 : 0; });
  return seen >= kHalf * count;
}

bool is_in_view(const Task& task, const World& world, std::size_t instrument) noexcept {
  const ToolState& tool = world.instruments[instrument].tool;
  return std::ranges::any_of(task.cameras, [&](const TaskCamera& camera) noexcept {
    const ToolState& held = world.instruments[static_cast<std::size_t>(camera.instrument)].tool;
    return held.placed && Eye(task, world, camera).sees(tool.position);
  });
}

bool watches_sight(const Task& task) noexcept {
  const auto looks = [](const TaskStep& step) noexcept { return step.verb == TaskVerb::look; };
  const auto sees = [](const TaskLimit& limit) noexcept {
    return limit.measure == TaskMeasure::out_of_view;
  };
  return std::ranges::any_of(task.steps, looks) || std::ranges::any_of(task.limits, sees);
}

}  // namespace palpate
