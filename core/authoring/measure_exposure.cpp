// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/measure_exposure.h"

#include <algorithm>

#include "palpate/authoring/spread_directions.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/tree/queries.h"

namespace palpate::authoring {
namespace {

/// [-] of the diagonal: a look begins this far off its triangle, so as not to meet that.
constexpr double kOff = 1e-6;

std::vector<std::vector<int>> list_shells(const SurfaceMesh& mesh) {
  const std::vector<int> shell =
      find_shells(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  std::vector<std::vector<int>> faces;
  if (!shell.empty()) faces.resize(*std::max_element(shell.begin(), shell.end()) + 1);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    faces[shell[mesh.triangles[t][0]]].push_back(t);
  }
  return faces;
}

}  // namespace

std::vector<double> measure_exposure(const SurfaceMesh& mesh) {
  const std::vector<std::vector<int>> shells = list_shells(mesh);
  if (shells.empty()) return {};
  const AabbTree tree(mesh.vertices, mesh.triangles);
  const Vec3Array directions = spread_directions(kDirections);
  const double off = kOff * compute_diagonal(mesh.vertices);
  const auto is_seen = [&](const Triangle& t) {
    const Vec3 middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    int free = 0;
    for (const Vec3& direction : directions) {
      free += !find_ray_hit(tree, mesh.vertices, middle + off * direction, direction);
    }
    return free >= kLeastFree;
  };

  std::vector<double> exposed;
  for (const std::vector<int>& faces : shells) {
    const std::size_t looks = std::min<std::size_t>(faces.size(), kExposureLooks);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < looks; ++i) {
      seen += is_seen(mesh.triangles[faces[i * faces.size() / looks]]);
    }
    exposed.push_back(static_cast<double>(seen) / static_cast<double>(looks));
  }
  return exposed;
}

}  // namespace palpate::authoring
