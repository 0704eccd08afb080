// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scenes/solids.h"

namespace palpate::scenes {

constexpr double kBlockThickness = 0.05;  ///< [m]
constexpr double kBlockYoung = 5000.0, kBlockPoisson = 0.45;
/// [Pa] of its near field
constexpr double kBlockModulus = kBlockYoung / (1.0 - kBlockPoisson * kBlockPoisson);

/// What a solid is built from.
struct Held {
  SolidMesh solid;
  Material material;
  SolidOptions options;
};

/// A block of 100 x 100 x 50 mm, held below, of 24 n³ tetrahedra.
inline Held make_held_block(int n) {
  Held held{.solid = make_block({0.1, 0.1, kBlockThickness}, {2 * n, 2 * n, n}),
            .material = make_material({}),
            .options = {}};
  held.options.nodal_share = 0.9;
  for (std::size_t i = 0; i < held.solid.vertices.size(); ++i) {
    if (held.solid.vertices[i].z() < -0.499 * kBlockThickness) {
      held.options.fixed.push_back(static_cast<int>(i));
    }
  }
  held.material.young_modulus = kBlockYoung;
  held.material.poisson_ratio = kBlockPoisson;
  return held;
}

}  // namespace palpate::scenes
