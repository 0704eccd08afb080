// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/task/private/build_places.h"

#include <algorithm>

namespace palpate {
namespace {

void build_region(std::size_t p, const TaskSurface& surface, TaskPlace& place) {
  const std::string where = name_row("places", p, "vertices");
  if (place.vertices.empty()) refuse(where, "none", "at least one vertex of the surface");
  place.members.assign(surface.vertices.size(), 0);
  for (const int v : place.vertices) {
    check_index(where, v, 0, surface.vertices.size());
    place.members[static_cast<std::size_t>(v)] = 1;
  }
}

void build_path(std::size_t p, TaskPlace& place) {
  place.arc_length.assign(1, 0.0);
  for (std::size_t i = 1; i < place.points.size(); ++i) {
    const double step = (place.points[i] - place.points[i - 1]).norm();
    if (!(step > 0.0)) {
      refuse(name_row("places", p, "points"), write_text("twice the same, in row ", i),
             "each elsewhere than the one before");
    }
    place.arc_length.push_back(place.arc_length.back() + step);
  }
}

/// At most kMostSeenPoints of these, spread evenly over the list.
std::vector<int> thin(const std::vector<int>& vertices) {
  constexpr std::size_t kMost = kMostSeenPoints;
  if (vertices.size() <= kMost) return vertices;
  std::vector<int> some;
  for (std::size_t k = 0; k < kMost; ++k) some.push_back(vertices[k * vertices.size() / kMost]);
  return some;
}

/// Vertices within a ball; the nearest where there is none.
std::vector<int> find_in_ball(const TaskPlace& ball, const Vec3Array& x) {
  const auto distance = [&](int v) {
    return (x[static_cast<std::size_t>(v)] - ball.points[0]).norm();
  };
  std::vector<int> inside;
  int nearest = 0;
  for (int v = 0; v < static_cast<int>(x.size()); ++v) {
    if (distance(v) <= ball.radius) inside.push_back(v);
    if (distance(v) < distance(nearest)) nearest = v;
  }
  if (inside.empty()) inside.push_back(nearest);
  return inside;
}

void build_points(std::size_t p, TaskPlace& place) {
  const std::string where = name_row("places", p, "points");
  const bool is_path = place.kind == PlaceKind::path;
  const std::size_t count = place.points.size();
  if (is_path ? count < 2 || count > 10000 : count != 1) {
    const char* one = place.kind == PlaceKind::space ? "1 of a space" : "1 of a ball";
    refuse(where, std::to_string(count), is_path ? "2 to 10000 of a path" : one);
  }
  for (const Vec3& point : place.points) {
    if (!point.allFinite()) refuse(where, "a number that is not finite", "finite ones");
  }
  check_number(name_row("places", p, "radius"), place.radius, 1e-5, 1.0);
  if (is_path) build_path(p, place);
}

TaskObject build_object(const SurfaceMesh& mesh) {
  TaskObject object;
  object.vertices = mesh.vertices;
  object.tree = AabbTree(object.vertices, mesh.triangles);
  return object;
}

}  // namespace

std::vector<TaskObject> build_objects(const Scene& scene) {
  std::vector<TaskObject> objects;
  for (const Scenery& scenery : scene.scenery) objects.push_back(build_object(scenery.mesh));
  for (std::size_t r = 0; r < scene.rigid.size(); ++r) {
    const RigidBody& body = scene.rigid[r];
    TaskObject object = build_object(body.mesh);
    object.rigid = static_cast<int>(r);
    object.sphere_centres = body.sphere_centres;
    object.radii = body.sphere_radii;
    object.start = {.position = body.position, .orientation = body.orientation};
    objects.push_back(std::move(object));
  }
  return objects;
}

void build_place(const Scene& scene, Task& task, std::size_t p) {
  TaskPlace& place = task.places[p];
  place.members.clear();
  place.arc_length.clear();
  place.seen.clear();
  if (place.kind == PlaceKind::space) return build_points(p, place);
  if (place.kind == PlaceKind::object) {
    if (scene.rigid.empty()) {
      refuse(name_row("places", p, "kind"), "an object", "another: the scene has no rigid body");
    }
    return check_index(name_row("places", p, "body"), place.body, 0, scene.rigid.size());
  }
  check_index(name_row("places", p, "body"), place.body, 0, task.surfaces.size());
  const TaskSurface& surface = task.surfaces[static_cast<std::size_t>(place.body)];
  if (place.kind == PlaceKind::region) {
    build_region(p, surface, place);
    place.seen = thin(place.vertices);
    return;
  }
  build_points(p, place);
  if (place.kind == PlaceKind::ball) place.seen = thin(find_in_ball(place, surface.vertices));
}

}  // namespace palpate
