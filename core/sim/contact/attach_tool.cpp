// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/contact/private/hold.h"
#include "palpate/sim/contact/private/near_contact.h"
#include "palpate/sim/contact/private/touched_surface.h"

namespace palpate {

namespace {

double sum_forces(std::span<const Push> pushes) noexcept {
  double sum = 0.0;
  for (const Push& push : pushes) sum += push.force.norm();
  return sum;
}

/// Hold i gets the share |f_i| / sum |f| of the stiffness: what is pressed hardest is held best.
void add_holds(std::span<const Push> pushes, int body, std::span<const Triangle> triangles,
               std::span<const Vec3> x, double stiffness, double sum, ToolState& state) noexcept {
  for (const Push& push : pushes) {
    if (state.hold_count == static_cast<int>(state.holds.size())) return;
    const Vec3 point =
        compute_point(triangles[static_cast<std::size_t>(push.triangle)], push.weights, x);
    state.holds[static_cast<std::size_t>(state.hold_count++)] = {
        push.triangle, push.weights, stiffness * (push.force.norm() / sum), state.position - point,
        body};
  }
}

/// Of a disc tied to a half space, sideways over along the normal: 8 G a/(2 - nu) over 4 G a/(1 -
/// nu) [Johnson85], 2 (1 - nu)/(2 - nu), with nu of 0.45; 0.67 with 0.5.
constexpr double kSideways = 0.71;

/// How much of their patch the pressures of a dent must agree on for it to be held as one.
constexpr double kOneDent = 0.5;

/// [-] How much more a disc gives way than a rigid one that is tied, whose springs are shared out
/// as the pressures were: at the rim they are next to nothing. `ratio` is that of their stiffness
/// to the disc's. 1/5 where they are soft, for then the disc gives way by 3/5 F/(E* a) [Johnson85],
/// and fitted to solutions of the half space between, within 1 % of what gives way.
double find_rim(double ratio) noexcept { return 0.2 / (1.0 + 0.19 * std::pow(ratio, 0.78)); }

/// The holds of one body, from `first` on, give way as a disc as wide as the contact that is tied
/// to a half space, less what the mesh has done of that already, and take over what the pressures
/// push with:
///
///     1/k = 1/k_h + ((1 + rim) - S dC)/S,   S = F'(s) = 2 E* a
///
/// and sideways with kSideways S for S: the mesh is taken to have the same part of that.
void tie(const TouchedSurface& surface, std::size_t first, const Vec3& friction,
         ToolState& state) noexcept {
  NearContacts& near = surface.candidates->near;
  const double pushed = near.push.norm();
  if (!surface.near || !surface.near->ties_holds || !(near.local_slope > 0.0) ||
      !(pushed > kOneDent * near.force)) {
    return;
  }
  const std::span<ToolState::Hold> holds =
      std::span(state.holds).first(static_cast<std::size_t>(state.hold_count)).subspan(first);
  double own = 0.0;
  for (const ToolState::Hold& hold : holds) own += hold.stiffness;
  const double slope = near.local_slope, rim = find_rim(own / slope);
  const double left = std::max(0.0, 1.0 + rim - slope * near.mesh_compliance) / slope;
  const double along = 1.0 / (1.0 + own * left), across = 1.0 / (1.0 + own * left / kSideways);
  for (ToolState::Hold& hold : holds) {
    const double share = hold.stiffness / own;
    hold.normal = near.push / pushed;
    hold.sideways = across * hold.stiffness;
    hold.stiffness *= along;
    hold.offset += hold.stretch(share * (near.push + friction));
  }
  near.grip.force = near.force;
  near.grip.share = near.force / pushed;
  near.grip.normal = near.push / pushed;
}

}  // namespace

bool attach_tool(std::span<const TouchedSurface> surfaces, double stiffness,
                 ToolState& state) noexcept {
  if (state.hold_count > 0) return true;
  double sum = 0.0;
  for (const TouchedSurface& surface : surfaces) sum += sum_forces(surface.load->pushes());
  if (!(sum > 0.0)) return false;
  for (std::size_t b = 0; b < surfaces.size(); ++b) {
    const std::span<const Push> pushes = surfaces[b].load->pushes();
    const auto first = static_cast<std::size_t>(state.hold_count);
    add_holds(pushes, static_cast<int>(b), surfaces[b].triangles, surfaces[b].x, stiffness, sum,
              state);
    tie(surfaces[b], first, sum_forces(pushes) / sum * state.friction, state);
  }
  return true;
}

bool attach_tool(const Load& contacts, std::span<const Triangle> triangles, std::span<const Vec3> x,
                 double stiffness, ToolState& state) noexcept {
  if (state.hold_count > 0) return true;
  const auto pushes =
      contacts.pushes().first(std::min(contacts.pushes().size(), state.holds.size()));
  const double sum = sum_forces(pushes);
  if (!(sum > 0.0)) return false;
  add_holds(pushes, 0, triangles, x, stiffness, sum, state);
  return true;
}

void release_tool(ToolState& state) noexcept {
  state.hold_count = state.anchor_count = 0;
  state.held_load = 0.0;
  state.pinches = false;
  state.carried.setZero();
}

void ContactRows::add(const Triangle& t, const Vec3& weights, double stiffness) noexcept {
  for (std::size_t c = 0; c < 3; ++c) {
    const auto i = static_cast<std::size_t>(t[c]);
    sums[i] += stiffness * weights[static_cast<Eigen::Index>(c)];
    largest = std::max(largest, sums[i] / mass[i]);
  }
}

/// By Gershgorin the eigenvalues of M⁻¹K are at most its largest row sum. A contact of slope k at
/// the barycentric weights w adds k w_i w_j n n^T to the blocks (i, j), and the weights sum to 1:
/// row i gains k w_i / m_i. That the tool itself gives way only lowers them. Friction that slides,
/// mu f along d, makes of n n^T the block (n + mu d) n^T of the norm sqrt(1 + mu²); friction that
/// sticks hangs the hand's spring K on all points together, each with its share s of the tool's
/// motion: K s w_i.
void add_shape_rows(const Shape& shape, bool with_holds, const TouchableSurface& surface,
                    const ToolState& state, double coupling, ContactRows& rows) noexcept {
  const double mu = shape.tool.friction * surface.friction_part;
  const double sliding = std::sqrt(1.0 + mu * mu);
  const auto add = [&](int t, const Vec3& weights, double stiffness) noexcept {
    rows.add(surface.triangles[static_cast<std::size_t>(t)], weights, stiffness);
  };
  for_each_slope(shape, surface, state, [&](int t, const Vec3& weights, double slope) noexcept {
    add(t, weights, sliding * slope);
  });
  if (!with_holds) return;
  const auto in_use = [](const auto& held, int count) noexcept {
    return std::span(held).first(static_cast<std::size_t>(count));
  };
  for (const ToolState::Hold& hold : in_use(state.holds, state.hold_count)) {
    if (hold.body == surface.body) add(hold.triangle, hold.weights, hold.stiffness);
  }
  for (const ToolState::PatchPoint& point : in_use(state.patch, state.patch_count)) {
    if (point.body == surface.body) add(point.triangle, point.weights, coupling * point.share);
  }
  for (const ToolState::Anchor& anchor : in_use(state.anchors, state.anchor_count)) {
    if (anchor.body == surface.body) add(anchor.triangle, anchor.weights, anchor.stiffness);
  }
}

double bound_contact_stiffness(const Tool& tool, const Candidates& candidates,
                               std::span<const Triangle> triangles, std::span<const Vec3> x,
                               std::span<const double> mass, const ToolState& state,
                               std::span<double> scratch, int body, const NearField* near,
                               double coupling) noexcept {
  const TouchableSurface surface{candidates, triangles, x, near, body};
  ContactRows rows{mass, scratch};
  for_each_row(true, surface, state,
               [&](int v) noexcept { scratch[static_cast<std::size_t>(v)] = 0.0; });
  add_shape_rows({tool, Axes(tool, state.orientation)}, true, surface, state, coupling, rows);
  return rows.largest;
}

}  // namespace palpate
