// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/world.h"

namespace palpate {

/// How many substeps the coming tick of dt [s] has, from the world as the last tick left it and its
/// candidates; `travel` [m] is how far the hand has come since. Between scene.substeps and
/// scene.substeps_max.
int choose_substeps(const Scene& scene, double travel, double dt, World& world) noexcept;

}  // namespace palpate
