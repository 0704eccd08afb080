// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/contact/private/near_contact.h"
#include "palpate/sim/contact/private/touched_surface.h"

namespace palpate {

/// [m] How far the hand has gone on since its spring could pull no harder: by so much a tool that
/// is held has slid in its grip.
double measure_slip(const Coupling& coupling, const Vec3& hand_position,
                    const ToolState& state) noexcept;

/// [N] What all holds together carry, each whatever its direction; the loads of the surfaces are
/// what they did in the last substep.
double measure_held_load(const ToolState& state, std::span<const TouchedSurface> surfaces) noexcept;

/// [J] No less than what the hand's spring, contacts and holds can give before the hand moves
/// again; the loads of the surfaces are what they did in the last substep.
double bound_stored_energy(const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
                           const ToolState& state,
                           std::span<const TouchedSurface> surfaces) noexcept;

// What the contacts of instruments add to the stiffness that substeps are chosen by.

/// Row sums of M⁻¹K that contacts and holds add to vertices [contact: substeps]: of all that are
/// added, so that what touches different vertices counts once, and what shares some as both.
struct ContactRows {
  std::span<const double> mass;  ///< [kg] per vertex
  std::span<double> sums;        ///< [N/m] per vertex, 0 where nothing was added
  double largest = 0.0;          ///< [1/s²]

  /// Spreads k w over the corners of a triangle.
  void add(const Triangle& t, const Vec3& weights, double stiffness) noexcept;
};

/// A surface as a tool, or a part of one, may touch it.
struct TouchableSurface {
  const Candidates& candidates;
  std::span<const Triangle> triangles;
  std::span<const Vec3> x;     ///< [m]
  const NearField* near;       ///< null under the hard law alone
  int body;                    ///< whose it is, of what is held
  double friction_part = 1.0;  ///< [-] mu of the tool on it over Tool::friction

  std::span<const int> list_touchable() const noexcept {
    return std::span(candidates.triangles).first(static_cast<std::size_t>(candidates.count));
  }
};

inline TouchableSurface view(const TouchedSurface& surface, int body) noexcept {
  return {*surface.candidates,  surface.triangles, surface.x, surface.near, body,
          surface.friction_part};
}

/// Calls take(triangle, weights, slope) of all that the shape touches.
template <class Take>
void for_each_slope(const Shape& shape, const TouchableSurface& surface, const ToolState& state,
                    Take take) noexcept {
  const Candidates& candidates = surface.candidates;
  const NearContacts& known = candidates.near;
  const Tool& tool = shape.tool;
  const Vec3 at =
      surface.near ? Vec3(state.position + find_lift(known, state.position)) : state.position;
  // what balance_tool has found where the tool and the tissue still are
  if (surface.near && known.found && known.centre == at) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(known.count); ++i) {
      const double slope = bound_slope(tool, known.closest[i], known.contact[i]);
      take(known.triangle[i], known.contact[i].weights, slope);
    }
    return;
  }
  const std::span<const int> touchable = surface.list_touchable();
  Contact contact;
  for (std::size_t i = 0; i < touchable.size(); ++i) {
    const Triangle& t = surface.triangles[static_cast<std::size_t>(touchable[i])];
    const Vec3 &a = surface.x[static_cast<std::size_t>(t[0])],
               &b = surface.x[static_cast<std::size_t>(t[1])],
               &c = surface.x[static_cast<std::size_t>(t[2])];
    const Openness open = find_openness(candidates, touchable[i]);
    if (!find_shape_contact(shape, candidates.areas[i], at, a, b, c, contact, open)) continue;
    if (surface.near) {
      const NearGain gain{known.gain, known.stiffening};
      const Contact closest = contact;
      find_near_contact(*surface.near, shape, closest, at, open.side, a, b, c, gain, contact);
      contact.stiffness = bound_slope(tool, closest, contact);
    }
    take(touchable[i], contact.weights, contact.stiffness);
  }
}

/// Adds what one part of a tool touches; what the tool holds counts with one of them.
void add_shape_rows(const Shape& shape, bool with_holds, const TouchableSurface& surface,
                    const ToolState& state, double coupling, ContactRows& rows) noexcept;

/// Calls take(vertex) of all rows that add_shape_rows() may have written, of some more than once.
template <class Take>
void for_each_row(bool with_holds, const TouchableSurface& surface, const ToolState& state,
                  Take take) noexcept {
  const auto take_corners = [&](int t) noexcept {
    for (const int v : surface.triangles[static_cast<std::size_t>(t)]) take(v);
  };
  const auto take_held = [&](const auto& held, int count) noexcept {
    for (const auto& one : std::span(held).first(static_cast<std::size_t>(count))) {
      if (one.body == surface.body) take_corners(one.triangle);
    }
  };
  for (const int t : surface.list_touchable()) take_corners(t);
  if (!with_holds) return;
  take_held(state.holds, state.hold_count);
  take_held(state.patch, state.patch_count);
  take_held(state.anchors, state.anchor_count);
}

}  // namespace palpate
