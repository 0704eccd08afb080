// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/spread_directions.h"

#include <cmath>
#include <numbers>

namespace palpate::authoring {

/// Points of a Fibonacci lattice: heights evenly apart, each turned on by the golden angle
/// [Gonzalez10].
Vec3Array spread_directions(int count) {
  Vec3Array directions;
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z);
    directions.emplace_back(r * std::cos(golden * i), r * std::sin(golden * i), z);
  }
  return directions;
}

}  // namespace palpate::authoring
