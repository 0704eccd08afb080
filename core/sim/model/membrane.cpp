// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/membrane.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/model/definiteness.h"

namespace palpate {
namespace {

/// Lamé's two of plane stress times the wall's thickness [N/m].
struct WallModuli {
  explicit WallModuli(const Material& material) {
    validate(material);
    if (!material.wall_thickness) {
      refuse("material: wall_thickness", "none", "the thickness of the wall [m]");
    }
    const double e = material.young_modulus * *material.wall_thickness, nu = material.poisson_ratio;
    lambda = e * nu / (1.0 - nu * nu);
    mu = 0.5 * e / (1.0 + nu);
  }

  /// Of strain written as (xx, yy, sqrt(2) xy), in which turning the axes turns a vector.
  Mat3 in_strain() const {
    Mat3 c = 2.0 * mu * Mat3::Identity();
    c.topLeftCorner<2, 2>().array() += lambda;
    return c;
  }

  double lambda, mu;
};

/// A triangle at rest. The cotangents come from its sides as vectors, which keeps all digits of
/// a needle's angles.
struct Shape {
  explicit Shape(const std::array<Vec3, 3>& corners) {
    for (int c = 0; c < 3; ++c) {
      side[c] = corners[(c + 2) % 3] - corners[(c + 1) % 3];
      length[c] = side[c].norm();
    }
    const Vec3 normal = side[0].cross(side[1]);
    area = 0.5 * normal.norm();
    for (int c = 0; c < 3; ++c) {
      cotangent[c] = -side[(c + 1) % 3].dot(side[(c + 2) % 3]) / (2.0 * area);
      smallest_angle = std::min(smallest_angle, std::atan2(1.0, cotangent[c]));
    }
  }

  void require_angles(const std::string& where) const {
    const double degrees = smallest_angle * 180.0 / std::numbers::pi;
    if (area > 0.0 && degrees >= kSmallestAngle) return;
    refuse(where, write_text("a smallest angle of ", area > 0.0 ? degrees : 0.0, " degrees"),
           write_text("at least ", kSmallestAngle, " degrees"));
  }

  Mat3 compute_stiffness(const WallModuli& wall) const {
    Mat3 h;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        h(i, j) = length[i] * length[j] / (4.0 * area) *
                  ((wall.lambda + 2.0 * wall.mu) * cotangent[i] * cotangent[j] +
                   wall.mu * (i == j ? 1.0 : -1.0));
      }
    }
    return h;
  }

  /// Row c says what a strain in the triangle's plane does to the length of side c [m].
  Mat3 compute_lengthening() const {
    const Vec3 x = side[0] / length[0];
    const Vec3 y = side[0].cross(side[1]).cross(side[0]).normalized();
    Mat3 rows;
    for (int c = 0; c < 3; ++c) {
      const double along = side[c].dot(x) / length[c], across = side[c].dot(y) / length[c];
      rows.row(c) =
          length[c] * Vec3(along * along, across * across, std::numbers::sqrt2 * along * across);
    }
    return rows;
  }

  std::array<Vec3, 3> side;
  std::array<double, 3> length, cotangent;
  double area = 0.0, smallest_angle = std::numeric_limits<double>::infinity();
};

/// What the tables of a model give to each triangle of its surface.
class TriangleShares {
 public:
  explicit TriangleShares(const TissueModel& model)
      : model_(model),
        topology_(build_topology(model.triangles)),
        row_(model.triangles.size(), -1) {
    std::map<Triangle, int> rows;
    for (std::size_t a = 0; a < model.angles.corners.size(); ++a) {
      rows[model.angles.corners[a]] = static_cast<int>(a);
    }
    std::map<std::array<int, 2>, double> stiffness;
    for (const Links* links : {&model.springs, &model.bonds}) {
      for (std::size_t l = 0; l < links->ends.size(); ++l) {
        stiffness[links->ends[l]] += links->stiffness[l];
      }
    }
    for (std::size_t t = 0; t < model.triangles.size(); ++t) {
      const auto found = rows.find(model.triangles[t]);
      if (found != rows.end()) row_[t] = found->second;
      for (int c = 0; c < 3 && row_[t] >= 0; ++c) {
        stiffness[topology_.edges[topology_.triangle_edges[t][c]]] -=
            model.angles.bond_share[row_[t]][c];
      }
    }
    for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
      const double count = topology_.edge_triangles[e][1] < 0 ? 1.0 : 2.0;
      equal_part_.push_back(stiffness[topology_.edges[e]] / count);
    }
  }

  Mat3 compute_stiffness(std::size_t t) const {
    Mat3 k = row_[t] < 0 ? Mat3(Mat3::Zero())
                         : compute_rest_slopes(model_.angles, row_[t], model_.angle_law);
    for (int c = 0; c < 3; ++c) k(c, c) += equal_part_[topology_.triangle_edges[t][c]];
    return k;
  }

 private:
  const TissueModel& model_;
  Topology topology_;
  std::vector<int> row_;            ///< of each triangle in the table of angles; -1 for none
  std::vector<double> equal_part_;  ///< [N/m] of each edge, for each of its triangles
};

