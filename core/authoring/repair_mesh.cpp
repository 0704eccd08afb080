// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/repair_mesh.h"

#include <algorithm>
#include <set>

#include "palpate/authoring/edge_groups.h"
#include "palpate/authoring/join_parts.h"
#include "palpate/authoring/orient.h"
#include "palpate/authoring/part_touching_edges.h"
#include "palpate/authoring/triangle_shape.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

/// A flip can leave another flat triangle behind, so it is done again; more rounds than this only
/// send two flat triangles to and fro.
constexpr int kFlipRounds = 20;

int drop_duplicates(std::vector<Triangle>& triangles) {
  std::set<Triangle> seen;
  const auto is_repeated = [&](Triangle t) {
    std::sort(t.begin(), t.end());
    return t[0] == t[1] || t[1] == t[2] || !seen.insert(t).second;
  };
  return static_cast<int>(std::erase_if(triangles, is_repeated));
}

bool has_edge(std::span<const HalfEdge> sides, int i, int j) {
  const HalfEdge wanted{std::min(i, j), std::max(i, j), 0, 0, true};
  return std::binary_search(sides.begin(), sides.end(), wanted,
                            [](const HalfEdge& a, const HalfEdge& b) {
                              return std::tie(a.low, a.high) < std::tie(b.low, b.high);
                            });
}

/// The flat triangle a b c, b over the long side a c, and its neighbour c a d become a b d and
/// b c d: the surface stays where it is.
bool flip_away(const HalfEdge& flat, const HalfEdge& other, std::span<const HalfEdge> sides,
               std::vector<Triangle>& triangles) {
  Triangle &t = triangles[flat.triangle], &u = triangles[other.triangle];
  const int c = t[flat.corner], a = t[(flat.corner + 1) % 3], b = t[(flat.corner + 2) % 3];
  const int d = u[(other.corner + 2) % 3];
  if (flat.forward == other.forward || b == d || has_edge(sides, b, d)) return false;
  t = {a, b, d};
  u = {b, c, d};
  return true;
}

/// One round of flips; how many there were.
int flip_flat_triangles(SurfaceMesh& mesh, double tolerance) {
  const std::vector<HalfEdge> sides = sort_half_edges(mesh.triangles);
  std::vector<char> changed(mesh.vertices.size(), 0);  // the table of sides is stale around these
  int flips = 0;
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    if (edge.size() != 2) return;
    for (int i = 0; i < 2; ++i) {
      const HalfEdge &flat = edge[i], &other = edge[1 - i];
      const Triangle t = mesh.triangles[flat.triangle], u = mesh.triangles[other.triangle];
      const auto is_changed = [&](int v) { return changed[v] != 0; };
      if (std::any_of(t.begin(), t.end(), is_changed)) return;
      if (std::any_of(u.begin(), u.end(), is_changed)) return;
      const int corner = find_flat_corner(corners_of(mesh, t), tolerance);
      if (corner < 0 || (flat.corner + 2) % 3 != corner) continue;
      if (!flip_away(flat, other, sides, mesh.triangles)) continue;
      for (const int v : t) changed[v] = 1;
      for (const int v : u) changed[v] = 1;
      ++flips;
      return;
    }
  });
  return flips;
}

int remove_flat_triangles(SurfaceMesh& mesh, double tolerance) {
  const auto is_flat = [&](const Triangle& t) {
    return find_flat_corner(corners_of(mesh, t), tolerance) >= 0;
  };
  const auto count = std::count_if(mesh.triangles.begin(), mesh.triangles.end(), is_flat);
  if (count == 0) return 0;
  for (int round = 0; round < kFlipRounds; ++round) {
    if (flip_flat_triangles(mesh, tolerance) == 0) break;
  }
  std::erase_if(mesh.triangles, is_flat);
  return static_cast<int>(count);
}

int split_pinched_vertices(SurfaceMesh& mesh) {
  const int before = static_cast<int>(mesh.vertices.size());
  int next = before;
  const std::vector<int> vertex = separate_fans(mesh.triangles, next);
  mesh.vertices.resize(next);
  for (std::size_t i = 0; i < vertex.size(); ++i) {
    int& corner = mesh.triangles[i / 3][i % 3];
    if (vertex[i] >= before) mesh.vertices[vertex[i]] = mesh.vertices[corner];
    corner = vertex[i];
  }
  return next - before;
}

int drop_islands(SurfaceMesh& mesh, double smallest) {
  const std::vector<int> shell =
      find_shells(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  const int count = shell.empty() ? 0 : *std::max_element(shell.begin(), shell.end()) + 1;
  std::vector<Vec3Array> corners(count);
  for (const Triangle& t : mesh.triangles) {
    for (const int v : t) corners[shell[v]].push_back(mesh.vertices[v]);
  }
  std::vector<char> drop(count, 0);
  for (int s = 0; s < count; ++s) {
    drop[s] = !corners[s].empty() && compute_diagonal(corners[s]) < smallest;
  }
  std::erase_if(mesh.triangles, [&](const Triangle& t) { return drop[shell[t[0]]] != 0; });
  return static_cast<int>(std::count(drop.begin(), drop.end(), 1));
}

int drop_unused(SurfaceMesh& mesh) {
  std::vector<int> place(mesh.vertices.size(), -1);
  for (const Triangle& t : mesh.triangles) {
    for (const int corner : t) place[corner] = 0;
  }
  int kept = 0;
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] < 0) continue;
    mesh.vertices[kept] = mesh.vertices[v];
    place[v] = kept++;
  }
  const int dropped = static_cast<int>(mesh.vertices.size()) - kept;
  mesh.vertices.resize(kept);
  for (Triangle& t : mesh.triangles) t = {place[t[0]], place[t[1]], place[t[2]]};
  return dropped;
}

}  // namespace

RepairedMesh repair_mesh(const SurfaceMesh& mesh) {
  RepairedMesh repaired;
  repaired.mesh = mesh;
  if (mesh.vertices.empty()) return repaired;
  const double diagonal = compute_diagonal(mesh.vertices);
  const double tolerance = kWeldTolerance * diagonal;
  repaired.duplicate_triangles = drop_duplicates(repaired.mesh.triangles);
  // as the file has it first: what hangs together only there could not be oriented without it
  repaired.parted_edges = part_touching_edges(repaired.mesh, kPartingShare * diagonal);
  // neighbours must agree before sides are flipped; which side is out is asked of the clean surface
  const Orientation first = orient(repaired.mesh);
  repaired.degenerate_triangles = remove_flat_triangles(repaired.mesh, tolerance);
  orient(repaired.mesh);
  repaired.parted_edges += part_touching_edges(repaired.mesh, kPartingShare * diagonal);
  const Orientation last = orient(repaired.mesh);
  repaired.turned_triangles = first.turned + last.turned;
  repaired.orientable = last.orientable;
  // surfaces that share a crowded edge hang together there and must not fall apart unseen
  if (count_crowded_edges(repaired.mesh.triangles) == 0) {
    repaired.split_vertices = split_pinched_vertices(repaired.mesh);
  }
  repaired.dropped_islands = drop_islands(repaired.mesh, kIsland * diagonal);
  repaired.unused_vertices = drop_unused(repaired.mesh);
  return repaired;
}

}  // namespace palpate::authoring
