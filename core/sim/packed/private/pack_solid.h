// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/packed/private/packed_model.h"

namespace palpate {

/// The same triangles or tetrahedra by the rows of their corners.
template <std::size_t N>
std::vector<std::array<int, N>> map_rows(const PackedModel& packed,
                                         std::vector<std::array<int, N>> elements) {
  for (auto& corners : elements) {
    for (int& i : corners) i = packed.row[static_cast<std::size_t>(i)];
  }
  return elements;
}

/// Lays out volumes and skin; the particles must have their rows.
void pack_solid(const TissueModel& model, PackedModel& packed);

}  // namespace palpate
