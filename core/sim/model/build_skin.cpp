// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <optional>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/model/build_solid.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {
namespace {

/// A vertex farther outside of its tetrahedron than that is high would swing about with it.
constexpr double kFarthestOutside = 1.0;

/// A tetrahedron's barycentric coordinates as a function of place.
struct Place {
  Place(const SolidMesh& solid, const std::array<int, 4>& corners)
      : origin(solid.vertices[corners[0]]) {
    Mat3 edges;
    for (int k = 0; k < 3; ++k) edges.col(k) = solid.vertices[corners[k + 1]] - origin;
    inverse = edges.inverse();
    middle = origin + 0.25 * edges.rowwise().sum();
    for (const int i : corners) {
      squared_radius = std::max(squared_radius, (solid.vertices[i] - middle).squaredNorm());
    }
  }

  std::array<double, 4> find_weights(const Vec3& p) const noexcept {
    const Vec3 w = inverse * (p - origin);
    return {1.0 - w.sum(), w[0], w[1], w[2]};
  }

  Vec3 origin, middle;
  Mat3 inverse;
  double squared_radius = 0.0;
};

/// The tetrahedron in which the smallest weight of a point is largest, and that weight: not below
/// 0 inside, and outside how many heights the point is away.
struct Seat {
  std::size_t tetrahedron = 0;
  double smallest_weight = -std::numeric_limits<double>::infinity();
  std::array<double, 4> weights{};
};

Seat find_seat(const std::vector<Place>& places, const Vec3& p, bool only_near) noexcept {
  Seat best;
  for (std::size_t t = 0; t < places.size(); ++t) {
    constexpr double kNear = 4.0;  // twice the radius about the middle
    const Place& place = places[t];
    if (only_near && (p - place.middle).squaredNorm() > kNear * place.squared_radius) continue;
    const auto weights = place.find_weights(p);
    const double smallest = std::min({weights[0], weights[1], weights[2], weights[3]});
    if (smallest > best.smallest_weight) best = {t, smallest, weights};
    if (smallest >= 0.0) break;
  }
  return best;
}

}  // namespace

Skin build_skin(const SurfaceMesh& surface, const SolidMesh& solid) {
  validate(surface);
  validate(solid);
  std::vector<Place> places;
  places.reserve(solid.tetrahedra.size());
  for (const auto& corners : solid.tetrahedra) places.emplace_back(solid, corners);
  Skin skin;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    Seat seat = find_seat(places, surface.vertices[v], true);
    if (!(seat.smallest_weight >= -kFarthestOutside)) {
      seat = find_seat(places, surface.vertices[v], false);
    }
    if (!(seat.smallest_weight >= -kFarthestOutside)) {
      refuse(
          write_text("skin: vertex ", v),
          write_text("outside by ", -seat.smallest_weight, " heights of the nearest tetrahedron"),
          write_text("at most ", kFarthestOutside, ": fill with smaller cells"));
    }
    skin.corners.push_back(solid.tetrahedra[seat.tetrahedron]);
    skin.weights.push_back(seat.weights);
  }
  return skin;
}

TissueModel cover_with_skin(TissueModel model, const SurfaceMesh& surface) {
  if (list_tetrahedra(model).empty()) {
    refuse("skin: model", "no tetrahedra", "a solid, as build_solid makes it");
  }
  model.skin = build_skin(surface, {model.rest_position, list_tetrahedra(model)});
  model.triangles = surface.triangles;
  validate(model);
  return model;
}

}  // namespace palpate
