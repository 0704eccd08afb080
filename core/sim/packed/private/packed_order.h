// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// Particles in a sequence in which packed kernels keep them: neighbours close together, and within
/// windows those with many links first, so that slices pad little. Bands are the rings around one
/// end of the body, patches compact pieces of its surface.
std::vector<int> find_bands(const TissueModel& model);
std::vector<int> find_patches(const TissueModel& model);

/// Triangles (N = 3), tetrahedra (4) or prisms (6) in the sequence in which packs of `width` take
/// them: such that those of a pack share no corner, as far as can be had among the next
/// `lookahead`. -1 where a lane stays empty.
template <std::size_t N>
std::vector<int> find_pack_order(std::span<const std::array<int, N>> elements, int width,
                                 int lookahead);

}  // namespace palpate
