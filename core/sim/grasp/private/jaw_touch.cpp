// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/grasp/private/jaw_touch.h"

#include <algorithm>
#include <cmath>

namespace palpate {
namespace {

/// The layer between jaws is a wall of prisms folded once, or one that stands for what a mesh
/// without thickness, or of a solid, has left between them.
void add_pressed(const TouchedSurface& surface, double force, double along, double opens,
                 Pressed& pressed) noexcept {
  const bool wall = surface.wall_thickness > 0.0;
  pressed.force += force;
  pressed.pad += force * find_pad_part(opens);
  pressed.at += force * along;
  pressed.spread += force * along * along;
  pressed.modulus += force * (wall ? surface.wall_modulus : kLayerPressure);
  pressed.thickness += force * (wall ? 2.0 * surface.wall_thickness : kLayer);
}

}  // namespace

void turn_to(const JawSurroundings& around, double angle, JawPlace& place) noexcept {
  const double turned = std::abs(angle - place.jaws.angle());
  if (turned == 0.0) return;
  place.jaws.open(angle);
  for (int j = 0; j < 2; ++j) {
    for (const TouchedSurface& surface : around.surfaces[static_cast<std::size_t>(j)]) {
      ContactLanes& lanes = surface.candidates->lanes;
      lanes.found = false;
      lanes.reach -= turned * around.reach;
      for (std::size_t lane = 0; lane < lanes.axis[0].size() && lane < std::size_t(lanes.count);
           ++lane) {
        fill_axis(place.jaws.axis_of(j), 0, lane, lanes);
      }
      surface.candidates->near.found = false;
    }
  }
}

JawTouch compute_touch(const JawSurroundings& around, const JawPlace& place) noexcept {
  JawTouch touch;
  touch.smallest_distance = around.tool.radius;
  std::array<double, 9> stiffness{};  // [N/m], column after column
  std::array<Vec3, 2> along;
  std::array<double, 2> length;
  for (std::size_t j = 0; j < 2; ++j) {
    const Capsule& axis = place.jaws.axis_of(static_cast<int>(j));
    along[j] = axis.to - axis.from;
    length[j] = along[j].norm();
  }
  for_each_of_jaws(around, place, [&](int jaw, int body, int t, const Contact& contact) noexcept {
    touch.smallest_distance = std::min(touch.smallest_distance, contact.distance);
    if (!(contact.force > 0.0)) return;
    const auto j = static_cast<std::size_t>(jaw);
    const Vec3 at = find_at(around, place, jaw, body, t, contact);
    const Vec3& n = contact.direction;
    const Vec3 move = place.jaws.move(jaw, at);
    const double turns = n.dot(move);
    touch.force += contact.force * n;
    touch.torque += contact.force * turns;
    const Vec3 rise = contact.stiffness * n;
    for (std::size_t k = 0; k < stiffness.size(); ++k) {
      stiffness[k] += rise[static_cast<Eigen::Index>(k % 3)] * n[static_cast<Eigen::Index>(k / 3)];
    }
    touch.mixed += (contact.stiffness * turns) * n;
    touch.angular += contact.stiffness * turns * turns;
    touch.touches = true;
    const double where =
        std::clamp((at - place.jaws.axis_of(jaw).from).dot(along[j]) / length[j], 0.0, length[j]);
    add_pressed(surface_of(around, jaw, body), contact.force, where, turns / move.norm(),
                touch.pressed[j]);
  });
  touch.stiffness = Eigen::Map<const Mat3>(stiffness.data());
  return touch;
}

}  // namespace palpate
