// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/find_wall.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/model/private/prism_shear.h"

namespace palpate {
namespace {

/// [Pa] Of the springs that keep the faces of a wall apart, E A/h.
double measure_young(const TissueModel& model, const std::vector<double>& area, double thickness) {
  double stiffness = 0.0, whole = 0.0;
  for (const double k : model.springs.stiffness) stiffness += k;
  for (const double a : area) whole += a;
  return stiffness * thickness / whole;
}

/// [1/m²] per vertex, the mean square of how fast normals turn along edges there and at all
/// vertices around: of a sphere 1/R², of a tube 3/8 of it.
std::vector<double> compute_square_curvature(const SurfaceMesh& surface, const Vec3Array& normals) {
  std::vector<double> sum(surface.vertices.size(), 0.0), count(sum.size(), 0.0);
  const auto spread = [&](auto from, auto count_of) {
    std::vector<double> all(sum.size(), 0.0), number(sum.size(), 0.0);
    for (const Triangle& t : surface.triangles) {
      for (std::size_t c = 0; c < 3; ++c) {
        const auto i = static_cast<std::size_t>(t[c]), j = static_cast<std::size_t>(t[(c + 1) % 3]);
        for (const std::size_t v : {i, j}) {
          all[v] += from(i, j);
          number[v] += count_of(i, j);
        }
      }
    }
    sum = std::move(all);
    count = std::move(number);
  };
  spread(
      [&](std::size_t i, std::size_t j) {
        const Vec3 edge = surface.vertices[j] - surface.vertices[i];
        const double turned = (normals[j] - normals[i]).dot(edge);
        const double square = edge.squaredNorm();
        return square > 0.0 ? turned * turned / (square * square) : 0.0;
      },
      [](std::size_t, std::size_t) { return 1.0; });
  const std::vector<double> own = sum, edges = count;
  spread([&](std::size_t i, std::size_t j) { return own[i] + own[j]; },
         [&](std::size_t i, std::size_t j) { return edges[i] + edges[j]; });
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= std::max(1.0, count[v]);
  return sum;
}

/// [m] per vertex, to the nearest that is fixed; of a body that nothing holds, its half.
std::vector<double> measure_free(const TissueModel& model, const SurfaceMesh& surface) {
  Vec3 low = surface.vertices[0], high = low;
  for (const Vec3& x : surface.vertices) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  std::vector<double> free(surface.vertices.size(), 0.5 * (high - low).norm());
  for (const int f : model.fixed) {
    const Vec3& held = model.rest_position[static_cast<std::size_t>(f)];
    for (std::size_t v = 0; v < free.size(); ++v) {
      free[v] = std::min(free[v], (surface.vertices[v] - held).norm());
    }
  }
  return free;
}

}  // namespace

/// The height of prisms is h/sqrt(3).
WallLayer find_wall(const TissueModel& model, const SurfaceMesh& surface, double modulus) {
  WallLayer wall;
  wall.modulus = modulus;
  const auto& prisms = model.prisms.corners;
  if (prisms.empty()) return wall;
  double height = 0.0, longest = 0.0;
  for (const auto& corners : prisms) {
    const auto at = [&](std::size_t k) -> const Vec3& {
      return model.rest_position[static_cast<std::size_t>(corners[k])];
    };
    double side = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      height += (at(3 + c) - at(c)).norm() / 3.0;
      side = std::max(side, (at(3 + (c + 1) % 3) - at(3 + c)).norm());
    }
    longest += side;
  }
  const auto count = static_cast<double>(prisms.size());
  wall.thickness = std::sqrt(3.0) * height / count;
  const double young = measure_young(model, compute_vertex_areas(surface), wall.thickness);
  wall.young = std::clamp(young, 0.75 * modulus, modulus);
  wall.unlocked = find_unlocked_shear(wall.thickness, longest / count);
  return wall;
}

/// A wave across a bend of the curvature c is held by E h c² [Reissner46]; a round
/// plate that is clamped at the distance b sinks near a point as one does without end on the
/// foundation whose length (D/K)^(1/4) is b/1.85 [contact: walls].
std::vector<double> find_foundations(const TissueModel& model, const SurfaceMesh& surface,
                                     const Vec3Array& normals, const WallLayer& wall) {
  constexpr double kClamped = 1.85;
  const double h = wall.thickness, bend = wall.modulus * h * h * h / 12.0;
  const std::vector<double> square = compute_square_curvature(surface, normals);
  const std::vector<double> free = measure_free(model, surface);
  const std::vector<double> area = compute_vertex_areas(surface);
  std::vector<double> found(surface.vertices.size());
  for (std::size_t v = 0; v < found.size(); ++v) {
    found[v] = wall.young * h * square[v] + bend * std::pow(kClamped / std::max(free[v], h), 4);
    if (v < model.home.size() && area[v] > 0.0) found[v] += model.home[v] / area[v];
  }
  return found;
}

}  // namespace palpate
