// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/decimate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "palpate/authoring/collapse_edges.h"
#include "palpate/authoring/feature_lines.h"
#include "palpate/authoring/improve_triangles.h"
#include "palpate/authoring/measure_shape.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/authoring/surface_distance.h"
#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {
namespace {

/// [-] Ridges that hang together to less than so many edges of the new surface are noise.
constexpr double kLeastRidge = 3.0;
/// [-] How many times thinner than its edges a part may be and still count for more.
constexpr double kMostThin = 2.0;
/// [degree] Of good triangles.
constexpr double kLeastAngle = 20.0;
/// [-] How much further from the source good triangles may be than those that keep ridges.
constexpr double kMostDistance = 1.25;
/// [-] Of the vertices, those that are on lines: more leave too few for the shape between them.
constexpr double kMostOnLines = 0.7, kMostWithNames = 1.0 / 3.0;

double to_degrees(double angle) { return angle * 180.0 / std::numbers::pi; }

void measure(const SurfaceMesh& from, const SourceSurface& source, DecimatedMesh& to) {
  const SurfaceDistance there = measure_distance(to.mesh, from, source);
  const SurfaceDistance back = measure_distance(from, to.mesh, SourceSurface(to.mesh));
  to.mean_distance = there.mean;
  to.max_distance = std::max(there.most, back.most);
}

void validate_count(const SurfaceMesh& mesh, int vertex_count) {
  const int most = static_cast<int>(mesh.vertices.size());
  if (vertex_count >= 4 && vertex_count <= most) return;
  throw std::invalid_argument("decimate: vertex_count must be 4 to " + std::to_string(most) +
                              ", the vertices of the mesh, got " + std::to_string(vertex_count));
}

void validate_numbers(const SurfaceMesh& mesh, const std::vector<int>& regions,
                      const std::string& name) {
  if (regions.empty() || regions.size() == mesh.triangles.size()) return;
  throw std::invalid_argument("decimate: " + name + ": got " + std::to_string(regions.size()) +
                              " numbers, expected one for each of " +
                              std::to_string(mesh.triangles.size()) + " triangles");
}

/// [m] The edge of equilateral triangles of that area and about two for each vertex.
double find_edge(const SurfaceMesh& mesh, int vertex_count) {
  return std::sqrt(2.0 * compute_area(mesh) / (std::numbers::sqrt3 * vertex_count));
}

/// [-] (t) Where the body is thinner than the new edges are long, a distance counts as a part of
/// its thickness, not of theirs.
std::vector<double> weigh_thin(const SurfaceMesh& mesh, double edge) {
  std::vector<double> weights;
  for (const double thickness : list_thicknesses(mesh)) {
    const double ratio = std::clamp(edge / thickness, 1.0, kMostThin);
    weights.push_back(ratio * ratio);
  }
  return weights;
}

struct Choice {
  LineOptions lines;
  double most;  ///< [-] of the vertices that may be on lines
};

/// What is asked for: all of it, without names, without ridges, nothing.
std::vector<Choice> list_choices(const DecimateOptions& options, double edge) {
  const double least = kLeastRidge * edge;
  std::vector<Choice> choices;
  if (!options.names.empty()) {
    choices.push_back({{options.regions, options.names, options.features, least}, kMostWithNames});
  }
  if (options.features) choices.push_back({{options.regions, {}, true, least}, kMostOnLines});
  if (!options.regions.empty()) choices.push_back({{options.regions, {}, false, 0}, kMostOnLines});
  choices.push_back({{}, 1.0});
  return choices;
}

/// The collapsed mesh with as many of the lines as it has room for.
CollapsedMesh collapse(const SurfaceMesh& mesh, int vertex_count, const DecimateOptions& options,
                       DecimatedMesh& result) {
  const double edge = find_edge(mesh, vertex_count);
  const std::vector<double> weights =
      options.features ? weigh_thin(mesh, edge) : std::vector<double>();
  double wanted = 0.0;
  CollapsedMesh collapsed;
  for (const Choice& choice : list_choices(options, edge)) {
    const FeatureLines lines = find_feature_lines(mesh, choice.lines);
    wanted = std::max(wanted, lines.length());
    const double on_lines = std::max<double>(lines.count_needed(), lines.length() / edge);
    if (on_lines > choice.most * vertex_count) continue;
    collapsed = collapse_edges(mesh, vertex_count, lines, weights);
    result.kept_length = lines.length();
    if (static_cast<int>(collapsed.mesh.vertices.size()) == vertex_count) break;
  }
  result.left_out_length = wanted - result.kept_length;
  return collapsed;
}

/// As asked, whatever angles come of it.
DecimatedMesh decimate_once(const SurfaceMesh& mesh, int vertex_count,
                            const DecimateOptions& options) {
  DecimatedMesh result{};
  CollapsedMesh collapsed = collapse(mesh, vertex_count, options, result);
  result.mesh = std::move(collapsed.mesh);
  const int reached = static_cast<int>(result.mesh.vertices.size());
  if (reached != vertex_count) {
    throw std::invalid_argument("decimate: vertex_count must be at least " +
                                std::to_string(reached) + ", as far as this mesh goes, got " +
                                std::to_string(vertex_count));
  }
  result.smallest_angle_before_deg = to_degrees(compute_smallest_angle(result.mesh));

  const SourceSurface source(mesh);
  improve_triangles(mesh, source, {std::move(collapsed.lines), options.features}, result.mesh);
  validate(result.mesh);
  result.smallest_angle_deg = to_degrees(compute_smallest_angle(result.mesh));
  measure(mesh, source, result);
  if (const auto faces = find_self_intersecting_faces(result.mesh)) {
    result.self_intersecting_faces = static_cast<int>(faces->size());
  }
  return result;
}

}  // namespace

DecimatedMesh decimate(const SurfaceMesh& mesh, int vertex_count, const DecimateOptions& options) {
  validate(mesh);
  validate_count(mesh, vertex_count);
  validate_numbers(mesh, options.regions, "regions");
  validate_numbers(mesh, options.names, "names");
  DecimatedMesh result = decimate_once(mesh, vertex_count, options);
  if (!options.features || result.smallest_angle_deg >= kLeastAngle) return result;

  // ridges that leave flat triangles are worth it where they keep the shape alone
  DecimatedMesh plain = decimate_once(mesh, vertex_count, {options.regions, options.names, false});
  if (plain.smallest_angle_deg < kLeastAngle) return result;
  if (plain.max_distance > kMostDistance * result.max_distance) return result;
  plain.left_out_length = result.kept_length + result.left_out_length - plain.kept_length;
  return plain;
}

}  // namespace palpate::authoring
