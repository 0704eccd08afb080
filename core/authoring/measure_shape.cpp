// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/measure_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "palpate/authoring/triangle_shape.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/tree/queries.h"

namespace palpate::authoring {
namespace {

constexpr int kAngleSteps = 18;
constexpr int kLengthSteps = 20;

/// [-] of the diagonal: a look begins this far behind its triangle, so as not to see that.
constexpr double kBehind = 1e-6;

double mean_edge(const Corners& x) {
  return ((x[1] - x[0]).norm() + (x[2] - x[1]).norm() + (x[0] - x[2]).norm()) / 3.0;
}

std::vector<double> list_lengths(const SurfaceMesh& mesh) {
  std::vector<double> lengths;
  for (const auto& [i, j] : build_topology(mesh.triangles).edges) {
    lengths.push_back((mesh.vertices[j] - mesh.vertices[i]).norm());
  }
  return lengths;
}

/// Counts ascending values in `steps` steps of equal ratio; zeros with the shortest.
Histogram count_by_ratio(const std::vector<double>& ascending, int steps) {
  const auto first = std::upper_bound(ascending.begin(), ascending.end(), 0.0);
  if (first == ascending.end()) return {};
  const double low = *first, high = ascending.back(), ratio = std::log(high / low);
  if (!(ratio > 0.0)) return {{low, high}, {static_cast<int>(ascending.size())}};
  Histogram found;
  found.counts.assign(steps, 0);
  for (int i = 0; i <= steps; ++i) found.limits.push_back(low * std::exp(ratio * i / steps));
  found.limits.back() = high;
  for (const double value : ascending) {
    const double place = value > low ? steps * std::log(value / low) / ratio : 0.0;
    ++found.counts[std::clamp(static_cast<int>(place), 0, steps - 1)];
  }
  return found;
}

bool is_finite(const SurfaceMesh& mesh) {
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                     [](const Vec3& x) { return x.allFinite(); });
}

/// [m] From the middle of a triangle straight inwards to where the surface is left.
std::optional<double> look_behind(const AabbTree& tree, const SurfaceMesh& mesh, double gap,
                                  int face) {
  const Corners x = corners_of(mesh, mesh.triangles[face]);
  const Vec3 normal = normal_of(x), middle = (x[0] + x[1] + x[2]) / 3.0;
  if (!(normal.norm() > 0.0)) return std::nullopt;
  const Vec3 inward = -normal.normalized();
  const auto hit = find_ray_hit(tree, mesh.vertices, middle + gap * inward, inward);
  if (!hit || !(normal_of(corners_of(mesh, mesh.triangles[hit->triangle])).dot(inward) > 0.0)) {
    return std::nullopt;
  }
  return hit->distance + gap;
}

}  // namespace

Histogram count_angles(const SurfaceMesh& mesh) {
  Histogram found;
  found.counts.assign(kAngleSteps, 0);
  for (int i = 0; i <= kAngleSteps; ++i) found.limits.push_back(180.0 * i / kAngleSteps);
  for (const Triangle& t : mesh.triangles) {
    const Corners x = corners_of(mesh, t);
    for (int c = 0; c < 3; ++c) {
      const double angle = angle_at(x[c], x[(c + 1) % 3], x[(c + 2) % 3]) / std::numbers::pi;
      ++found.counts[std::clamp(static_cast<int>(kAngleSteps * angle), 0, kAngleSteps - 1)];
    }
  }
  return found;
}

EdgeLengths measure_edges(const SurfaceMesh& mesh) {
  std::vector<double> lengths = list_lengths(mesh);
  if (lengths.empty()) return {};
  std::sort(lengths.begin(), lengths.end());
  return {lengths.front(), lengths[lengths.size() / 2], lengths.back(),
          count_by_ratio(lengths, kLengthSteps)};
}

Thickness measure_thickness(const SurfaceMesh& mesh) {
  if (mesh.triangles.empty() || !is_finite(mesh)) return {};
  const AabbTree tree(mesh.vertices, mesh.triangles);
  const double gap = kBehind * compute_diagonal(mesh.vertices);
  const int count = static_cast<int>(mesh.triangles.size());
  Thickness found;
  for (int look = 0; look < std::min(count, kThicknessLooks); ++look) {
    const int face =
        static_cast<int>(static_cast<long>(look) * count / std::min(count, kThicknessLooks));
    const std::optional<double> thickness = look_behind(tree, mesh, gap, face);
    if (!thickness) continue;
    ++found.looks;
    found.thinnest = std::min(*thickness, found.thinnest.value_or(*thickness));
    const double edge = mean_edge(corners_of(mesh, mesh.triangles[face]));
    if (*thickness < kThinPart * edge) found.thin_faces.push_back(face);
  }
  return found;
}

std::vector<double> list_thicknesses(const SurfaceMesh& mesh) {
  const AabbTree tree(mesh.vertices, mesh.triangles);
  const double gap = kBehind * compute_diagonal(mesh.vertices);
  std::vector<double> found;
  for (int face = 0; face < static_cast<int>(mesh.triangles.size()); ++face) {
    found.push_back(
        look_behind(tree, mesh, gap, face).value_or(std::numeric_limits<double>::infinity()));
  }
  return found;
}

}  // namespace palpate::authoring
