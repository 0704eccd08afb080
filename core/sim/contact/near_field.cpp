// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/response/private/free_stiffness.h"

namespace palpate {
namespace {

/// The surface of a model at rest, and how its vertices hang on particles.
struct Surface {
  explicit Surface(const TissueModel& m)
      : model(m),
        mesh{compute_surface(m, m.rest_position), m.triangles},
        normals(compute_vertex_normals(mesh.vertices, mesh.triangles)),
        touched(mesh.vertices.size(), false) {
    for (const Triangle& t : mesh.triangles) {
      for (const int v : t) touched[static_cast<std::size_t>(v)] = true;
    }
  }

  std::size_t size() const { return mesh.vertices.size(); }
  const Vec3& x(std::size_t v) const { return mesh.vertices[v]; }

  const TissueModel& model;
  SurfaceMesh mesh;           // [m]
  Vec3Array normals;          // unit
  std::vector<bool> touched;  // a corner of a triangle: not one inside of a solid
};

/// Calls take(coordinate of the free, part) for what a vertex moves along its normal with.
template <class Take>
void for_each_carrier(const Surface& surface, const FreeStiffness& stiffness, std::size_t v,
                      Take take) {
  const auto visit = [&](int particle, double weight) {
    const Eigen::Index at = stiffness.place(3 * Eigen::Index{particle});
    if (at < 0) return;
    for (int axis = 0; axis < 3; ++axis) take(at + axis, weight * surface.normals[v][axis]);
  };
  const Skin& skin = surface.model.skin;
  if (skin.corners.empty()) return visit(static_cast<int>(v), 1.0);
  for (std::size_t k = 0; k < 4; ++k) visit(skin.corners[v][k], skin.weights[v][k]);
}

/// A force [N] along its normal on a vertex, one of the sides.
void push(const Surface& surface, const FreeStiffness& stiffness, std::size_t v, double f,
          Eigen::Index side, Sides& force) {
  for_each_carrier(surface, stiffness, v,
                   [&](Eigen::Index at, double part) { force(at, side) += f * part; });
}

/// [m] along its normal.
double find_displacement(const Surface& surface, const FreeStiffness& stiffness, std::size_t v,
                         const Sides& u, Eigen::Index side) {
  double sum = 0.0;
  for_each_carrier(surface, stiffness, v,
                   [&](Eigen::Index at, double part) { sum += part * u(at, side); });
  return sum;
}

/// [1/m] How fast normals turn along the edges at each vertex, their mean.
std::vector<double> compute_curvature(const Surface& surface) {
  std::vector<double> sum(surface.size(), 0.0), count(surface.size(), 0.0);
  for (const Triangle& t : surface.mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto i = static_cast<std::size_t>(t[c]), j = static_cast<std::size_t>(t[(c + 1) % 3]);
      const Vec3 edge = surface.x(j) - surface.x(i);
      const double turned = (surface.normals[j] - surface.normals[i]).dot(edge);
      if (!(edge.squaredNorm() > 0.0)) continue;
      for (const std::size_t v : {i, j}) {
        sum[v] += turned / edge.squaredNorm();
        count[v] += 1.0;
      }
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= std::max(1.0, count[v]);
  return sum;
}

/// The vertices around one of the surface, itself among them; none around another.
std::vector<std::size_t> find_neighbours(const Surface& surface, std::size_t v, double reach) {
  std::vector<std::size_t> near;
  if (!surface.touched[v]) return near;
  for (std::size_t u = 0; u < surface.size(); ++u) {
    if (surface.touched[u] && (surface.x(u) - surface.x(v)).norm() < reach) near.push_back(u);
  }
  return near;
}

/// [m] The longest edges that are not rare: of the triangles by which touch is coarsest.
double find_edge_length(const Surface& surface) {
  std::vector<double> squares;
  for (const Triangle& t : surface.mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto i = static_cast<std::size_t>(t[c]), j = static_cast<std::size_t>(t[(c + 1) % 3]);
      squares.push_back((surface.x(j) - surface.x(i)).squaredNorm());
    }
  }
  const auto at = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() * 9 / 10);
  std::nth_element(squares.begin(), at, squares.end());
  return std::sqrt(*at);
}

/// The radius of a uniform patch [m] whose compliance the mesh can tell: two edges of the elements
/// that carry it.
constexpr double kPatchEdges = 2.0;
/// and no less than this, where elements are finer than what is near
constexpr double kLeastPatch = 0.008;

/// [m] Edges of the elements, or of the surface where that is all there is.
double find_patch_radius(const Surface& surface) {
  double longest = 0.0;
  const auto& elements = surface.model.skin.corners;
  for (const auto& corners : elements) {
    for (std::size_t c = 1; c < 4; ++c) {
      const Vec3 edge = surface.model.rest_position[static_cast<std::size_t>(corners[c])] -
                        surface.model.rest_position[static_cast<std::size_t>(corners[0])];
      longest += edge.norm() / (3.0 * static_cast<double>(elements.size()));
    }
  }
  if (elements.empty()) longest = find_edge_length(surface);
  return std::max(kLeastPatch, kPatchEdges * longest);
}

/// A uniform pressure, by what of it vertices carry.
struct Patch {
  std::vector<std::size_t> vertices;
  std::vector<double> weights;  // sum to 1
};

Patch make_patch(const Surface& surface, const std::vector<double>& area, std::size_t v,
                 double radius) {
  Patch patch{find_neighbours(surface, v, radius), {}};
  double sum = 0.0;
  for (const std::size_t u : patch.vertices) sum += area[u];
  for (const std::size_t u : patch.vertices) patch.weights.push_back(area[u] / sum);
  return patch;
}

/// [m²] The mean of squared distances between any two points of a patch: twice that from their
/// middle.
double measure_spread(const Surface& surface, const Patch& patch) {
  Vec3 middle = Vec3::Zero();
  double squares = 0.0;
  for (std::size_t k = 0; k < patch.vertices.size(); ++k) {
    middle += patch.weights[k] * surface.x(patch.vertices[k]);
  }
  for (std::size_t k = 0; k < patch.vertices.size(); ++k) {
    squares += patch.weights[k] * (surface.x(patch.vertices[k]) - middle).squaredNorm();
  }
  return 2.0 * squares;
}

/// A uniform pressure on a disc of radius a moves a half space by 16 / (3 pi² E* a), the mean over
/// the disc [Johnson85, 3.4]. Here the patch is what vertices carry: `a` is the radius of the disc
/// whose points are as far apart, on the mean of squares.
double find_far_compliance(double modulus, double compliance, double spread) {
  constexpr double kPi = std::numbers::pi;
  // a patch of one vertex, or of none, tells nothing
  if (!(spread > 0.0)) return 0.0;
  return compliance - 16.0 / (3.0 * kPi * kPi * modulus * std::sqrt(spread));
}

void require_positive(const char* what, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  refuse(std::string("near field: ") + what, write_text(value), "a positive number");
}

/// What vertices from `begin` up to `end` and those around them do under unit forces.
void solve_around(const Surface& surface, const FreeStiffness& stiffness, const Factors& factors,
                  std::size_t begin, std::size_t end, double reach, NearField& near) {
  Sides force = Sides::Zero(3 * stiffness.count, kAtOnce);
  for (std::size_t v = begin; v < end; ++v) {
    push(surface, stiffness, v, 1.0, static_cast<Eigen::Index>(v - begin), force);
  }
  const Sides u = solve(factors, force);
  for (std::size_t v = begin; v < end; ++v) {
    for (const std::size_t other : find_neighbours(surface, v, reach)) {
      near.neighbour.push_back(static_cast<int>(other));
      near.compliance.push_back(static_cast<float>(
          find_displacement(surface, stiffness, other, u, static_cast<Eigen::Index>(v - begin))));
    }
    near.first.push_back(static_cast<int>(near.neighbour.size()));
  }
}

/// The far compliance of the same, each under a patch of its own.
void solve_far(const Surface& surface, const FreeStiffness& stiffness, const Factors& factors,
               const std::vector<double>& area, double radius, std::size_t begin, std::size_t end,
               NearField& near) {
  std::vector<Patch> patches;
  Sides force = Sides::Zero(3 * stiffness.count, kAtOnce);
  for (std::size_t v = begin; v < end; ++v) {
    const Patch& patch = patches.emplace_back(make_patch(surface, area, v, radius));
    for (std::size_t k = 0; k < patch.vertices.size(); ++k) {
      push(surface, stiffness, patch.vertices[k], patch.weights[k],
           static_cast<Eigen::Index>(v - begin), force);
    }
  }
  const Sides u = solve(factors, force);
  for (std::size_t v = begin; v < end; ++v) {
    const Patch& patch = patches[v - begin];
    double compliance = 0.0;
    for (std::size_t k = 0; k < patch.vertices.size(); ++k) {
      compliance += patch.weights[k] * find_displacement(surface, stiffness, patch.vertices[k], u,
                                                         static_cast<Eigen::Index>(v - begin));
    }
    near.far_compliance[v] =
        find_far_compliance(near.modulus, compliance, measure_spread(surface, patch));
  }
}

/// Weak springs hold a body that nothing holds. What they let it move as a whole is in the
/// compliance of a patch and in the far compliance alike, and only their difference counts.
void ground(FreeStiffness& stiffness, Factors& factors) {
  constexpr double kPart = 1e-2;
  const double mean = stiffness.matrix.diagonal().mean();
  SparseMatrix springs(stiffness.matrix.rows(), stiffness.matrix.cols());
  springs.setIdentity();
  stiffness.matrix += kPart * mean * springs;
  if (factor(stiffness, factors)) return;
  refuse("near field: tissue", "a stiffness that cannot be solved with", "one that is positive");
}

}  // namespace

