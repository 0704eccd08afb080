// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/private/inner_face.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "palpate/sim/base/private/refuse.h"

namespace palpate {
namespace {

/// [-] What a depth is reduced to at once where a triangle would be lost.
constexpr double kReduced = 0.9;
/// [-] How much of the way to a neighbour the depth may grow: prisms between them stay upright.
constexpr double kSlope = 0.5;
/// [-] Of a triangle's sides: what passes so near beside one is on it, and on its neighbour too.
constexpr double kEdge = 1e-9;

Vec3 compute_area_vector(const Vec3Array& x, const Triangle& t) {
  return 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
}

/// [-] Of the area of a triangle that is left below it; negative for one turned over.
double compute_share(const SurfaceMesh& outer, const SurfaceMesh& inner, std::size_t t) {
  const Vec3 out = compute_area_vector(outer.vertices, outer.triangles[t]);
  return compute_area_vector(inner.vertices, outer.triangles[t]).dot(out) / out.squaredNorm();
}

/// Triangles by the cubes of space that their boxes reach into.
class Grid {
 public:
  Grid(const SurfaceMesh& mesh, double cell) : mesh_(mesh), cell_(cell) {
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      Vec3 low = mesh.vertices[mesh.triangles[t][0]], high = low;
      for (const int v : mesh.triangles[t]) {
        low = low.cwiseMin(mesh.vertices[v]);
        high = high.cwiseMax(mesh.vertices[v]);
      }
      visit(low, high, [&](std::uint64_t key) { entries_.emplace_back(key, t); });
    }
    std::sort(entries_.begin(), entries_.end());
  }

  /// [m] From vertex v along `way`, of unit length, to where the body is left; nothing within
  /// `reach` [m]. Triangles of v itself do not count.
  std::optional<double> find_exit(int v, const Vec3& way, double reach) const {
    const Vec3 from = mesh_.vertices[v], to = from + reach * way;
    std::optional<double> least;
    visit(from.cwiseMin(to), from.cwiseMax(to), [&](std::uint64_t key) {
      auto entry = std::lower_bound(entries_.begin(), entries_.end(), std::pair(key, 0));
      for (; entry != entries_.end() && entry->first == key; ++entry) {
        const std::optional<double> hit = find_hit(entry->second, v, way);
        if (hit && *hit < std::min(reach, least.value_or(reach))) least = hit;
      }
    });
    return least;
  }

 private:
  template <class Visit>
  void visit(const Vec3& low, const Vec3& high, Visit visit) const {
    const auto at = [&](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
    const auto part = [](std::int64_t i) { return static_cast<std::uint64_t>(i) & 0x1fffffU; };
    for (std::int64_t i = at(low.x()); i <= at(high.x()); ++i) {
      for (std::int64_t j = at(low.y()); j <= at(high.y()); ++j) {
        for (std::int64_t k = at(low.z()); k <= at(high.z()); ++k) {
          visit(part(i) << 42U | part(j) << 21U | part(k));
        }
      }
    }
  }

  /// [MollerTrumbore97], for triangles that are seen from inside.
  std::optional<double> find_hit(int t, int v, const Vec3& way) const {
    const Triangle& corners = mesh_.triangles[t];
    if (std::find(corners.begin(), corners.end(), v) != corners.end()) return std::nullopt;
    const Vec3& a = mesh_.vertices[corners[0]];
    const Vec3 e = mesh_.vertices[corners[1]] - a, f = mesh_.vertices[corners[2]] - a;
    const double facing = e.cross(f).dot(way);
    if (!(facing > 0.0)) return std::nullopt;
    const Vec3 s = mesh_.vertices[v] - a, across = s.cross(way);
    const double u = -f.dot(across) / facing, w = e.dot(across) / facing;
    if (u < -kEdge || w < -kEdge || u + w > 1.0 + kEdge) return std::nullopt;
    const double distance = -s.dot(e.cross(f)) / facing;
    return distance > 0.0 ? std::optional(distance) : std::nullopt;
  }

  const SurfaceMesh& mesh_;
  double cell_;
  std::vector<std::pair<std::uint64_t, int>> entries_;
};

void move_inwards(const SurfaceMesh& outer, const Vec3Array& normals, InnerFace& face) {
  for (std::size_t i = 0; i < normals.size(); ++i) {
    face.mesh.vertices[i] = outer.vertices[i] - face.depth[i] * normals[i];
  }
}

/// [m] The mean edge of the triangles.
double find_mean_edge(const SurfaceMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c) sum += (mesh.vertices[t[(c + 1) % 3]] - mesh.vertices[t[c]]).norm();
  }
  return sum / (3.0 * static_cast<double>(mesh.triangles.size()));
}

