// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/collision/private/choose_barrier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/collision/private/nearest.h"
#include "palpate/sim/collision/private/touching_surface.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/tree/aabb_tree.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {
namespace {

/// [kg/m³] Of soft tissue, where a body does not say its volume.
constexpr double kDensity = 1050.0;

double find_young(double lame, double shear) noexcept {
  return lame + shear > 0.0 ? shear * (3.0 * lame + 2.0 * shear) / (lame + shear) : 0.0;
}

double average(const std::vector<double>& values) noexcept {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

/// [J] Sum of k l² over springs and bonds.
double sum_links(const TissueModel& tissue) noexcept {
  double sum = 0.0;
  for (const Links* links : {&tissue.springs, &tissue.bonds}) {
    for (std::size_t l = 0; l < links->ends.size(); ++l) {
      sum += links->stiffness[l] * links->rest_length[l] * links->rest_length[l];
    }
  }
  return sum;
}

/// Springs of 5/2 mu sum V/L² have sum k L² = 15 mu V, a tetrahedron having six edges; the volume
/// term adds lambda - mu [laws: solid].
double estimate_of_springs(const TissueModel& tissue) noexcept {
  double volume = 0.0;
  for (const double v : tissue.volumes.rest_volume) volume += v;
  const double shear = sum_links(tissue) / (15.0 * volume);
  return find_young(average(tissue.volumes.bulk) + shear, shear);
}

/// Springs of E h sum A/L² have sum k L² = 3 E h A, a triangle having three sides.
double estimate_of_wall(const TissueModel& tissue) {
  const double area =
      compute_area({compute_surface(tissue, tissue.rest_position), tissue.triangles});
  const double wall = compute_total_mass(tissue) / (kDensity * area);
  return std::abs(sum_links(tissue)) / (3.0 * area * wall);
}

/// [m]
double average_side(const TissueModel& tissue) {
  const Vec3Array x = compute_surface(tissue, tissue.rest_position);
  double sum = 0.0;
  for (const auto& [i, j, k] : tissue.triangles) {
    const Vec3 a = x[static_cast<std::size_t>(i)], b = x[static_cast<std::size_t>(j)],
               c = x[static_cast<std::size_t>(k)];
    sum += (b - a).norm() + (c - b).norm() + (a - c).norm();
  }
  return sum / (3.0 * static_cast<double>(tissue.triangles.size()));
}

/// A surface at rest. Open ones have no inside.
struct RestSurface {
  explicit RestSurface(const TissueModel& tissue)
      : RestSurface(compute_surface(tissue, tissue.rest_position), tissue.triangles) {}
  RestSurface(Vec3Array vertices, std::vector<Triangle> its_triangles)
      : triangles(std::move(its_triangles)),
        x(std::move(vertices)),
        tree(x, triangles),
        closed(is_closed(triangles)) {}

  /// [m] To the nearest point within reach, below 0 from inside.
  double measure_gap(const Vec3& p, double reach) const {
    const bool within =
        ((tree.low() - p).array() < 0.0).all() && ((p - tree.high()).array() < 0.0).all();
    const auto found =
        within && closed ? find_closest_point(tree, x, p) : find_closest_point(tree, x, p, reach);
    if (!found) return reach;
    if (!closed) return found->distance;
    // over an edge, the steepest of its triangles tells the side
    double steepest = 0.0;
    std::vector<int> around(triangles.size());
    const int count = find_in_sphere(tree, x, p, found->distance * (1.0 + 1e-9), around);
    for (int n = 0; n < count; ++n) {
      const auto& [a, b, c] =
          triangles[static_cast<std::size_t>(around[static_cast<std::size_t>(n)])];
      const NearPoint near =
          find_near_point(p, x[static_cast<std::size_t>(a)], x[static_cast<std::size_t>(b)],
                          x[static_cast<std::size_t>(c)]);
      if (std::abs(near.height) > std::abs(steepest)) steepest = near.height;
    }
    return steepest < 0.0 ? -found->distance : found->distance;
  }

  std::vector<Triangle> triangles;
  Vec3Array x;
  AabbTree tree;
  bool closed;
};

/// An edge of a surface, and where another is crossed by it.
struct Crossing {
  double depth = 0.0;  ///< [m] that the nearer of its ends is from the other surface
  int vertex = -1;     ///< that end; none of the edges crosses it
};

/// Where edges of a surface cross another: of an open one, the only sign of what is in it.
/// `is_left_out(edge, triangle)` says what may cross.
template <class LeftOut>
Crossing find_crossing(const RestSurface& of, const RestSurface& other, LeftOut is_left_out) {
  Crossing deepest;
  for (const auto& [first, second] : build_topology(of.triangles).edges) {
    const Vec3 &a = of.x[static_cast<std::size_t>(first)],
               &b = of.x[static_cast<std::size_t>(second)];
    const auto hit = find_segment_hit(other.tree, other.x, a, b);
    if (!hit || is_left_out(std::array{first, second}, hit->triangle)) continue;
    const double from_a = find_closest_point(other.tree, other.x, a)->distance;
    const double from_b = find_closest_point(other.tree, other.x, b)->distance;
    const double depth = std::min(from_a, from_b);
    if (depth > deepest.depth) deepest = {depth, from_a < from_b ? first : second};
  }
  return deepest;
}

void check_constants(const std::string& where, const BodyPair& pair) {
  constexpr double kThickest = 5e-3;  // [m]
  if (!(pair.thickness >= 0.0 && pair.thickness <= kThickest)) {
    refuse(where + ".thickness [m]", write_text(pair.thickness),
           "0 to have it chosen, or up to 0.005");
  }
  if (!(pair.stiffness >= 0.0) || !std::isfinite(pair.stiffness)) {
    refuse(where + ".stiffness [N/m^3]", write_text(pair.stiffness),
           "0 to have it chosen, or a positive number");
  }
  if (!(pair.damping >= 0.0 && pair.damping <= 1.0)) {
    refuse(where + ".damping [-]", write_text(pair.damping), "0 to 1");
  }
  if (!(pair.friction >= 0.0) || !std::isfinite(pair.friction)) {
    refuse(where + ".friction [-]", write_text(pair.friction), "0, or a positive number");
  }
}

void check_apart(const std::string& where, const TissueModel& first, const TissueModel& second,
                 const BodyPair& pair) {
  const Nearest nearest = find_nearest_at_rest(first, second, pair.thickness);
  if (!(nearest.gap < 0.5 * pair.thickness)) return;
  const int of = nearest.of_first ? pair.first : pair.second;
  const int other = nearest.of_first ? pair.second : pair.first;
  const double distance = 1e3 * std::abs(nearest.gap);
  refuse(where,
         nearest.gap < 0.0 ? write_text("vertex ", nearest.vertex, " of body ", of, " ", distance,
                                        " mm inside of body ", other)
                           : write_text("vertex ", nearest.vertex, " of body ", of, " ", distance,
                                        " mm from body ", other),
         write_text("at least ", 0.5e3 * pair.thickness,
                    " mm between them at rest, half of the thickness: move one of them"));
}

}  // namespace

void choose_barrier(const std::string& where, const TissueModel& first, const TissueModel& second,
                    BodyPair& pair) {
  check_constants(where, pair);
  if (pair.thickness == 0.0) pair.thickness = choose_thickness(first, second);
  if (pair.stiffness == 0.0) {
    const double modulus = std::max(estimate_modulus(first), estimate_modulus(second));
    if (!(modulus > 0.0)) {
      refuse(where + ".stiffness [N/m^3]", "0",
             "a positive number for tissues without a modulus of their own");
    }
    pair.stiffness = modulus / (3.0 * pair.thickness);
  }
  if (pair.first != pair.second) check_apart(where, first, second, pair);
}

double choose_thickness(const TissueModel& first, const TissueModel& second) {
  constexpr double kOfSide = 0.15, kThinnest = 3e-4, kThickest = 5e-4;
  const double side = std::max(average_side(first), average_side(second));
  return std::clamp(kOfSide * side, kThinnest, kThickest);
}

Nearest find_nearest_at_rest(const TissueModel& first, const TissueModel& second, double reach) {
  const RestSurface surfaces[] = {RestSurface(first), RestSurface(second)};
  Nearest nearest{reach, -1, true};
  for (const bool of_first : {true, false}) {
    const RestSurface &from = surfaces[of_first ? 0 : 1], &to = surfaces[of_first ? 1 : 0];
    for (std::size_t v = 0; v < from.x.size(); ++v) {
      const double gap = to.measure_gap(from.x[v], reach);
      if (gap < nearest.gap) nearest = {gap, static_cast<int>(v), of_first};
    }
  }
  return nearest;
}

Nearest find_deepest_at_rest(const TissueModel& tissue, const SurfaceMesh& mesh) {
  constexpr double kRounding = 1e-9;  // [m]
  const std::vector<double> inverse_mass = invert_surface_masses(tissue);
  const auto is_held = [&](int v) { return inverse_mass[static_cast<std::size_t>(v)] == 0.0; };
  Nearest deepest{0.0, -1, true};
  const RestSurface body(tissue), hard(mesh.vertices, mesh.triangles);
  for (std::size_t v = 0; v < body.x.size(); ++v) {
    if (is_held(static_cast<int>(v))) continue;
    const double gap = hard.measure_gap(body.x[v], kRounding);
    if (gap < deepest.gap) deepest = {gap, static_cast<int>(v), true};
  }
  for (std::size_t v = 0; v < hard.x.size(); ++v) {
    const double gap = body.measure_gap(hard.x[v], kRounding);
    if (!(gap < deepest.gap)) continue;
    const auto nearest = find_closest_point(body.tree, body.x, hard.x[v]);
    if (std::ranges::any_of(tissue.triangles[static_cast<std::size_t>(nearest->triangle)],
                            is_held)) {
      continue;
    }
    deepest = {gap, static_cast<int>(v), false};
  }
  if (body.closed && hard.closed) return deepest;
  const auto holds = [&](std::span<const int> vertices) {
    return std::ranges::any_of(vertices, is_held);
  };
  const Crossing of_body =
      find_crossing(body, hard, [&](std::span<const int> edge, int) { return holds(edge); });
  if (of_body.depth > -deepest.gap) deepest = {-of_body.depth, of_body.vertex, true};
  if (deepest.vertex >= 0) return deepest;
  const Crossing of_hard = find_crossing(hard, body, [&](std::span<const int>, int triangle) {
    return holds(tissue.triangles[static_cast<std::size_t>(triangle)]);
  });
  return of_hard.vertex < 0 ? deepest : Nearest{-of_hard.depth, of_hard.vertex, false};
}

double estimate_modulus(const TissueModel& tissue) {
  for (const Hyperelastic* table : {&tissue.corotated, &tissue.neo_hookean}) {
    if (!table->corners.empty()) return find_young(average(table->lame), average(table->shear));
  }
  if (!tissue.elastic.corners.empty()) {
    return find_young(average(tissue.elastic.lame), average(tissue.elastic.shear));
  }
  const double found =
      tissue.volumes.corners.empty() ? estimate_of_wall(tissue) : estimate_of_springs(tissue);
  return std::isfinite(found) ? found : 0.0;
}

}  // namespace palpate
