// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/tick/press_scene.h"

namespace palpate::testing {

inline constexpr double kDt = 1e-3;
inline const Vec3 kAside(0.1, 0.0, 0.0);  ///< [m] where the second body is

/// The body of press_scene(), moved, of links `stiffer` times as stiff.
inline SoftBody make_body(const Vec3& offset = Vec3::Zero(), double stiffer = 1.0) {
  SoftBody body = press_scene().bodies[0];
  body.substeps = body.substeps_max = 0;
  for (Vec3& x : body.tissue.rest_position) x += offset;
  for (double& stiffness : body.tissue.springs.stiffness) stiffness *= stiffer;
  return body;
}

/// press_script(), at another body.
inline HapticSample read_at(ScriptedDevice& hand, int i, const Vec3& offset = Vec3::Zero()) {
  HapticSample sample = hand.read(kDt * i);
  sample.position += offset;
  return sample;
}

}  // namespace palpate::testing
