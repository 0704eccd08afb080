// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/world.h"

namespace palpate {

/// Fastens the tool of an instrument to what it touches when the attach button goes down, and lets
/// go when it comes up, or when the tool has slid out of its grip or the tissue would bear no more.
/// `dt` [s] is that of the tick.
void follow_button(const Scene& scene, std::size_t instrument, std::uint8_t buttons, double dt,
                   World& world) noexcept;

}  // namespace palpate
