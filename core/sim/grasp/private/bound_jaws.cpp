// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "palpate/sim/contact/private/hold.h"
#include "palpate/sim/contact/private/list_contacts.h"
#include "palpate/sim/grasp/private/jaws.h"
#include "palpate/sim/model/private/sum_over_pushes.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {
namespace {

/// Row sums of M⁻¹K of the particles under a skin.
struct ParticleRows {
  const TissueModel& tissue;
  std::span<double> sums;  // [N/m] per particle
  double largest = 0.0;    // [1/s²]

  /// Of a contact J^T k J the row i has the sum k |J_i| sum_j |J_j|.
  void add(int triangle, const Vec3& weights, double stiffness) noexcept {
    const Triangle& t = tissue.triangles[static_cast<std::size_t>(triangle)];
    double all = 0.0;
    for_each_carrier(tissue, t, weights,
                     [&](std::size_t, double w) noexcept { all += std::abs(w); });
    for_each_carrier(tissue, t, weights, [&](std::size_t i, double w) noexcept {
      sums[i] += stiffness * all * std::abs(w);
      largest = std::max(largest, sums[i] / tissue.mass[i]);
    });
  }
};

/// Calls take(triangle, weights, slope) of what a jaw touches.
template <class Take>
void for_each_slope(const Tool& tool, const Shape& shape, const TouchedSurface& surface,
                    const ToolState& state, Take take) noexcept {
  const Candidates& candidates = *surface.candidates;
  const NearContacts& near = candidates.near;
  const Vec3 at =
      surface.near ? Vec3(state.position + find_lift(near, state.position)) : state.position;
  // what balance_jaws has found where the tool and the tissue still are
  if (surface.near && near.found && near.centre == at) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(near.count); ++i) {
      const double slope = bound_slope(tool, near.closest[i], near.contact[i]);
      take(near.triangle[i], near.contact[i].weights, slope);
    }
    return;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(candidates.count); ++i) {
    const int t = candidates.triangles[i];
    const Vec3 &a = corner_at(surface, t, 0), &b = corner_at(surface, t, 1),
               &c = corner_at(surface, t, 2);
    const Openness open = find_openness(candidates, t);
    Contact contact;
    if (!find_shape_contact(shape, candidates.areas[i], at, a, b, c, contact, open)) continue;
    if (surface.near) {
      const Contact closest = contact;
      find_near_contact(*surface.near, shape, closest, at, open.side, a, b, c,
                        {near.gain, near.stiffening}, contact);
      contact.stiffness = bound_slope(tool, closest, contact);
    }
    take(t, contact.weights, contact.stiffness);
  }
}

/// Calls take(triangle, weights, stiffness) of all that both jaws do to one of the bodies.
template <class Take>
void for_each_spring(const Tool& tool, const OpenJaws& jaws, const JawSurfaces& surfaces, int body,
                     const ToolState& state, Take take) noexcept {
  const double sliding = std::sqrt(1.0 + tool.friction * tool.friction);
  for (int j = 0; j < 2; ++j) {
    const TouchedSurface& surface =
        surfaces[static_cast<std::size_t>(j)][static_cast<std::size_t>(body)];
    for_each_slope(tool, jaws.shape(j), surface, state,
                   [&](int t, const Vec3& weights, double slope) noexcept {
                     take(t, weights, sliding * slope);
                   });
  }
  for (int k = 0; k < state.anchor_count; ++k) {
    const ToolState::Anchor& anchor = state.anchors[static_cast<std::size_t>(k)];
    if (anchor.body == body) take(anchor.triangle, anchor.weights, anchor.stiffness);
  }
}

}  // namespace

double bound_jaws_on_skin(const Tool& tool, const JawSurfaces& surfaces, int body,
                          const TissueModel& tissue, const ToolState& state,
                          std::span<double> scratch) noexcept {
  const OpenJaws jaws(tool, state.orientation, state.jaw_angle);
  ParticleRows rows{tissue, scratch};
  for_each_spring(tool, jaws, surfaces, body, state,
                  [&](int t, const Vec3& weights, double stiffness) noexcept {
                    rows.add(t, weights, stiffness);
                  });
  std::ranges::fill(scratch, 0.0);
  return rows.largest;
}

}  // namespace palpate
