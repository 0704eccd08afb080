// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/task/private/objects.h"

#include <algorithm>
#include <array>

#include "palpate/sim/task/private/measure.h"

namespace palpate {

Vec3 find_start(const TaskObject& object, const Vec3& point) noexcept {
  if (object.rigid < 0) return point;
  return object.start.orientation * point + object.start.position;
}

Vec3 find_now(const TaskObject& object, const World& world, const Vec3& point) noexcept {
  if (object.rigid < 0) return point;
  const RigidState& state = world.rigid[static_cast<std::size_t>(object.rigid)];
  return state.orientation * point + state.position;
}

const TaskObject& find_rigid(const Task& task, int rigid) noexcept {
  return *std::ranges::find(task.objects, rigid, &TaskObject::rigid);  // build_task has checked it
}

bool is_object_held(const Task& task, const World& world, std::size_t instrument,
                    int rigid) noexcept {
  const auto row = static_cast<std::size_t>(&find_rigid(task, rigid) - task.objects.data());
  std::array<bool, 2> sticks{};
  for (const ToolState::Anchor& anchor : list_anchors(world.instruments[instrument].tool)) {
    if (static_cast<std::size_t>(anchor.body) != world.bodies.size() + row) continue;
    sticks[static_cast<std::size_t>(anchor.jaw)] = true;
  }
  return sticks[0] && sticks[1];
}

bool is_outside(const Task& task, const World& world, int rigid, const TaskPlace& space) noexcept {
  const TaskObject& object = find_rigid(task, rigid);
  for (std::size_t s = 0; s < object.radii.size(); ++s) {
    const Vec3 centre = find_now(object, world, object.sphere_centres[s]);
    if ((centre - space.points[0]).norm() < space.radius + object.radii[s]) return false;
  }
  return true;
}

bool is_inside(const World& world, int rigid, const TaskPlace& space) noexcept {
  const Vec3& middle = world.rigid[static_cast<std::size_t>(rigid)].position;
  return (middle - space.points[0]).norm() <= space.radius;
}

}  // namespace palpate
