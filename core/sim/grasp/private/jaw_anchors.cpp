// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <tuple>

#include "palpate/sim/grasp/private/jaws.h"

namespace palpate {
namespace {

const Triangle& triangle_of(std::span<const TouchedSurface> surfaces, int body, int t) noexcept {
  return surfaces[static_cast<std::size_t>(body)].triangles[static_cast<std::size_t>(t)];
}

/// Twice the area of a triangle along its normal [m²].
Vec3 find_area_vector(std::span<const TouchedSurface> surfaces, int body, int t) noexcept {
  const std::span<const Vec3> x = surfaces[static_cast<std::size_t>(body)].x;
  const auto& [a, b, c] = triangle_of(surfaces, body, t);
  const Vec3& at_a = x[static_cast<std::size_t>(a)];
  return (x[static_cast<std::size_t>(b)] - at_a).cross(x[static_cast<std::size_t>(c)] - at_a);
}

Vec3 find_point(std::span<const TouchedSurface> surfaces, int body, int t,
                const Vec3& weights) noexcept {
  return compute_point(triangle_of(surfaces, body, t), weights,
                       surfaces[static_cast<std::size_t>(body)].x);
}

/// How far the tissue is from where it sticks, along its surface, and that surface's normal.
struct Stretch {
  Vec3 along = Vec3::Zero();   // [m]
  Vec3 normal = Vec3::Zero();  // unit
  Vec3 at = Vec3::Zero();      // [m] of the jaw's point, off the tool's position
};

Stretch find_stretch(const OpenJaws& jaws, std::span<const TouchedSurface> surfaces,
                     const Vec3& position, const ToolState::Anchor& anchor) noexcept {
  Stretch stretch;
  const Vec3 area = find_area_vector(surfaces, anchor.body, anchor.triangle);
  const double length = area.norm();
  if (length > 0.0) stretch.normal = area / length;
  stretch.at = jaws.to_scene(anchor.jaw, anchor.place);
  const Vec3 whole =
      find_point(surfaces, anchor.body, anchor.triangle, anchor.weights) - (position + stretch.at);
  stretch.along = whole - stretch.normal * stretch.normal.dot(whole);
  return stretch;
}

auto key_of(const ToolState::Anchor& anchor) noexcept {
  return std::tuple(anchor.jaw, anchor.body, anchor.triangle);
}

std::span<ToolState::Anchor> anchors_of(ToolState& state) noexcept {
  return std::span(state.anchors).first(static_cast<std::size_t>(state.anchor_count));
}

}  // namespace

/// Of k and the stretch d along the surface: the force k d on the tool, up to mu N; what slips
/// pulls no harder as the tool goes on.
AnchorSprings find_anchor_springs(const Tool& tool, const OpenJaws& jaws,
                                  std::span<const TouchedSurface> surfaces,
                                  const ToolState& state) noexcept {
  AnchorSprings springs;
  const std::span<const ToolState::Anchor> anchors(state.anchors.data(),
                                                   static_cast<std::size_t>(state.anchor_count));
  for (const ToolState::Anchor& anchor : anchors) {
    const Stretch stretch = find_stretch(jaws, surfaces, state.position, anchor);
    const Vec3 move = jaws.move(anchor.jaw, stretch.at);
    const double size = anchor.stiffness * stretch.along.norm(),
                 most = find_friction(tool, surfaces, anchor.body) * anchor.pressed;
    const bool slips = size > most;
    const Vec3 force = (slips ? most / size : 1.0) * anchor.stiffness * stretch.along;
    springs.force += force;
    springs.torque += force.dot(move);
    if (slips) continue;
    const Mat3 plane = Mat3::Identity() - stretch.normal * stretch.normal.transpose();
    const Vec3 turned = anchor.stiffness * (plane * move);
    springs.stiffness += anchor.stiffness * plane;
    springs.mixed += turned;
    springs.angular += turned.dot(move);
  }
  return springs;
}

void unpress_anchors(ToolState& state) noexcept {
  for (ToolState::Anchor& anchor : anchors_of(state)) anchor.pressed = 0.0;
}

/// The point of the jaw of an anchor that slips moves: to where the jaw touches the triangle now,
/// less the stretch at which the spring pulls with mu N.
void press_anchor(const Tool& tool, const OpenJaws& jaws, std::span<const TouchedSurface> surfaces,
                  const JawContact& contact, int sorted, ToolState& state) noexcept {
  const auto known = std::span(state.anchors).first(static_cast<std::size_t>(sorted));
  const std::tuple key(contact.jaw, contact.body, contact.triangle);
  const auto found = std::ranges::lower_bound(known, key, {}, key_of);
  const Vec3 at = find_point(surfaces, contact.body, contact.triangle, contact.weights);
  if (found != known.end() && key_of(*found) == key) {
    ToolState::Anchor& anchor = *found;
    anchor.pressed = contact.pressed;
    const Vec3 along = find_stretch(jaws, surfaces, state.position, anchor).along;
    const double size = anchor.stiffness * along.norm(),
                 most = find_friction(tool, surfaces, contact.body) * contact.pressed;
    if (!(size > most)) return;
    anchor.weights = contact.weights;
    anchor.place = jaws.to_jaw(anchor.jaw, at - (most / size) * along - state.position);
    return;
  }
  if (state.anchor_count == static_cast<int>(state.anchors.size())) return;
  ToolState::Anchor& made = state.anchors[static_cast<std::size_t>(state.anchor_count++)];
  const double area = 0.5 * find_area_vector(surfaces, contact.body, contact.triangle).norm();
  made.triangle = contact.triangle;
  made.body = contact.body;
  made.jaw = contact.jaw;
  made.weights = contact.weights;
  made.place = jaws.to_jaw(contact.jaw, at - state.position);
  made.pressed = contact.pressed;
  made.stiffness = kBristle * tool.stiffness * std::min(area, tool.jaws->pad_area);
}

Vec3 pull_anchors(const Tool& tool, const OpenJaws& jaws, std::span<const TouchedSurface> surfaces,
                  int sorted, ToolState& state) noexcept {
  const bool has_new = state.anchor_count > sorted;
  const auto gone = std::ranges::remove_if(
      anchors_of(state), [](const ToolState::Anchor& a) noexcept { return !(a.pressed > 0.0); });
  state.anchor_count -= static_cast<int>(gone.size());
  if (has_new) std::ranges::sort(anchors_of(state), {}, key_of);
  state.carried.setZero();
  state.held_load = 0.0;
  std::array<bool, 2> sticks{};
  for (const ToolState::Anchor& anchor : anchors_of(state)) {
    const Vec3 along = find_stretch(jaws, surfaces, state.position, anchor).along;
    const double size = anchor.stiffness * along.norm(),
                 most = find_friction(tool, surfaces, anchor.body) * anchor.pressed;
    const Vec3 force = (size > most ? most / size : 1.0) * anchor.stiffness * along;
    state.carried += force;
    state.held_load += std::min(size, most);
    sticks[static_cast<std::size_t>(anchor.jaw)] = true;
    surfaces[static_cast<std::size_t>(anchor.body)].load->add(
        {anchor.triangle, anchor.weights, -force});
  }
  state.pinches = sticks[0] && sticks[1];
  return state.carried;
}

}  // namespace palpate
