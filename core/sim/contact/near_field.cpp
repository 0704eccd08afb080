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
        x(compute_surface(m, m.rest_position)),
        normals(compute_vertex_normals(x, m.triangles)),
        touched(x.size(), false) {
    for (const Triangle& t : m.triangles) {
      for (const int v : t) touched[static_cast<std::size_t>(v)] = true;
    }
  }

  /// Calls take(particle, weight) for what carries a vertex.
  template <class Take>
  void for_each_carrier(std::size_t v, Take take) const {
    if (model.skin.corners.empty()) return take(static_cast<int>(v), 1.0);
    for (std::size_t k = 0; k < 4; ++k) {
      take(model.skin.corners[v][k], model.skin.weights[v][k]);
    }
  }

  const TissueModel& model;
  Vec3Array x;                // [m]
  Vec3Array normals;          // unit
  std::vector<bool> touched;  // a corner of a triangle: not one inside of a solid
};

/// A force [N] along its normal on a vertex, one of the sides.
void push(const Surface& surface, const FreeStiffness& stiffness, std::size_t v, double f,
          Eigen::Index side, Sides& force) {
  surface.for_each_carrier(v, [&](int particle, double weight) {
    const Eigen::Index at = stiffness.place(3 * Eigen::Index{particle});
    if (at < 0) return;
    for (int axis = 0; axis < 3; ++axis)
      force(at + axis, side) += f * weight * surface.normals[v][axis];
  });
}

/// [m] along its normal.
double find_displacement(const Surface& surface, const FreeStiffness& stiffness, std::size_t v,
                         const Sides& u, Eigen::Index side) {
  double sum = 0.0;
  surface.for_each_carrier(v, [&](int particle, double weight) {
    const Eigen::Index at = stiffness.place(3 * Eigen::Index{particle});
    if (at < 0) return;
    for (int axis = 0; axis < 3; ++axis)
      sum += weight * surface.normals[v][axis] * u(at + axis, side);
  });
  return sum;
}

/// [1/m] How fast normals turn along the edges at each vertex, their mean.
std::vector<double> compute_curvature(const Surface& surface) {
  std::vector<double> sum(surface.x.size(), 0.0), count(surface.x.size(), 0.0);
  for (const Triangle& t : surface.model.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto i = static_cast<std::size_t>(t[c]), j = static_cast<std::size_t>(t[(c + 1) % 3]);
      const Vec3 edge = surface.x[j] - surface.x[i];
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
  for (std::size_t u = 0; u < surface.x.size(); ++u) {
    if (surface.touched[u] && (surface.x[u] - surface.x[v]).norm() < reach) near.push_back(u);
  }
  return near;
}

/// [m²] Of the surface, a third of each triangle to each of its corners.
std::vector<double> share_area(const Surface& surface) {
  std::vector<double> area(surface.x.size(), 0.0);
  for (const auto& [i, j, k] : surface.model.triangles) {
    const Vec3 across = (surface.x[j] - surface.x[i]).cross(surface.x[k] - surface.x[i]);
    for (const int v : {i, j, k}) area[static_cast<std::size_t>(v)] += across.norm() / 6.0;
  }
  return area;
}

/// [m] The longest edges that are not rare: of the triangles by which touch is coarsest.
double find_edge_length(const Surface& surface) {
  std::vector<double> squares;
  for (const Triangle& t : surface.model.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto i = static_cast<std::size_t>(t[c]), j = static_cast<std::size_t>(t[(c + 1) % 3]);
      squares.push_back((surface.x[j] - surface.x[i]).squaredNorm());
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

/// A uniform pressure on a disc of radius a moves a half space by 16 / (3 pi² E* a), the mean over
/// the disc [Johnson85, 3.4]. Here the patch is what vertices carry: `a` is the radius of the disc
/// whose points are as far apart, on the mean of squares.
double find_far_compliance(const NearField& near, const Surface& surface,
                           const std::vector<double>& weight, const std::vector<std::size_t>& patch,
                           const Eigen::VectorXd& moved) {
  double spread = 0.0, compliance = 0.0;
  for (const std::size_t u : patch) {
    compliance += weight[u] * moved[static_cast<Eigen::Index>(u)];
    for (const std::size_t w : patch) {
      spread += weight[u] * weight[w] * (surface.x[u] - surface.x[w]).squaredNorm();
    }
  }
  // a patch of one vertex, or of none, tells nothing
  if (!(spread > 0.0)) return 0.0;
  const double radius = std::sqrt(spread);
  constexpr double kPi = std::numbers::pi;
  return compliance - 16.0 / (3.0 * kPi * kPi * near.modulus * radius);
}

void require_positive(const char* what, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  refuse(std::string("near field: ") + what, write_text(value), "a positive number");
}

}  // namespace

NearContacts::NearContacts(int triangles, int vertices)
    : triangle(static_cast<std::size_t>(triangles)),
      closest(static_cast<std::size_t>(triangles)),
      contact(static_cast<std::size_t>(triangles)),
      weight(static_cast<std::size_t>(vertices), 0.0) {}

namespace {

/// What vertices do under unit forces, and under uniform patches, around `begin` up to `end`.
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

void solve_far(const Surface& surface, const FreeStiffness& stiffness, const Factors& factors,
               const std::vector<double>& area, double radius, std::size_t begin, std::size_t end,
               NearField& near) {
  std::vector<std::vector<std::size_t>> patches;
  std::vector<std::vector<double>> weights;
  Sides force = Sides::Zero(3 * stiffness.count, kAtOnce);
  for (std::size_t v = begin; v < end; ++v) {
    const std::vector<std::size_t> around = find_neighbours(surface, v, radius);
    std::vector<double> weight(surface.x.size(), 0.0);
    double sum = 0.0;
    for (const std::size_t w : around) sum += area[w];
    for (const std::size_t w : around) {
      weight[w] = sum > 0.0 ? area[w] / sum : 1.0;
      push(surface, stiffness, w, weight[w], static_cast<Eigen::Index>(v - begin), force);
    }
    patches.push_back(around);
    weights.push_back(std::move(weight));
  }
  const Sides u = solve(factors, force);
  Eigen::VectorXd moved(static_cast<Eigen::Index>(surface.x.size()));
  for (std::size_t v = begin; v < end; ++v) {
    for (const std::size_t w : patches[v - begin]) {
      moved[static_cast<Eigen::Index>(w)] =
          find_displacement(surface, stiffness, w, u, static_cast<Eigen::Index>(v - begin));
    }
    near.far_compliance[v] =
        find_far_compliance(near, surface, weights[v - begin], patches[v - begin], moved);
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

NearField build_near_field(const TissueModel& model, double modulus, double radius) {
  require_positive("modulus [Pa]", modulus);
  require_positive("radius [m]", radius);
  const Surface surface(model);
  FreeStiffness stiffness(model);
  Factors factors;
  if (!factor(stiffness, factors)) ground(stiffness, factors);

  NearField near;
  near.modulus = modulus;
  near.far_compliance.assign(surface.x.size(), 0.0);
  near.curvature = compute_curvature(surface);
  near.first.push_back(0);
  const double reach = 2.0 * (radius + find_edge_length(surface));
  const double patch = find_patch_radius(surface);
  const std::vector<double> area = share_area(surface);
  constexpr auto kSides = static_cast<std::size_t>(kAtOnce);
  for (std::size_t begin = 0; begin < surface.x.size(); begin += kSides) {
    const std::size_t end = std::min(begin + kSides, surface.x.size());
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