/// The isotropic membrane nearest to `c` in the sum of squares.
void fit_isotropic(const Mat3& c, double thickness, MembraneFit& fit) {
  const double bulk = 0.25 * (c(0, 0) + c(1, 1) + c(0, 1) + c(1, 0));
  const double shear = 0.25 * (c.trace() - 2.0 * bulk);
  fit.young_modulus = 4.0 * bulk * shear / ((bulk + shear) * thickness);
  fit.poisson_ratio = (bulk - shear) / (bulk + shear);
}

}  // namespace

std::vector<Mat3> compute_membrane_stiffnesses(const SurfaceMesh& mesh, const Material& material) {
  const WallModuli wall(material);
  std::vector<Mat3> stiffnesses;
  stiffnesses.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [i, j, k] = mesh.triangles[t];
    const Shape shape({mesh.vertices[i], mesh.vertices[j], mesh.vertices[k]});
    shape.require_angles(write_text("mesh: triangle ", t));
    stiffnesses.push_back(shape.compute_stiffness(wall));
  }
  return stiffnesses;
}

/// In a strain e a triangle of area A holds e·C e A/2, C = Rᵀ K R / A with R from strain to
/// lengths. The stiffness in a strain, in parts of the material's, lies between the eigenvalues
/// of C against the material's C.
MembraneFit compare_with_membrane(const TissueModel& model, const Material& material,
                                  const std::vector<double>& stiffness_scale) {
  if (model.triangles.empty()) refuse("model: triangles", "none", "a surface");
  const Mat3 wall = WallModuli(material).in_strain();
  const TriangleShares shares(model);
  MembraneFit fit;
  fit.least = std::numeric_limits<double>::infinity();
  fit.most = -fit.least;
  Mat3 sum = Mat3::Zero();
  double area = 0.0, squares = 0.0, worst = -1.0;
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    const auto [i, j, k] = model.triangles[t];
    const auto& x = model.rest_position;
    const Shape shape({x[i], x[j], x[k]});
    shape.require_angles(write_text("mesh: triangle ", t));
    double scale = 1.0;
    if (!stiffness_scale.empty()) {
      scale = (stiffness_scale[i] + stiffness_scale[j] + stiffness_scale[k]) / 3.0;
    }
    const Mat3 r = shape.compute_lengthening();
    const Mat3 c = r.transpose() * shares.compute_stiffness(t) * r / (scale * shape.area);
    const Mat3 symmetric = 0.5 * (c + c.transpose());
    const Vec3 ratios =
        Eigen::GeneralizedSelfAdjointEigenSolver<Mat3>(symmetric, wall, Eigen::EigenvaluesOnly)
            .eigenvalues();
    fit.least = std::min(fit.least, ratios[0]);
    fit.most = std::max(fit.most, ratios[2]);
    const double error = (c - wall).norm() / wall.norm();
    if (error > worst) worst = error, fit.worst_triangle = static_cast<int>(t);
    sum += shape.area * c;
    squares += shape.area * error * error;
    area += shape.area;
  }
  fit.error = std::sqrt(squares / area);
  fit_isotropic(sum / area, *material.wall_thickness, fit);
  return fit;
}

std::string describe(const MembraneFit& fit) {
  return write_text("stretches like a wall of E = ", 1e-3 * fit.young_modulus,
                    " kPa, nu = ", fit.poisson_ratio, "; by direction and place ", fit.least,
                    " to ", fit.most, " times as stiff as the material; error ", 100.0 * fit.error,
                    " %, largest in triangle ", fit.worst_triangle);
}

}  // namespace palpate
