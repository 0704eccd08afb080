// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/response/private/relax.h"

#include <Eigen/Core>
#include <algorithm>

namespace palpate {
namespace {

void add_force(const Response& response, int particle, const Vec3& force,
               ResponseState& state) noexcept {
  const int column = response.column[static_cast<std::size_t>(particle)];
  if (column < 0) return;
  float* at = &state.force[3 * static_cast<std::size_t>(column)];
  const bool touched = at[0] != 0.0F || at[1] != 0.0F || at[2] != 0.0F;
  for (int axis = 0; axis < 3; ++axis) at[axis] += static_cast<float>(force[axis]);
  if (touched) return;
  const auto end = state.touched.begin() + state.touched_count;
  // it may have been pushed before, to no effect in all
  if (std::find(state.touched.begin(), end, column) != end) return;
  state.touched[static_cast<std::size_t>(state.touched_count++)] = column;
}

void add_push(const Response& response, const TissueModel& model, const Push& push, double share,
              ResponseState& state) noexcept {
  const Triangle& corners = model.triangles[static_cast<std::size_t>(push.triangle)];
  for (int c = 0; c < 3; ++c) {
    const Vec3 force = share * push.weights[c] * push.force;
    if (model.skin.corners.empty()) {
      add_force(response, corners[c], force, state);
      continue;
    }
    const auto v = static_cast<std::size_t>(corners[c]);
    for (std::size_t k = 0; k < 4; ++k) {
      add_force(response, model.skin.corners[v][k], model.skin.weights[v][k] * force, state);
    }
  }
}

/// [m] sag + kept (u - sag) + G F of one of the moved.
Vec3 compute_displacement(const Response& response, const ResponseState& state,
                          std::size_t row) noexcept {
  using Vec3f = Eigen::Vector3f;
  const auto at = [row](const auto& table) noexcept {
    return Eigen::Map<const Vec3f>(&table[3 * row]);
  };
  const std::size_t width = 3 * static_cast<std::size_t>(response.size.moved);
  Vec3f sum = at(response.sag) + state.kept * (at(state.displacement) - at(response.sag));
  for (int n = 0; n < state.touched_count; ++n) {
    const auto column = 3 * static_cast<std::size_t>(state.touched[static_cast<std::size_t>(n)]);
    for (std::size_t k = 0; k < 3; ++k) {
      const float* block = &response.compliance[(column + k) * width + 3 * row];
      sum += state.force[column + k] * Eigen::Map<const Vec3f>(block);
    }
  }
  return sum.cast<double>();
}

}  // namespace

ResponseState::ResponseState(const Response& response)
    : displacement(3 * static_cast<std::size_t>(response.size.moved), 0.0F),
      force(3 * static_cast<std::size_t>(response.size.pushed), 0.0F),
      touched(static_cast<std::size_t>(response.size.pushed), 0) {}

/// u' = (1 - s) u + s (G f + sag) is linear in what came before, so that of a whole tick only the
/// sum of its pushes is kept, each with what later shares have left of it.
void relax(const Response& response, const TissueModel& model, const Load& load, double share,
           ResponseState& state) noexcept {
  const auto left = static_cast<float>(1.0 - share);
  state.kept *= left;
  for (int n = 0; n < state.touched_count; ++n) {
    const auto column = 3 * static_cast<std::size_t>(state.touched[static_cast<std::size_t>(n)]);
    for (std::size_t k = 0; k < 3; ++k) state.force[column + k] *= left;
  }
  for (const Push& push : load.pushes()) add_push(response, model, push, share, state);
}

void place_near(const Response& response, const TissueModel& model, const ResponseState& state,
                std::span<const int> particles, std::span<Vec3> x) noexcept {
  for (const int i : particles) {
    const auto particle = static_cast<std::size_t>(i);
    const int row = response.row[particle];
    if (row < 0) continue;
    x[particle] = model.rest_position[particle] +
                  compute_displacement(response, state, static_cast<std::size_t>(row));
  }
}

void settle(const Response& response, const TissueModel& model, ResponseState& state,
            std::span<Vec3> x) noexcept {
  using Numbers = Eigen::Map<const Eigen::VectorXf>;
  const Eigen::Index width = 3 * Eigen::Index{response.size.moved};
  const Numbers sag(response.sag.data(), width);
  Eigen::Map<Eigen::VectorXf> u(state.displacement.data(), width);
  u = sag + state.kept * (u - sag);
  for (int n = 0; n < state.touched_count; ++n) {
    const auto column = 3 * static_cast<std::size_t>(state.touched[static_cast<std::size_t>(n)]);
    for (std::size_t k = 0; k < 3; ++k) {
      float& force = state.force[column + k];
      u += force * Numbers(response.compliance.data() + (column + k) * std::size_t(width), width);
      force = 0.0F;
    }
  }
  state.touched_count = 0;
  state.kept = 1.0F;
  for (std::size_t row = 0; row < response.particle.size(); ++row) {
    const auto i = static_cast<std::size_t>(response.particle[row]);
    const float* at = &state.displacement[3 * row];
    x[i] = model.rest_position[i] + Vec3(at[0], at[1], at[2]);
  }
}

}  // namespace palpate
