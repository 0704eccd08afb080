// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "palpate/sim/packed/private/packed_model.h"

namespace palpate {

/// Stands where a column has no number: lanes without a link or triangle.
inline constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

/// `values` in blocks of `block`; one block alone where all of them that are numbers are the same.
/// The others become `filler`, which must be harmless.
PackedColumn make_column(std::vector<float> values, std::size_t block, float filler);

/// Those rows of `links` that are chosen.
struct ChosenLinks {
  const Links* links;
  std::vector<bool> chosen;
};

/// Lays out those of all tables; the particles must have their rows.
void pack_links(std::span<const ChosenLinks> tables, PackedModel& packed);

}  // namespace palpate
