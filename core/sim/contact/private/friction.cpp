// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/friction.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace palpate {
namespace {

Vec3 take_tangential(const Vec3& v, const Vec3& normal) noexcept {
  return v - normal * normal.dot(v);
}

/// [m] The mean of the patch's points, where the tissue is now.
Vec3 find_patch_position(std::span<const TouchedSurface> surfaces,
                         const ToolState& state) noexcept {
  Vec3 mean = Vec3::Zero();
  for (int k = 0; k < state.patch_count; ++k) {
    const ToolState::PatchPoint& point = state.patch[static_cast<std::size_t>(k)];
    const TouchedSurface& surface = surfaces[static_cast<std::size_t>(point.body)];
    mean += point.share * compute_point(surface.triangles[static_cast<std::size_t>(point.triangle)],
                                        point.weights, surface.x);
  }
  return mean;
}

/// The step along `along` and n that leaves no force along n: n·(R - J (along + a n)) = 0.
Vec3 step_with(const Vec3& along, const Vec3& n, const Vec3& residual,
               const Mat3& jacobian) noexcept {
  const double left = n.dot(residual - jacobian * along);
  return along + n * (left / n.dot(jacobian * n));
}

}  // namespace

Vec3 measure_carry(std::span<const TouchedSurface> surfaces, const ToolState& state) noexcept {
  if (state.patch_count == 0) return Vec3::Zero();
  return take_tangential(find_patch_position(surfaces, state) - state.patch_position,
                         state.patch_normal);
}

/// With n along the sum of contact forces, N its length and A what else acts on the tool, at the
/// place q = p + back of one that sticks:
///
///     |A_t(q)| <= mu N:  p_t = q_t,  R_n = 0
///     else:              A - mu N A_t(q)/|A_t(q)| + sum f_t n_t = 0
///
/// with N as it will be after the step. A step that would slide against the pull sticks: N has
/// grown since the tool slid too far.
Vec3 find_friction_step(const Unbalanced& tool, const Vec3& back, double mu) noexcept {
  const double contact = tool.contact.norm();
  const Vec3 n = tool.contact / contact;
  const Vec3 residual = tool.applied + tool.contact;
  const Mat3 jacobian = tool.applied_stiffness * Mat3::Identity() + tool.contact_stiffness;
  const auto contact_after = [&](const Vec3& step) noexcept {
    return std::max(0.0, contact - n.dot(tool.contact_stiffness * step));
  };
  const Vec3 along = take_tangential(back, n);
  const Vec3 stick = step_with(along, n, residual, jacobian);
  const Vec3 pull = take_tangential(tool.applied - tool.applied_stiffness * along, n);
  const double size = pull.norm();
  if (size <= mu * contact_after(stick)) return stick;
  const Vec3 direction = pull / size;
  const double after = contact_after(step_with(Vec3::Zero(), n, residual, jacobian));
  const Vec3 slide = jacobian.llt().solve(residual - mu * after * direction);
  return (slide - along).dot(direction) > 0.0 ? slide : stick;
}

/// Friction is what balances A along the surface, mu N at most. Each contact has the share of it
/// that it has of the sum of mu_t f_t; mu is the mean of mu_t by f_t.
Vec3 add_friction(std::span<const TouchedSurface> surfaces, const Vec3& applied,
                  const Vec3& contact, double mu, ToolState& state) noexcept {
  state.patch_count = 0;
  state.friction.setZero();
  double sum = 0.0, rubbed = 0.0;
  for (const TouchedSurface& surface : surfaces) {
    for (const Push& push : surface.load->pushes()) {
      sum += push.force.norm();
      rubbed += surface.friction_part * push.force.norm();
    }
  }
  const double normal_force = contact.norm();
  if (!(normal_force > 0.0 && rubbed > 0.0)) return state.friction;
  state.patch_normal = contact / normal_force;
  const Vec3 pull = take_tangential(applied, state.patch_normal);
  const double size = pull.norm(), most = mu * (rubbed / sum) * normal_force;
  state.friction = size > most ? Vec3(-pull * (most / size)) : Vec3(-pull);
  for (std::size_t b = 0; b < surfaces.size(); ++b) {
    Load& load = *surfaces[b].load;
    for (int k = 0; k < load.push_count; ++k) {
      Push& push = load.storage[static_cast<std::size_t>(k)];
      const double share = surfaces[b].friction_part * push.force.norm() / rubbed;
      push.force -= share * state.friction;
      if (state.patch_count == static_cast<int>(state.patch.size())) continue;
      state.patch[static_cast<std::size_t>(state.patch_count++)] = {
          push.triangle, static_cast<int>(b), push.weights, share};
    }
  }
  state.patch_position = find_patch_position(surfaces, state);
  return state.friction;
}

}  // namespace palpate
