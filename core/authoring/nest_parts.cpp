// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/nest_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/authoring/join_parts.h"
#include "palpate/authoring/orient.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/authoring/weld.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

constexpr int kMostSamples = 9;  ///< vertices of a part that are asked whether they lie inside
/// Solid angles that are computed, some 20 million in a second.
constexpr double kAngleBudget = 4e7;

/// [-] Windings: a point on a surface has one of a half.
constexpr double kInside = 0.75;

struct Body {
  SurfaceMesh mesh;  ///< welded, neighbours agreeing
  std::array<Vec3, 2> bounds = {Vec3::Zero(), Vec3::Zero()};
  double diagonal = 0.0;
};

Body take_body(const ImportedPart& part) {
  Body body;
  body.mesh = weld(part.mesh, 0.0).mesh;
  if (body.mesh.vertices.empty()) return body;
  body.diagonal = compute_diagonal(body.mesh.vertices);
  body.mesh = weld(body.mesh, kWeldTolerance * body.diagonal).mesh;
  if (body.mesh.vertices.empty()) return body;
  orient(body.mesh);
  body.bounds = compute_bounds(body.mesh.vertices);
  return body;
}

/// How often a surface winds around p: the solid angle of its triangles over 4 pi. One inside,
/// zero outside; between them near the holes of an open one.
double compute_winding(const SurfaceMesh& mesh, const Vec3& p) {
  double angle = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - p, b = mesh.vertices[t[1]] - p,
               c = mesh.vertices[t[2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2.0 * std::atan2(a.dot(b.cross(c)),
                              la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4.0 * std::numbers::pi);
}

bool box_holds(const Body& outer, const Body& inner) {
  return !outer.mesh.triangles.empty() && !inner.mesh.triangles.empty() &&
         outer.diagonal > inner.diagonal &&
         (inner.bounds[0].array() >= outer.bounds[0].array()).all() &&
         (inner.bounds[1].array() <= outer.bounds[1].array()).all();
}

bool lies_inside(const Body& outer, const Body& inner, int samples) {
  const auto count = static_cast<int>(inner.mesh.vertices.size());
  const int asked = std::min(samples, count);
  int inside = 0;
  for (int i = 0; i < asked; ++i) {
    const auto at = static_cast<std::size_t>(static_cast<std::int64_t>(i) * count / asked);
    inside += std::abs(compute_winding(outer.mesh, inner.mesh.vertices[at])) > kInside;
  }
  return 2 * inside > asked;
}

/// How many vertices of each part are asked; none where even one would take too long.
int choose_samples(const std::vector<Body>& bodies) {
  double angles = 0.0;
  for (const Body& inner : bodies) {
    for (const Body& outer : bodies) {
      if (box_holds(outer, inner)) angles += static_cast<double>(outer.mesh.triangles.size());
    }
  }
  return angles == 0.0 ? 0
                       : static_cast<int>(std::min<double>(kMostSamples, kAngleBudget / angles));
}

void find_containers(const std::vector<Body>& bodies, std::vector<PartPlace>& places) {
  const int samples = choose_samples(bodies);
  if (samples == 0) return;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    double smallest = 0.0;
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      if (i == j || !box_holds(bodies[j], bodies[i])) continue;
      if (places[i].inside >= 0 && bodies[j].diagonal >= smallest) continue;
      if (!lies_inside(bodies[j], bodies[i], samples)) continue;
      places[i].inside = static_cast<int>(j);
      smallest = bodies[j].diagonal;
    }
  }
}

}  // namespace

std::vector<PartPlace> find_places(const ImportedScene& scene) {
  std::vector<Body> bodies;
  std::vector<PartPlace> places(scene.parts.size());
  SurfaceMesh all;
  std::vector<int> part_of;
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    bodies.push_back(take_body(scene.parts[p]));
    const SurfaceMesh& mesh = bodies.back().mesh;
    places[p].closed = !mesh.triangles.empty() && is_closed(mesh.triangles);
    const int first = static_cast<int>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const Triangle& t : mesh.triangles) {
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      part_of.push_back(static_cast<int>(p));
    }
  }
  if (places.size() < 2) {
    for (PartPlace& place : places) place.crossing_faces = -1;
    return places;
  }
  find_containers(bodies, places);
  const auto crossings = find_crossing_groups(all, part_of);
  if (!crossings) {
    for (PartPlace& place : places) place.crossing_faces = -1;
    return places;
  }
  for (const auto& [a, b] : crossings->pairs) {
    places[a].crosses.push_back(b);
    places[b].crosses.push_back(a);
  }
  for (PartPlace& place : places) std::sort(place.crosses.begin(), place.crosses.end());
  for (const int face : crossings->own_faces) ++places[part_of[face]].crossing_faces;
  return places;
}

}  // namespace palpate::authoring
