// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/private/find_wall.h"
#include "palpate/sim/contact/private/near_contact.h"
#include "palpate/sim/contact/private/particle_forces.h"
#include "palpate/sim/mesh/mesh.h"

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

/// Calls take(free particle, part of it) for a force along its normal on a vertex.
template <class Take>
void for_each_carrier(const Surface& surface, const FreeStiffness& stiffness, std::size_t v,
                      Take take) {
  const auto visit = [&](int particle, double weight) {
    const int n = stiffness.number[static_cast<std::size_t>(particle)];
    if (n >= 0) take(n, Vec3(weight * surface.normals[v]));
  };
  const Skin& skin = surface.model.skin;
  if (skin.corners.empty()) return visit(static_cast<int>(v), 1.0);
  for (std::size_t k = 0; k < 4; ++k) visit(skin.corners[v][k], skin.weights[v][k]);
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

/// The touched vertices, by where they are along the longest axis of the surface.
class Vicinity {
 public:
  explicit Vicinity(const Surface& surface) : surface_(surface) {
    Vec3 low = surface.x(0), high = low;
    for (const Vec3& x : surface.mesh.vertices) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    (high - low).maxCoeff(&axis_);
    for (std::size_t v = 0; v < surface.size(); ++v) {
      if (surface.touched[v]) sorted_.push_back(v);
    }
    std::ranges::sort(sorted_, {}, [this](std::size_t v) { return along(v); });
  }

  /// The vertices around one, itself among them, ascending; none around what is not touched.
  std::vector<std::size_t> find(std::size_t v, double reach) const {
    std::vector<std::size_t> near;
    if (!surface_.touched[v]) return near;
    const auto place = [this](std::size_t u) { return along(u); };
    auto at = std::ranges::lower_bound(sorted_, along(v) - reach, {}, place);
    for (; at != sorted_.end() && along(*at) < along(v) + reach; ++at) {
      if ((surface_.x(*at) - surface_.x(v)).norm() < reach) near.push_back(*at);
    }
    std::ranges::sort(near);
    return near;
  }

 private:
  double along(std::size_t v) const { return surface_.x(v)[axis_]; }

  const Surface& surface_;
  Eigen::Index axis_ = 0;
  std::vector<std::size_t> sorted_;
};

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

/// The radius of a uniform patch [m] whose compliance the mesh can tell: edges of the elements
/// that carry it.
constexpr double kPatchEdges = 1.5;
/// and no less than this, where elements are finer than what is near
constexpr double kLeastPatch = 0.008;

/// A wall's patch has a vertex with those around it, for it bends within a few thicknesses; and is
/// no smaller than that, since prisms are a wall beyond those only.
constexpr double kWallPatchEdges = 1.3, kLeastWallPatch = 1.5;

/// [m] The mean edge of the surface.
double find_mean_edge(const Surface& surface) {
  double sum = 0.0;
  for (const Triangle& t : surface.mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum += (surface.x(static_cast<std::size_t>(t[(c + 1) % 3])) -
              surface.x(static_cast<std::size_t>(t[c])))
                 .norm();
    }
  }
  return sum / (3.0 * static_cast<double>(surface.mesh.triangles.size()));
}

