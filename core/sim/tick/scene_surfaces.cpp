// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/tick/surface_pointer.h"

namespace palpate {

SceneSurfaces::SceneSurfaces(const Scene& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const TissueModel& tissue = scene.bodies[b].tissue;
    add(ScenePart::body, b, compute_surface(tissue, tissue.rest_position), tissue.triangles);
  }
  for (std::size_t s = 0; s < scene.scenery.size(); ++s) {
    const SurfaceMesh& mesh = scene.scenery[s].mesh;
    add(ScenePart::scenery, s, mesh.vertices, mesh.triangles);
  }
  first_rigid_ = surfaces_.size();
  for (std::size_t r = 0; r < scene.rigid.size(); ++r) {
    const RigidBody& body = scene.rigid[r];
    add(ScenePart::rigid, r, body.mesh.vertices, body.mesh.triangles);
    place_rigid(r, body.position, body.orientation);
  }
}

void SceneSurfaces::add(ScenePart part, std::size_t index, Vec3Array x,
                        const std::vector<Triangle>& triangles) {
  Surface made{part, static_cast<int>(index), std::move(x), {}, {}};
  if (!triangles.empty()) {
    made.normals = compute_vertex_normals(made.x, triangles);
    made.tree = AabbTree(made.x, triangles);
  }
  surfaces_.push_back(std::move(made));
}

void SceneSurfaces::place_rigid(std::size_t index, const Vec3& position,
                                const Quaternion& orientation) noexcept {
  Surface& surface = surfaces_[first_rigid_ + index];
  surface.position = position;
  surface.orientation = orientation;
}

std::optional<ScenePoint> SceneSurfaces::find_ray_hit(const Vec3& origin,
                                                      const Vec3& direction) const noexcept {
  std::optional<ScenePoint> first;
  bool outer = false;
  for (const Surface& surface : surfaces_) {
    if (surface.normals.empty()) continue;
    const Quaternion back = surface.orientation.conjugate();
    const Vec3 along = back * direction;
    const auto hit =
        palpate::find_ray_hit(surface.tree, surface.x, back * (origin - surface.position), along);
    if (!hit || (first && hit->distance >= first->distance)) continue;
    first = place(surface, *hit);
    const Triangle& t = surface.tree.triangles()[static_cast<std::size_t>(hit->triangle)];
    const Vec3& a = surface.x[static_cast<std::size_t>(t[0])];
    const Vec3 side = surface.x[static_cast<std::size_t>(t[1])] - a;
    outer = side.cross(surface.x[static_cast<std::size_t>(t[2])] - a).dot(along) < 0.0;
  }
  return outer ? first : std::nullopt;
}

std::optional<ScenePoint> SceneSurfaces::find_closest_point(const Vec3& p,
                                                            int rigid) const noexcept {
  std::optional<ScenePoint> nearest;
  for (const Surface& surface : surfaces_) {
    if (surface.normals.empty()) continue;
    if (surface.part == ScenePart::rigid && surface.index != rigid) continue;
    const Vec3 at = surface.orientation.conjugate() * (p - surface.position);
    const auto found =
        nearest ? palpate::find_closest_point(surface.tree, surface.x, at, nearest->distance)
                : palpate::find_closest_point(surface.tree, surface.x, at);
    if (!found || (nearest && found->distance >= nearest->distance)) continue;
    nearest = place(surface, *found);
  }
  return nearest;
}

ScenePoint SceneSurfaces::place(const Surface& surface, const SurfacePoint& found) const noexcept {
  const Triangle& corners = surface.tree.triangles()[static_cast<std::size_t>(found.triangle)];
  Vec3 normal = Vec3::Zero();
  for (int c = 0; c < 3; ++c) {
    normal += found.weights[c] * surface.normals[static_cast<std::size_t>(corners[c])];
  }
  const double length = normal.norm();
  return {surface.part,
          surface.index,
          found.triangle,
          surface.orientation * found.point + surface.position,
          length > 0.0 ? Vec3(surface.orientation * (normal / length)) : Vec3(Vec3::UnitZ()),
          found.distance};
}

}  // namespace palpate
