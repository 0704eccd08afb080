// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/response/private/free_stiffness.h"
#include "palpate/sim/response/response.h"

namespace palpate {
namespace {

/// Per particle, whether it carries some of the surface: that of the triangles.
std::vector<bool> mark_carriers(const TissueModel& model) {
  std::vector<bool> carries(model.rest_position.size(), false);
  for (const Triangle& triangle : model.triangles) {
    for (const int vertex : triangle) {
      const auto v = static_cast<std::size_t>(vertex);
      if (model.skin.corners.empty()) {
        carries[v] = true;
        continue;
      }
      for (const int i : model.skin.corners[v]) carries[static_cast<std::size_t>(i)] = true;
    }
  }
  for (const int i : model.fixed) carries[static_cast<std::size_t>(i)] = false;
  return carries;
}

/// Which particles move and which of them can be pushed; nothing is solved for.
Response list_particles(const TissueModel& model) {
  Response response;
  const std::vector<bool> carries = mark_carriers(model);
  const std::vector<int>& reach = model.elastic.reach;
  response.row.assign(carries.size(), -1);
  response.column.assign(carries.size(), -1);
  for (std::size_t i = 0; i < carries.size(); ++i) {
    if (!carries[i]) continue;
    const auto particle = static_cast<int>(i);
    response.row[i] = response.size.moved++;
    response.particle.push_back(particle);
    if (!reach.empty() && !std::binary_search(reach.begin(), reach.end(), particle)) continue;
    response.column[i] = response.size.pushed++;
  }
  response.size.bytes = 9 * sizeof(float) * static_cast<std::size_t>(response.size.moved) *
                        static_cast<std::size_t>(response.size.pushed);
  response.damping_time = model.elastic.damping_time;
  return response;
}

void check_size(const ResponseSize& size, std::size_t most) {
  constexpr double kMega = 1e6;
  if (size.pushed == 0) {
    refuse("linear solid: reach", "no particle of the surface that moves", "at least one");
  }
  if (size.bytes <= most) return;
  refuse("linear solid: response",
         write_text(static_cast<double>(size.bytes) / kMega, " MB for ", size.moved,
                    " particles under pushes on ", size.pushed),
         write_text("at most ", static_cast<double>(most) / kMega,
                    " MB: fill with fewer tetrahedra, or limit the reach of pushes"));
}

/// Writes the surface's part of displacements of all free particles.
template <class Displacements>
void keep(const FreeStiffness& stiffness, const Response& response, const Displacements& u,
          float* row) {
  for (const int i : response.particle) {
    const Eigen::Index at = stiffness.place(3 * Eigen::Index{i});
    for (int axis = 0; axis < 3; ++axis) *row++ = static_cast<float>(u[at + axis]);
  }
}

/// Where unit forces act, in the order of the table's rows.
std::vector<Eigen::Index> list_pushed(const FreeStiffness& stiffness, const Response& response) {
  std::vector<Eigen::Index> places;
  for (const int i : response.particle) {
    if (response.column[static_cast<std::size_t>(i)] < 0) continue;
    for (int axis = 0; axis < 3; ++axis) {
      places.push_back(stiffness.place(3 * Eigen::Index{i} + axis));
    }
  }
  return places;
}

void solve_compliance(const FreeStiffness& stiffness, const Factors& factors, Response& response) {
  const std::size_t width = 3 * static_cast<std::size_t>(response.size.moved);
  const std::vector<Eigen::Index> places = list_pushed(stiffness, response);
  response.compliance.resize(places.size() * width);
  for (std::size_t first = 0; first < places.size(); first += kAtOnce) {
    const std::size_t count = std::min<std::size_t>(kAtOnce, places.size() - first);
    Sides force = Sides::Zero(3 * stiffness.count, kAtOnce);
    for (std::size_t k = 0; k < count; ++k) {
      force(places[first + k], static_cast<Eigen::Index>(k)) = 1.0;
    }
    const Sides u = solve(factors, force);
    for (std::size_t k = 0; k < count; ++k) {
      keep(stiffness, response, u.col(static_cast<Eigen::Index>(k)),
           response.compliance.data() + (first + k) * width);
    }
  }
}

void solve_sag(const TissueModel& model, const Vec3& gravity, const FreeStiffness& stiffness,
               const Factors& factors, Response& response) {
  response.sag.assign(3 * static_cast<std::size_t>(response.size.moved), 0.0F);
  if (gravity.isZero()) return;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * stiffness.count);
  for (std::size_t i = 0; i < model.mass.size(); ++i) {
    const int n = stiffness.number[i];
    if (n >= 0) force.segment<3>(3 * n) = model.mass[i] * gravity;
  }
  const Eigen::VectorXd u = factors.solve(force);
  keep(stiffness, response, u, response.sag.data());
}

/// [m/N] What particle i does under 1 N on particle j.
Mat3 find_block(const Response& response, int i, int j) {
  const int row = response.row[static_cast<std::size_t>(i)];
  const int column = response.column[static_cast<std::size_t>(j)];
  Mat3 block = Mat3::Zero();
  if (row < 0 || column < 0) return block;
  const std::size_t width = 3 * static_cast<std::size_t>(response.size.moved);
  for (int k = 0; k < 3; ++k) {
    const float* at = &response.compliance[static_cast<std::size_t>(3 * column + k) * width +
                                           3 * static_cast<std::size_t>(row)];
    block.col(k) = Vec3(at[0], at[1], at[2]);
  }
  return block;
}

/// The largest eigenvalue of the compliance of a point of the surface.
double find_largest_compliance(const Mat3& compliance) {
  const Mat3 symmetric = 0.5 * (compliance + compliance.transpose());
  return Eigen::SelfAdjointEigenSolver<Mat3>(symmetric, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

std::vector<double> compute_self_compliance(const TissueModel& model, const Response& response) {
  std::vector<double> self_compliance;
  for (int v = 0; v < surface_count(model); ++v) {
    if (model.skin.corners.empty()) {
      self_compliance.push_back(find_largest_compliance(find_block(response, v, v)));
      continue;
    }
    const auto& corners = model.skin.corners[static_cast<std::size_t>(v)];
    const auto& weights = model.skin.weights[static_cast<std::size_t>(v)];
    Mat3 sum = Mat3::Zero();
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = 0; q < 4; ++q) {
        sum += weights[p] * weights[q] * find_block(response, corners[p], corners[q]);
      }
    }
    self_compliance.push_back(find_largest_compliance(sum));
  }
  return self_compliance;
}

void check_linear(const TissueModel& model) {
  if (!model.elastic.corners.empty()) return;
  refuse("linear solid: model", "no elastic tetrahedra", "a model of build_linear_solid");
}

}  // namespace

ResponseSize measure_response(const TissueModel& model) {
  check_linear(model);
  return list_particles(model).size;
}

Response build_response(const TissueModel& model, const Vec3& gravity, std::size_t most) {
  check_linear(model);
  Response response = list_particles(model);
  check_size(response.size, most);
  const FreeStiffness stiffness(model);
  Factors factors;
  if (!factor(stiffness, factors)) {
    refuse("linear solid: fixed", "a body that can move without being strained",
           "particles held that do not lie on one line, or home springs");
  }
  solve_compliance(stiffness, factors, response);
  solve_sag(model, gravity, stiffness, factors, response);
  response.self_compliance = compute_self_compliance(model, response);
  return response;
}

}  // namespace palpate
