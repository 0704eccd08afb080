// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/improve_triangles.h"

#include <algorithm>
#include <numbers>

#include "palpate/authoring/border_lines.h"
#include "palpate/authoring/flip_edges.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/authoring/trade_edges.h"

namespace palpate::authoring {
namespace {

using Edges = std::vector<std::array<int, 2>>;

constexpr int kFlipsPerRound = 3;

/// Rounds of smoothing; before the ones after these, triangles nothing else can repair are traded.
constexpr int kSmoothRounds = 24;
constexpr int kTradeRounds[] = {15, 20};

/// Rounds that only work on the worst triangles left.
constexpr int kRepairRounds = 12;

/// [rad] Below this a triangle's shortest edge is traded for another.
constexpr double kBadAngle = 25.0 * (std::numbers::pi / 180.0);

std::size_t count_crossings(const SurfaceMesh& mesh) {
  const auto faces = find_self_intersecting_faces(mesh);
  return faces ? faces->size() : mesh.triangles.size();
}

/// Puts back what has made faces cross that did not before: their own vertices first, all of them
/// where that does not do.
void undo_crossings(const Vec3Array& before, std::size_t allowed, SurfaceMesh& mesh) {
  for (;;) {
    const auto faces = find_self_intersecting_faces(mesh);
    if (faces && faces->size() <= allowed) return;
    bool put_back = false;
    for (const int t : faces.value_or(std::vector<int>())) {
      for (const int v : mesh.triangles[t]) {
        put_back = put_back || mesh.vertices[v] != before[v];
        mesh.vertices[v] = before[v];
      }
    }
    if (put_back) continue;
    mesh.vertices = before;
    return;
  }
}

/// One pass of flips; those that make faces cross are undone and held back.
int flip_guarded(std::size_t allowed, const Edges& kept, SurfaceMesh& mesh) {
  const std::vector<Triangle> before = mesh.triangles;
  std::vector<char> held(mesh.vertices.size(), 0);
  for (;;) {
    const int flips = flip_edges(mesh, held, kept);
    const auto faces = find_self_intersecting_faces(mesh);
    if (flips == 0 || (faces && faces->size() <= allowed)) return flips;
    bool is_new = false;
    for (const int t : faces.value_or(std::vector<int>())) {
      for (const Triangle& corners : {mesh.triangles[t], before[t]}) {
        for (const int v : corners) {
          is_new = is_new || !held[v];
          held[v] = 1;
        }
      }
    }
    mesh.triangles = before;
    if (!is_new) return 0;
  }
}

/// Rounds of flips and moves. With `guarded`, whatever makes faces cross is undone.
void run_rounds(const Outline& outline, bool guarded, SurfaceMesh& mesh) {
  const std::size_t allowed = guarded ? count_crossings(mesh) : 0;
  const Edges kept = outline.kept.lines.list_edges();
  std::vector<char> on_line;
  for (const int line : outline.kept.lines.line) on_line.push_back(line != FeatureLines::kNone);
  MovingVertices moving(outline, mesh);
  for (int round = 0; round < kSmoothRounds + kRepairRounds; ++round) {
    for (int pass = 0; pass < kFlipsPerRound; ++pass) {
      if ((guarded ? flip_guarded(allowed, kept, mesh) : flip_edges(mesh, {}, kept)) == 0) break;
    }
    if (std::count(std::begin(kTradeRounds), std::end(kTradeRounds), round) > 0) {
      const SurfaceMesh before = mesh;
      trade_edges(outline.source, kBadAngle, mesh, on_line);
      if (guarded && count_crossings(mesh) > allowed) mesh = before;
    }
    moving.find_neighbours();
    const Vec3Array before = mesh.vertices;
    if (round < kSmoothRounds) {
      moving.smooth();
    } else {
      moving.repair();
    }
    if (guarded) undo_crossings(before, allowed, mesh);
  }
}

}  // namespace

void improve_triangles(const SurfaceMesh& surface, const SourceSurface& source, const Kept& kept,
                       SurfaceMesh& mesh) {
  const Outline outline{surface, source, kept, BorderLines(surface)};
  SurfaceMesh improved = mesh;
  run_rounds(outline, false, improved);
  // to look for crossings after every round is slow, and rarely needed
  if (count_crossings(improved) > count_crossings(mesh)) {
    improved = mesh;
    run_rounds(outline, true, improved);
  }
  mesh = std::move(improved);
}

}  // namespace palpate::authoring
