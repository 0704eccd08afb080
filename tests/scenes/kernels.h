// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <string_view>

#include "palpate/sim/tick/scene.h"

namespace palpate::scenes {

/// The kernel whose ticks are tested: that named by PALPATE_KERNEL, packed without one. CTest runs
/// the rooms of haptics and laws under both.
inline Kernel kernel_under_test() {
  const char* name = std::getenv("PALPATE_KERNEL");
  return name != nullptr && std::string_view(name) == "reference" ? Kernel::reference
                                                                  : Kernel::packed;
}

/// [m] by which what rests may tremble: a float cannot tell a rest length from the distance of
/// two rest positions, the reference can.
inline double rest_tolerance() { return kernel_under_test() == Kernel::reference ? 0.0 : 1e-8; }

}  // namespace palpate::scenes
