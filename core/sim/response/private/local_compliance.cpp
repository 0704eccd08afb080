// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/response/private/local_compliance.h"

#include <array>

#include "palpate/sim/response/private/free_stiffness.h"

namespace palpate {
namespace {

/// [s] Over which the inertia of the particles still counts as support, so that what nothing holds
/// can be solved for: beside the stiffness of any tissue, nothing.
constexpr double kSlow = 3.0;

/// Which particles a point of the surface hangs on, and by how much.
struct Carriers {
  std::array<int, 12> particle{};
  std::array<double, 12> weight{};
  std::size_t count = 0;
};

Carriers find_carriers(const TissueModel& model, const Push& push) {
  Carriers carriers;
  const auto add = [&](int particle, double weight) {
    carriers.particle[carriers.count] = particle;
    carriers.weight[carriers.count++] = weight;
  };
  const Triangle& triangle = model.triangles[static_cast<std::size_t>(push.triangle)];
  for (std::size_t c = 0; c < 3; ++c) {
    const double part = push.weights[static_cast<Eigen::Index>(c)];
    const auto v = static_cast<std::size_t>(triangle[c]);
    if (model.skin.corners.empty()) {
      add(triangle[c], part);
      continue;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      add(model.skin.corners[v][k], part * model.skin.weights[v][k]);
    }
  }
  return carriers;
}

Vec3 compute_middle(std::span<const Carriers> points, std::span<const Vec3> x) {
  Vec3 sum = Vec3::Zero();
  for (const Carriers& point : points) {
    for (std::size_t k = 0; k < point.count; ++k) {
      sum += point.weight[k] * x[static_cast<std::size_t>(point.particle[k])];
    }
  }
  return sum / static_cast<double>(points.size());
}

/// The exact tangent where it is definite, else the projected one.
std::optional<FreeStiffness> factor_cut_out(const CutOut& cut, Factors& factors) {
  const bool symmetric =
      cut.model.angles.corners.empty() || cut.model.angle_law == AngleLaw::gradient;
  for (const Projection projection : {Projection::none, Projection::positive_semidefinite}) {
    if (projection == Projection::none && !symmetric) continue;
    FreeStiffness stiffness(cut.model, cut.x, projection);
    SparseMatrix inertia(3 * stiffness.count, 3 * stiffness.count);
    inertia.setIdentity();
    for (std::size_t i = 0; i < cut.model.mass.size(); ++i) {
      const int n = stiffness.number[i];
      if (n < 0) continue;
      for (int k = 0; k < 3; ++k) {
        inertia.coeffRef(3 * n + k, 3 * n + k) = cut.model.mass[i] / (kSlow * kSlow);
      }
    }
    stiffness.matrix += inertia;
    if (stiffness.count > 0 && factor(stiffness, factors)) return stiffness;
  }
  return std::nullopt;
}

/// (3 free, k) The points' directions, shared among the particles that carry them.
Eigen::MatrixXd spread(const FreeStiffness& stiffness, const std::vector<int>& number,
                       std::span<const Push> along, std::span<const Carriers> points) {
  Eigen::MatrixXd sides =
      Eigen::MatrixXd::Zero(3 * stiffness.count, static_cast<Eigen::Index>(along.size()));
  for (std::size_t p = 0; p < along.size(); ++p) {
    for (std::size_t k = 0; k < points[p].count; ++k) {
      const int inside = number[static_cast<std::size_t>(points[p].particle[k])];
      const int n = inside < 0 ? -1 : stiffness.number[static_cast<std::size_t>(inside)];
      if (n < 0) continue;
      sides.col(static_cast<Eigen::Index>(p)).segment<3>(3 * n) +=
          points[p].weight[k] * along[p].force;
    }
  }
  return sides;
}

}  // namespace

std::optional<Eigen::MatrixXd> compute_local_compliance(const TissueModel& model,
                                                        std::span<const Vec3> x,
                                                        std::span<const Push> along, int most) {
  if (along.empty()) return std::nullopt;
  std::vector<Carriers> points;
  std::vector<int> always;
  for (const Push& push : along) {
    points.push_back(find_carriers(model, push));
    const Carriers& point = points.back();
    always.insert(always.end(), point.particle.begin(),
                  point.particle.begin() + static_cast<std::ptrdiff_t>(point.count));
  }
  const CutOut cut = cut_out(model, x, compute_middle(points, x), most, always);
  Factors factors;
  const std::optional<FreeStiffness> stiffness = factor_cut_out(cut, factors);
  if (!stiffness) return std::nullopt;
  const Eigen::MatrixXd sides = spread(*stiffness, number_particles(cut, x.size()), along, points);
  const Eigen::MatrixXd compliance = sides.transpose() * factors.solve(sides);
  return Eigen::MatrixXd(0.5 * (compliance + compliance.transpose()));
}

}  // namespace palpate