NearContacts::NearContacts(int triangles, int vertices)
    : triangle(static_cast<std::size_t>(triangles)),
      closest(static_cast<std::size_t>(triangles)),
      contact(static_cast<std::size_t>(triangles)),
      weight(static_cast<std::size_t>(vertices), 0.0) {}

NearField build_near_field(const TissueModel& model, double modulus, double radius) {
  require_positive("modulus [Pa]", modulus);
  require_positive("radius [m]", radius);
  const Surface surface(model);
  FreeStiffness stiffness(model);
  Factors factors;
  if (!factor(stiffness, factors)) ground(stiffness, factors);

  NearField near;
  near.modulus = modulus;
  near.far_compliance.assign(surface.size(), 0.0);
  near.curvature = compute_curvature(surface);
  near.first.push_back(0);
  const double reach = 2.0 * (radius + find_edge_length(surface));
  const double patch = find_patch_radius(surface);
  const std::vector<double> area = compute_vertex_areas(surface.mesh);
  constexpr auto kSides = static_cast<std::size_t>(kAtOnce);
  for (std::size_t begin = 0; begin < surface.size(); begin += kSides) {
    const std::size_t end = std::min(begin + kSides, surface.size());
    const auto inner = surface.touched.begin();
    if (std::none_of(inner + static_cast<std::ptrdiff_t>(begin),
                     inner + static_cast<std::ptrdiff_t>(end), std::identity())) {
      near.first.resize(end + 1, near.first.back());
      continue;
    }
    solve_around(surface, stiffness, factors, begin, end, reach, near);
    solve_far(surface, stiffness, factors, area, patch, begin, end, near);
  }
  return near;
}

}  // namespace palpate
