// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/loop/puppet.h"

namespace palpate::testing {

inline const Vec3 kAside(0.2, 0.0, 0.0);  ///< [m] where the second body is, and its hand

/// The body of a scene and the same one again beside it, each with an instrument.
inline Scene pair_of(const Scene& one) {
  Scene two;
  two.gravity = one.gravity;
  two.bodies = {one.bodies[0], one.bodies[0]};
  for (Vec3& x : two.bodies[1].tissue.rest_position) x += kAside;
  two.instruments.resize(2);
  return build_scene(std::move(two));
}

/// A puppet at the second body.
inline Puppet make_puppet_aside(double depth = 0.004, double duration = 0.5) {
  Puppet puppet = make_puppet(depth, duration);
  puppet.on_read = [](int, HapticSample& sample) { sample.position += kAside; };
  return puppet;
}

}  // namespace palpate::testing
