// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/task/task.h"

// Of a task: what is no tissue, and what a camera sees. Only sight reads where tissue is that no
// tool touches (watches_sight).

namespace palpate {

/// [m] Where a point of an object, given in its own frame, was as the scene began, and is now.
Vec3 find_start(const TaskObject& object, const Vec3& point) noexcept;
Vec3 find_now(const TaskObject& object, const World& world, const Vec3& point) noexcept;

/// What a task knows of a rigid body of the scene.
const TaskObject& find_rigid(const Task& task, int rigid) noexcept;

/// Whether both jaws of an instrument stick to a rigid body.
bool is_object_held(const Task& task, const World& world, std::size_t instrument,
                    int rigid) noexcept;

/// Whether all spheres of a rigid body lie outside a space, or its middle lies inside.
bool is_outside(const Task& task, const World& world, int rigid, const TaskPlace& space) noexcept;
bool is_inside(const World& world, int rigid, const TaskPlace& space) noexcept;

/// Whether a place is in the middle of a camera's picture, half of it or more not hidden.
bool is_looked_at(const Task& task, const World& world, const TaskCamera& camera,
                  const TaskPlace& place, const Band& distance) noexcept;

/// Whether any camera has the tip of an instrument in its picture.
bool is_in_view(const Task& task, const World& world, std::size_t instrument) noexcept;

}  // namespace palpate
