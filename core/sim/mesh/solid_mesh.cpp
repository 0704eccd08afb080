// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/mesh.h"

namespace palpate {
namespace {

/// The corners of the face opposite corner c, counter-clockwise from outside.
constexpr std::array<std::array<int, 3>, 4> kFaces = {
    {{{1, 2, 3}}, {{0, 3, 2}}, {{0, 1, 3}}, {{0, 2, 1}}}};
constexpr std::array<std::array<int, 2>, 6> kEdges = {
    {{{0, 1}}, {{0, 2}}, {{0, 3}}, {{1, 2}}, {{1, 3}}, {{2, 3}}}};

/// A face by its sorted corners, and whose it is.
struct Face {
  Triangle sorted;
  std::size_t tetrahedron;
  Triangle corners;
};

std::vector<Face> list_faces(const SolidMesh& solid) {
  std::vector<Face> faces;
  faces.reserve(4 * solid.tetrahedra.size());
  for (std::size_t t = 0; t < solid.tetrahedra.size(); ++t) {
    const auto& corners = solid.tetrahedra[t];
    for (const auto& [a, b, c] : kFaces) {
      Face face{{}, t, {corners[a], corners[b], corners[c]}};
      face.sorted = face.corners;
      std::sort(face.sorted.begin(), face.sorted.end());
      faces.push_back(face);
    }
  }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Face& a, const Face& b) { return a.sorted < b.sorted; });
  return faces;
}

std::string name_row(std::size_t t) { return write_text("solid: tetrahedra: row ", t); }

void check_tetrahedra(const SolidMesh& solid, std::vector<bool>& used) {
  const int n = static_cast<int>(solid.vertices.size());
  if (solid.tetrahedra.empty()) refuse("solid: tetrahedra", "none", "at least one");
  for (std::size_t t = 0; t < solid.tetrahedra.size(); ++t) {
    const auto& corners = solid.tetrahedra[t];
    for (const int i : corners) {
      if (i < 0 || i >= n) {
        refuse(name_row(t), write_text("vertex ", i), write_text("0 to ", n - 1));
      }
      used[static_cast<std::size_t>(i)] = true;
    }
    const auto& [a, b, c, d] = corners;
    const double volume =
        compute_volume(solid.vertices[a], solid.vertices[b], solid.vertices[c], solid.vertices[d]);
    if (!(volume > 0.0)) {
      refuse(name_row(t), write_text("a volume of ", volume, " m³"), "a positive one");
    }
  }
}

}  // namespace

void validate(const SolidMesh& solid) {
  for (std::size_t i = 0; i < solid.vertices.size(); ++i) {
    if (solid.vertices[i].allFinite()) continue;
    refuse(write_text("solid: vertices: row ", i), "a number that is not finite", "finite numbers");
  }
  std::vector<bool> used(solid.vertices.size(), false);
  check_tetrahedra(solid, used);
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end()) {
    refuse(write_text("solid: vertices: row ", unused - used.begin()), "in no tetrahedron",
           "every vertex in one");
  }
  const std::vector<Face> faces = list_faces(solid);
  for (std::size_t f = 2; f < faces.size(); ++f) {
    if (faces[f].sorted != faces[f - 2].sorted) continue;
    refuse(name_row(faces[f].tetrahedron), "a face that two others have", "at most one other");
  }
}

double compute_volume(const SolidMesh& solid) {
  double sum = 0.0;
  for (const auto& [a, b, c, d] : solid.tetrahedra) {
    sum +=
        compute_volume(solid.vertices[a], solid.vertices[b], solid.vertices[c], solid.vertices[d]);
  }
  return sum;
}

std::vector<Triangle> find_boundary(const SolidMesh& solid) {
  const std::vector<Face> faces = list_faces(solid);
  std::vector<const Face*> single;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const bool before = f > 0 && faces[f - 1].sorted == faces[f].sorted;
    const bool after = f + 1 < faces.size() && faces[f + 1].sorted == faces[f].sorted;
    if (!before && !after) single.push_back(&faces[f]);
  }
  std::stable_sort(single.begin(), single.end(),
                   [](const Face* a, const Face* b) { return a->tetrahedron < b->tetrahedron; });
  std::vector<Triangle> boundary;
  boundary.reserve(single.size());
  for (const Face* face : single) boundary.push_back(face->corners);
  return boundary;
}

std::vector<std::array<int, 2>> find_edges(const SolidMesh& solid) {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(6 * solid.tetrahedra.size());
  for (const auto& corners : solid.tetrahedra) {
    for (const auto& [a, b] : kEdges) {
      edges.push_back({std::min(corners[a], corners[b]), std::max(corners[a], corners[b])});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Between the faces with outward normals m and n the angle is pi less that between m and n.
double compute_smallest_dihedral(const SolidMesh& solid) {
  double smallest = std::numbers::pi;
  for (const auto& corners : solid.tetrahedra) {
    std::array<Vec3, 4> normals;
    for (std::size_t f = 0; f < 4; ++f) {
      const auto& [a, b, c] = kFaces[f];
      const Vec3& at = solid.vertices[corners[a]];
      normals[f] =
          (solid.vertices[corners[b]] - at).cross(solid.vertices[corners[c]] - at).normalized();
    }
    for (const auto& [f, g] : kEdges) {
      smallest = std::min(smallest, std::acos(std::clamp(-normals[f].dot(normals[g]), -1.0, 1.0)));
    }
  }
  return smallest;
}

}  // namespace palpate