/// [m] Edges of the elements, or of the surface where that is all there is; `wall` is 0 of a solid.
double find_patch_radius(const Surface& surface, double wall) {
  if (wall > 0.0) {
    return std::max(kLeastWallPatch * wall, kWallPatchEdges * find_mean_edge(surface));
  }
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

Patch make_patch(const Vicinity& vicinity, const std::vector<double>& area, std::size_t v,
                 double radius) {
  Patch patch{vicinity.find(v, radius), {}};
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

/// Forces along normals: one of 1 N on each vertex, and as many of 1 N on the patch of each.
class NormalForces {
 public:
  NormalForces(const Surface& surface, const FreeStiffness& stiffness)
      : surface_(surface),
        stiffness_(stiffness),
        sum_(static_cast<std::size_t>(stiffness.count), Vec3::Zero()) {}

  void push(std::size_t v, double part) {
    for_each_carrier(surface_, stiffness_, v, [&](int particle, const Vec3& along) {
      Vec3& sum = sum_[static_cast<std::size_t>(particle)];
      if (sum.isZero(0.0)) pushed_.push_back(particle);
      sum += part * along;
    });
  }

  /// What has been pushed since the last one is a force.
  void end() {
    std::ranges::sort(pushed_);
    for (const int particle : pushed_) {
      Vec3& sum = sum_[static_cast<std::size_t>(particle)];
      if (sum.isZero(0.0)) continue;
      all.particle.push_back(particle);
      all.part.push_back(sum);
      sum.setZero();
    }
    pushed_.clear();
    all.end();
  }

  ParticleForces all;

 private:
  const Surface& surface_;
  const FreeStiffness& stiffness_;
  Vec3Array sum_;  // [N] of the one being made
  std::vector<int> pushed_;
};

/// Of each vertex those that a ball may press as well.
void list_neighbours(const Surface& surface, const Vicinity& vicinity, double reach,
                     NearField& near) {
  near.first.push_back(0);
  for (std::size_t v = 0; v < surface.size(); ++v) {
    for (const std::size_t u : vicinity.find(v, reach))
      near.neighbour.push_back(static_cast<int>(u));
    near.first.push_back(static_cast<int>(near.neighbour.size()));
  }
}

/// Adds a patch of this radius around every vertex, each to be known with itself; how far its
/// points are apart.
std::vector<double> add_patches(const Surface& surface, const Vicinity& vicinity, double radius,
                                NormalForces& forces, ForcePairs& pairs) {
  const std::vector<double> area = compute_vertex_areas(surface.mesh);
  std::vector<double> spread(surface.size());
  for (std::size_t v = 0; v < surface.size(); ++v) {
    const Patch patch = make_patch(vicinity, area, v, radius);
    spread[v] = measure_spread(surface, patch);
    for (std::size_t k = 0; k < patch.vertices.size(); ++k) {
      forces.push(patch.vertices[k], patch.weights[k]);
    }
    pairs.other.push_back(static_cast<int>(forces.all.count()));
    pairs.first.push_back(static_cast<int>(pairs.other.size()));
    forces.end();
  }
  return spread;
}

/// What a wall gives way at a point, beyond a half space: what the mesh has of a patch, and how
/// much more tissue has under a point than prisms under that patch. A patch of one vertex, or of
/// none, tells nothing.
double find_wall_compliance(const WallLayer& wall, double compliance, double spread,
                            double foundation) {
  if (!(spread > 0.0)) return 0.0;
  return compliance - compute_prism_compliance(wall, spread, foundation) +
         compute_point_excess(wall, foundation);
}

/// Compliances between neighbours and, where `far` is empty, of each vertex's patch with itself.
void solve_near_field(const Surface& surface, const FreeStiffness& stiffness,
                      const Factors& factors, const Vicinity& vicinity,
                      std::span<const Symmetric> far, NearField& near) {
  const WallLayer wall = find_wall(surface.model, surface.mesh, near.modulus);
  near.wall_thickness = wall.thickness;
  if (!far.empty() && wall.thickness > 0.0) {
    refuse("near field: far", "that of a wall of prisms", "none, or a solid");
  }
  const std::size_t count = surface.size();
  NormalForces forces(surface, stiffness);
  for (std::size_t v = 0; v < count; ++v) {
    if (surface.touched[v]) forces.push(v, 1.0);
    forces.end();
  }
  ForcePairs pairs{near.first, near.neighbour};
  std::vector<double> spread;
  if (far.empty()) {
    const double radius = find_patch_radius(surface, wall.thickness);
    spread = add_patches(surface, vicinity, radius, forces, pairs);
  }
  const std::vector<double> found = solve_compliances(stiffness, factors, forces.all, pairs);
  const std::size_t between = near.neighbour.size();
  near.compliance.assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(between));
  near.far_tensor.assign(far.begin(), far.end());
  for (std::size_t v = 0; v < far.size(); ++v) {
    near.far_compliance.push_back(compute_along(far[v], surface.normals[v]));
  }
  if (!far.empty()) return;
  std::vector<double> hold;
  if (wall.thickness > 0.0) {
    hold = find_foundations(surface.model, surface.mesh, surface.normals, wall);
  }
  for (std::size_t v = 0; v < count; ++v) {
    const double patch = found[between + v];
    near.far_compliance.push_back(hold.empty()
                                      ? find_far_compliance(near.modulus, patch, spread[v])
                                      : find_wall_compliance(wall, patch, spread[v], hold[v]));
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

NearContacts::NearContacts(int triangles, int vertices, int others)
    : triangle(static_cast<std::size_t>(triangles)),
      closest(static_cast<std::size_t>(triangles)),
      contact(static_cast<std::size_t>(triangles)),
      weight(static_cast<std::size_t>(vertices), 0.0),
      cross(static_cast<std::size_t>(others), 0.0) {}

NearField build_near_field(const TissueModel& model, double modulus, double radius,
                           std::span<const Symmetric> far, bool facets) {
  require_positive("modulus [Pa]", modulus);
  require_positive("radius [m]", radius);
  const Surface surface(model);
  if (!far.empty() && far.size() != surface.size()) {
    refuse("near field: far", write_text(far.size(), " tensors"),
           write_text(surface.size(), ", one per vertex of the surface"));
  }
  if (facets && !model.prisms.corners.empty()) {
    refuse("near field: facets", "those of a wall of prisms", "none, or a solid");
  }
  FreeStiffness stiffness(model);
  Factors factors;
  if (!factor(stiffness, factors)) ground(stiffness, factors);

  NearField near;
  near.modulus = modulus;
  near.curvature = compute_curvature(surface);
  if (facets) near.rest_position = surface.mesh.vertices;
  const Vicinity vicinity(surface);
  list_neighbours(surface, vicinity, 2.0 * (radius + find_edge_length(surface)), near);
  solve_near_field(surface, stiffness, factors, vicinity, far, near);
  return near;
}

}  // namespace palpate
