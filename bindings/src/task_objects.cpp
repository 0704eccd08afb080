// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <span>

#include "array.h"
#include "bindings.h"
#include "border.h"
#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/task/task.h"
#include "task_bindings.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_camera(py::module_& m) {
  py::class_<TaskCamera> camera(m, "TaskCamera", "The lens of an instrument, in the tool's frame.");
  camera
      .def(py::init([](int instrument, const Vec3& at, const Vec3& forward, double field_of_view) {
             return TaskCamera{instrument, at, forward, field_of_view};
           }),
           py::kw_only(), "instrument"_a = 0, "at"_a = Vec3(Vec3::Zero()),
           "forward"_a = TaskCamera().forward, "field_of_view"_a = TaskCamera().field_of_view)
      .def_readwrite("instrument", &TaskCamera::instrument, "Of the scene.")
      .def_readwrite("field_of_view", &TaskCamera::field_of_view,
                     "[rad] The whole angle of the round picture.");
  def_vector(camera, "at", &TaskCamera::at, "[m] shape (3,)");
  def_vector(camera, "forward", &TaskCamera::forward, "[-] unit, shape (3,)");
  def_value(camera, &TaskCamera::instrument, &TaskCamera::at, &TaskCamera::forward,
            &TaskCamera::field_of_view);
  def_repr(camera, {"instrument", "field_of_view"});
}

/// Its tree is built again from what it is over.
py::tuple pack_object(const TaskObject& object) {
  const std::span<const Triangle> triangles = object.tree.triangles();
  return py::make_tuple(object.rigid, own(Vec3Array(object.vertices)),
                        own(std::vector<Triangle>(triangles.begin(), triangles.end())),
                        own(Vec3Array(object.sphere_centres)),
                        own(std::vector<double>(object.radii)), object.start);
}

TaskObject unpack_object(const py::tuple& packed) {
  if (packed.size() != 6) refuse("pickle", "other members", "6, as this version has");
  TaskObject object;
  object.rigid = packed[0].cast<int>();
  object.vertices = unpack_member<Vec3Array>(packed[1]);
  object.tree = AabbTree(object.vertices, unpack_member<std::vector<Triangle>>(packed[2]));
  object.sphere_centres = unpack_member<Vec3Array>(packed[3]);
  object.radii = unpack_member<std::vector<double>>(packed[4]);
  object.start = packed[5].cast<RigidState>();
  require_count("pickle", object.radii.size(), object.sphere_centres.size());
  return object;
}

void bind_object(py::module_& m) {
  py::class_<TaskObject> object(m, "TaskObject",
                                "What is no tissue of a scene, as a task knows it.");
  object.def(py::init<>())
      .def_readonly("rigid", &TaskObject::rigid, "Of Scene.rigid; -1 of scenery.")
      .def_readonly("start", &TaskObject::start, "Of a rigid body: where the scene begins.");
  def_view(object, "vertices", &TaskObject::vertices,
           "[m] shape (n, 3) in its own frame, of scenery the scene's; a view.");
  def_view(object, "sphere_centres", &TaskObject::sphere_centres,
           "[m] shape (k, 3) of a rigid body, in its own frame; a view.");
  def_view(object, "radii", &TaskObject::radii, "[m] shape (k,) of these; a view.");
  def_copy(object);
  object.def(py::pickle(&pack_object, &unpack_object));
  def_repr(object, {"rigid"});
}

}  // namespace

void bind_task_objects(py::module_& m) {
  bind_camera(m);
  bind_object(m);
}

}  // namespace palpate::bindings
