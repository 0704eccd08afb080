// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
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
        normals(compute_vertex_normals(x, m.triangles)) {}

  /// Calls take(particle, weight) for what carries a vertex.
  template <class Take>
  void for_each_carrier(std::size_t v, Take take) const {
    if (model.skin.corners.empty()) return take(static_cast<int>(v), 1.0);
    for (std::size_t k = 0; k < 4; ++k) {
      take(model.skin.corners[v][k], model.skin.weights[v][k]);
    }
  }

  const TissueModel& model;
  Vec3Array x;        // [m]
  Vec3Array normals;  // unit
};

/// The unit force along its normal on a vertex, one of the sides.
void push(const Surface& surface, const FreeStiffness& stiffness, std::size_t v, Eigen::Index side,
          Sides& force) {
  surface.for_each_carrier(v, [&](int particle, double weight) {
    const Eigen::Index at = stiffness.place(3 * Eigen::Index{particle});
    if (at < 0) return;
    for (int axis = 0; axis < 3; ++axis) force(at + axis, side) += weight * surface.normals[v][axis];
  });
}

/// [m] along its normal.
double find_displacement(const Surface& surface, const FreeStiffness& stiffness, std::size_t v,
                         const Sides& u, Eigen::Index side) {
  double sum = 0.0;
  surface.for_each_carrier(v, [&](int particle, double weight) {
    const Eigen::Index at = stiffness.place(3 * Eigen::Index{particle});
    if (at < 0) return;
    for (int axis = 0; axis < 3; ++axis) sum += weight * surface.normals[v][axis] * u(at + axis, side);
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

std::vector<std::size_t> find_near(const Surface& surface, std::size_t v, double reach) {
  std::vector<std::size_t> near;
  for (std::size_t u = 0; u < surface.x.size(); ++u) {
    if ((surface.x[u] - surface.x[v]).norm() < reach) near.push_back(u);
  }
  return near;
}

void require_positive(const char* what, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  refuse(std::string("near field: ") + what, write_text(value), "a positive number");
}

void check_count(const char* what, std::size_t found, std::size_t expected) {
  if (found == expected) return;
  refuse(std::string("near field: ") + what, write_text(found, " values"), write_text(expected));
}

template <class Values>
void check_finite(const char* what, const Values& values) {
  for (const auto value : values) {
    if (std::isfinite(value)) continue;
    refuse(std::string("near field: ") + what, write_text(static_cast<double>(value)),
           "finite numbers");
  }
}

}  // namespace

NearContacts::NearContacts(int triangles, int vertices)
    : triangle(static_cast<std::size_t>(triangles)),
      closest(static_cast<std::size_t>(triangles)),
      contact(static_cast<std::size_t>(triangles)),
      weight(static_cast<std::size_t>(vertices), 0.0) {}

void validate(const NearField& near, int surface_vertices) {
  require_positive("modulus [Pa]", near.modulus);
  const auto n = static_cast<std::size_t>(surface_vertices);
  check_count("far_compliance", near.far_compliance.size(), n);
  check_count("curvature", near.curvature.size(), n);
  check_count("first", near.first.size(), n + 1);
  check_count("compliance", near.compliance.size(), near.neighbour.size());
  const auto count = static_cast<int>(near.neighbour.size());
  const bool ascends = std::ranges::is_sorted(near.first);
  if (!ascends || near.first.front() != 0 || near.first.back() != count) {
    refuse("near field: first", "rows that do not follow one another",
           write_text("ascending ones from 0 to ", count));
  }
  for (const int u : near.neighbour) {
    if (u >= 0 && u < surface_vertices) continue;
    refuse("near field: neighbour", write_text(u), write_text("0 to ", surface_vertices - 1));
  }
  check_finite("far_compliance", near.far_compliance);
  check_finite("curvature", near.curvature);
  check_finite("compliance", near.compliance);
}

NearField build_near_field(const TissueModel& model, double modulus, double reach) {
  require_positive("modulus [Pa]", modulus);
  require_positive("reach [m]", reach);
  const Surface surface(model);
  const FreeStiffness stiffness(model);
  Factors factors;
  factor("near field", stiffness, factors);

  NearField near;
  near.modulus = modulus;
  near.far_compliance.assign(surface.x.size(), 0.0);
  near.curvature = compute_curvature(surface);
  near.first.push_back(0);
  constexpr auto kSides = static_cast<std::size_t>(kAtOnce);
  for (std::size_t begin = 0; begin < surface.x.size(); begin += kSides) {
    const std::size_t end = std::min(begin + kSides, surface.x.size());
    Sides force = Sides::Zero(3 * stiffness.count, kAtOnce);
    for (std::size_t v = begin; v < end; ++v) {
      push(surface, stiffness, v, static_cast<Eigen::Index>(v - begin), force);
    }
    const Sides u = solve(factors, force);
    for (std::size_t v = begin; v < end; ++v) {
      for (const std::size_t other : find_near(surface, v, reach)) {
        const double moved = find_displacement(surface, stiffness, other, u,
                                               static_cast<Eigen::Index>(v - begin));
        near.neighbour.push_back(static_cast<int>(other));
        near.compliance.push_back(static_cast<float>(moved));
      }
      near.first.push_back(static_cast<int>(near.neighbour.size()));
    }
  }
  return near;
}

}  // namespace palpate
