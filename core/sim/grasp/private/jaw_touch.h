// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/private/list_contacts.h"
#include "palpate/sim/grasp/private/jaws.h"

namespace palpate {

// What two jaws touch, each by its own capsule, at one place and angle.

/// All that balance_jaws only reads.
struct JawSurroundings {
  const Tool& tool;
  const Coupling& coupling;
  const Vec3& hand;
  const JawSurfaces& surfaces;
  double wanted = 0.0;  ///< [rad] by which the hand would have jaws open
  double grip = 0.0;    ///< [N] that they close with at most
  double arm = 0.0;     ///< [m]
  double reach = 0.0;   ///< [m] no point of a jaw goes farther as it turns by 1 rad
  double drag = 0.0;    ///< [N m/rad] by which hinges resist in this substep, over the turn in it
};

/// Where tool and jaws are, and how far these may be turned in this substep.
struct JawPlace {
  Vec3 position;
  OpenJaws jaws;
  double least, most;  ///< [rad]
};

template <class Take>
void for_each_of_jaws(const JawSurroundings& around, const JawPlace& place, Take take) noexcept {
  for (int j = 0; j < 2; ++j) {
    const auto surfaces = around.surfaces[static_cast<std::size_t>(j)];
    for (std::size_t b = 0; b < surfaces.size(); ++b) {
      for_each_contact(place.jaws.shape(j), surfaces[b], place.position,
                       [&](int t, const Contact& contact) noexcept {
                         take(j, static_cast<int>(b), t, contact);
                       });
    }
  }
}

/// What touches an axis nearest, also where it has no force.
template <class Take>
void for_each_closest_of_jaws(const JawSurroundings& around, const JawPlace& place,
                              Take take) noexcept {
  for (int j = 0; j < 2; ++j) {
    const auto surfaces = around.surfaces[static_cast<std::size_t>(j)];
    for (std::size_t b = 0; b < surfaces.size(); ++b) {
      for_each_closest(place.jaws.shape(j), surfaces[b], lift(surfaces[b], place.position),
                       [&](int t, const Contact& contact) noexcept {
                         take(j, static_cast<int>(b), t, contact);
                       });
    }
  }
}

inline const TouchedSurface& surface_of(const JawSurroundings& around, int jaw, int body) noexcept {
  return around.surfaces[static_cast<std::size_t>(jaw)][static_cast<std::size_t>(body)];
}

/// [m] The point of the tissue, off the tool's position.
inline Vec3 find_at(const JawSurroundings& around, const JawPlace& place, int jaw, int body, int t,
                    const Contact& contact) noexcept {
  const TouchedSurface& surface = surface_of(around, jaw, body);
  return compute_point(triangle_at(surface, t), contact.weights, surface.x) - place.position;
}

/// What tissue and hand do to tool and jaws at one place.
struct JawTouch {
  Vec3 force = Vec3::Zero();      ///< [N] of contacts on the tool
  double torque = 0.0;            ///< [N m] of contacts, that opens the jaws
  Mat3 stiffness = Mat3::Zero();  ///< [N/m]
  Vec3 mixed = Vec3::Zero();      ///< [N/rad]
  double angular = 0.0;           ///< [N m/rad]
  std::array<Pressed, 2> pressed;
  double smallest_distance = 0.0;  ///< [m]
  bool touches = false;
};

/// Turns the jaws; contacts stay those of lanes that were filled around where they were.
void turn_to(const JawSurroundings& around, double angle, JawPlace& place) noexcept;

JawTouch compute_touch(const JawSurroundings& around, const JawPlace& place) noexcept;

}  // namespace palpate
