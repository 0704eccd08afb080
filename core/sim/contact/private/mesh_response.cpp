// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/mesh_response.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace palpate {
namespace {

/// Calls take(contact, corner, vertex, part of the force) for the corners of contacts.
template <class Take>
void for_each_corner(std::span<const Triangle> triangles, const NearContacts& contacts,
                     Take take) noexcept {
  for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
    const Contact& contact = contacts.contact[i];
    const Triangle& triangle = triangles[static_cast<std::size_t>(contacts.triangle[i])];
    for (std::size_t c = 0; c < 3; ++c) {
      take(i, c, static_cast<std::size_t>(triangle[c]),
           contact.force * contact.weights[static_cast<Eigen::Index>(c)]);
    }
  }
}

/// A triangle, for find_gradient() of its corners.
struct Slopes {
  Slopes(const TouchedSurface& surface, int triangle) noexcept {
    const Triangle& t = surface.triangles[static_cast<std::size_t>(triangle)];
    for (std::size_t c = 0; c < 3; ++c) corners[c] = surface.x[static_cast<std::size_t>(t[c])];
    across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    square = std::max(across.squaredNorm(), 1e-300);
  }

  std::array<Vec3, 3> corners;  ///< [m]
  Vec3 across;                  ///< [m²]
  double square = 0.0;          ///< [m⁴]
};

/// [1/m] Of the barycentric weight of a corner, along the triangle: also how its normal turns where
/// that corner alone sinks.
Vec3 find_gradient(const Slopes& slopes, std::size_t corner) noexcept {
  const auto& at = slopes.corners;
  return slopes.across.cross(at[(corner + 2) % 3] - at[(corner + 1) % 3]) / slopes.square;
}

/// As compute_response(); its tilt is what `take(place, corner, moved, tilt)` makes of it.
template <class Take>
MeshResponse sum_response(const TouchedSurface& surface, const NearContacts& other,
                          NearContacts& contacts, Take take) noexcept {
  const NearField& near = *surface.near;
  std::vector<double>& weight = contacts.weight;
  double pushed = 0.0, felt = 0.0;
  for_each_corner(surface.triangles, other,
                  [&](std::size_t, std::size_t, std::size_t v, double part) noexcept {
                    weight[v] += part;
                    pushed += part;
                  });
  MeshResponse sum;
  for_each_corner(surface.triangles, contacts,
                  [&](std::size_t i, std::size_t c, std::size_t v, double part) noexcept {
                    double moved = 0.0, known = 0.0;
                    for (auto k = static_cast<std::size_t>(near.first[v]);
                         k < static_cast<std::size_t>(near.first[v + 1]); ++k) {
                      const double w = weight[static_cast<std::size_t>(near.neighbour[k])];
                      moved += static_cast<double>(near.compliance[k]) * w;
                      known += w;
                    }
                    felt += part;
                    sum.compliance += part * moved;
                    sum.known += part * known;
                    take(i, c, moved, sum.tilt);
                  });
  for_each_corner(
      surface.triangles, other,
      [&](std::size_t, std::size_t, std::size_t v, double) noexcept { weight[v] = 0.0; });
  if (!(pushed * felt > 0.0)) return {};
  const double whole = 1.0 / (pushed * felt);
  return {sum.compliance * whole, sum.known * whole, sum.tilt * whole};
}

}  // namespace

MeshResponse compute_response(const TouchedSurface& surface, const NearContacts& other,
                              NearContacts& contacts) noexcept {
  std::optional<Slopes> slopes;
  std::size_t known = 0;
  return sum_response(surface, other, contacts,
                      [&](std::size_t i, std::size_t c, double moved, Vec3& tilt) noexcept {
                        if (!slopes || known != i) slopes.emplace(surface, contacts.triangle[i]);
                        known = i;
                        tilt += contacts.contact[i].force * moved * find_gradient(*slopes, c);
                      });
}

/// A force F_j at the distance D moves a half space by F_j/(pi E* D) [Boussinesq85], and the body
/// by its far compliance more; the mesh has moved by vᵀ G w of that. Where it has less, the dent is
/// shallower than it looks. Contacts farther away than G reaches are left to the mesh, as are those
/// on another side of the body. A wall's far compliance is not the same all around, and its prisms
/// bend as it does: it is left to them.
void find_crossings(const Tool& tool, const TouchedSurface& surface,
                    NearContacts& contacts) noexcept {
  const NearField& near = *surface.near;
  for (std::size_t j = 0; j < surface.others.size(); ++j) {
    const NearContacts& other = *surface.others[j];
    contacts.cross[j] = 0.0;
    if (!(other.force > 0.0) || near.wall_thickness > 0.0) continue;
    const MeshResponse mesh = sum_response(surface, other, contacts,
                                           [](std::size_t, std::size_t, double, Vec3&) noexcept {});
    const double distance = std::max((contacts.middle - other.middle).norm(), 2.0 * tool.radius);
    const double far = 0.5 * (contacts.far_compliance + other.far_compliance);
    const double truth = std::numbers::inv_pi / (near.modulus * distance) + far;
    const double alike = std::max(0.0, contacts.normal.dot(other.normal));
    contacts.cross[j] = alike * (mesh.known * truth - mesh.compliance);
  }
}

double sum_crossings(const TouchedSurface& surface, const NearContacts& contacts) noexcept {
  double sum = 0.0;
  for (std::size_t j = 0; j < surface.others.size(); ++j) {
    sum += contacts.cross[j] * surface.others[j]->force;
  }
  return sum;
}

/// The mesh has sunk under the ball, and its corners unevenly: a triangle is tilted where the dent
/// of tissue is even all around. Without that tilt the force goes along the ball's path less than
/// the triangle says, and acts where a line along it meets the ball's centre.
Contact level(const TouchedSurface& surface, const Vec3& tilt, const Axes& axes, const Vec3& p,
              int triangle, const Contact& soft) noexcept {
  constexpr double kMostTilt = 0.3;
  const double size = tilt.norm();
  if (!(soft.force > 0.0 && size > 0.0)) return soft;
  const Vec3 turn = std::min(1.0, kMostTilt / size) * tilt;
  Contact contact = soft;
  contact.direction = (soft.direction - turn).normalized();
  const Triangle& t = surface.triangles[static_cast<std::size_t>(triangle)];
  const Vec3 pressed = compute_point(t, soft.weights, surface.x);
  const double height = (find_nearest_on_axes(axes, p, pressed) - pressed).norm();
  const Slopes slopes(surface, triangle);
  for (std::size_t c = 0; c < 3; ++c) {
    contact.weights[static_cast<Eigen::Index>(c)] += height * turn.dot(find_gradient(slopes, c));
  }
  contact.weights = contact.weights.cwiseMax(0.0);
  contact.weights /= contact.weights.sum();
  return contact;
}

}  // namespace palpate
