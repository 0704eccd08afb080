// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "palpate/sim/tick/scene.h"

namespace palpate {

/// A tissue and nothing chosen beside it.
inline Scene scene_of(TissueModel tissue) {
  Scene scene;
  scene.bodies[0].tissue = std::move(tissue);
  return build_scene(std::move(scene));
}

}  // namespace palpate