/// Half a body at most belongs to the wall of each side.
void limit_to_body(const SurfaceMesh& mesh, const Vec3Array& normals, double distance,
                   std::vector<double>& depth) {
  const double reach = distance / kFarShare;
  // cubes as small as a thin wall would be more than there is memory for
  const Grid grid(mesh, std::max(reach, find_mean_edge(mesh)));
  for (int i = 0; i < static_cast<int>(normals.size()); ++i) {
    if (!(normals[i].squaredNorm() > 0.0)) continue;
    const std::optional<double> exit = grid.find_exit(i, -normals[i], reach);
    if (exit) depth[i] = std::max(kLeastDepth * distance, kFarShare * *exit);
  }
}

/// Lets depths grow no faster than kSlope over an edge, from the reduced ones outwards.
void limit_slope(const SurfaceMesh& mesh, std::vector<double>& depth) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const Triangle& t : mesh.triangles) {
      for (int c = 0; c < 3; ++c) {
        const int i = t[c], j = t[(c + 1) % 3];
        const double most = kSlope * (mesh.vertices[i] - mesh.vertices[j]).norm();
        for (const auto& [low, high] : {std::pair(i, j), std::pair(j, i)}) {
          if (depth[high] <= (1.0 + 1e-9) * (depth[low] + most)) continue;
          depth[high] = depth[low] + most;
          changed = true;
        }
      }
    }
  }
}

/// Reduces depths until every triangle has enough of its area left, or can be reduced no more.
void heal_bends(const SurfaceMesh& outer, const Vec3Array& normals, double distance,
                InnerFace& face) {
  for (;;) {
    std::vector<char> is_bad(normals.size(), 0);
    bool any = false;
    for (std::size_t t = 0; t < outer.triangles.size(); ++t) {
      if (compute_share(outer, face.mesh, t) >= kLeastInnerArea) continue;
      for (const int v : outer.triangles[t]) {
        is_bad[v] = face.depth[v] > kLeastDepth * distance;
        any = any || is_bad[v];
      }
    }
    if (!any) return;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      if (is_bad[i]) face.depth[i] = std::max(kLeastDepth * distance, kReduced * face.depth[i]);
    }
    limit_slope(outer, face.depth);
    move_inwards(outer, normals, face);
  }
}

[[noreturn]] void refuse_at(std::size_t t, double distance, double share) {
  refuse(write_text("mesh: triangle ", t),
         write_text("an inner face, ", 1e3 * distance, " mm below, of ", 100.0 * share,
                    " % of its area"),
         write_text("at least ", 100.0 * kLeastInnerArea,
                    " %: a thinner wall, or a surface with wider bends"));
}

}  // namespace

InnerFace make_inner_face(const SurfaceMesh& mesh, double distance) {
  const Vec3Array normals = compute_vertex_normals(mesh.vertices, mesh.triangles);
  InnerFace whole{mesh, std::vector<double>(normals.size(), distance)};
  move_inwards(mesh, normals, whole);
  InnerFace face = whole;
  limit_to_body(mesh, normals, distance, face.depth);
  limit_slope(mesh, face.depth);
  move_inwards(mesh, normals, face);
  heal_bends(mesh, normals, distance, face);

  const auto reduced = std::ranges::count_if(face.depth, [&](double d) { return d < distance; });
  const bool too_many =
      static_cast<double>(reduced) > kMostReduced * static_cast<double>(normals.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double share = compute_share(mesh, whole.mesh, t);
    const bool is_lost = compute_share(mesh, face.mesh, t) < kLeastInnerArea;
    if (is_lost || (too_many && share < kLeastInnerArea)) refuse_at(t, distance, share);
  }
  return face;
}

}  // namespace palpate
