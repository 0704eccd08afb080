// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "palpate/sim/base/private/refuse.h"

namespace palpate {

/// What options of surfaces and of solids have in common: rows per vertex, held vertices and drag.
/// Throws std::invalid_argument where one is not possible.
template <class Options>
void check_common_options(const Options& options, std::size_t vertex_count) {
  const auto& scale = options.stiffness_scale;
  if (!scale.empty() && scale.size() != vertex_count) {
    refuse("options: stiffness_scale", write_text(scale.size(), " rows"),
           write_text("none, or one per vertex: ", vertex_count));
  }
  for (std::size_t i = 0; i < scale.size(); ++i) {
    if (std::isfinite(scale[i]) && scale[i] > 0.0) continue;
    refuse(write_text("options: stiffness_scale: row ", i), write_text(scale[i]),
           "a positive number");
  }
  for (std::size_t i = 0; i < options.fixed.size(); ++i) {
    if (options.fixed[i] >= 0 && options.fixed[i] < static_cast<int>(vertex_count)) continue;
    refuse(write_text("options: fixed: row ", i), write_text("vertex ", options.fixed[i]),
           write_text("0 to ", vertex_count - 1));
  }
  if (!(std::isfinite(options.drag) && options.drag >= 0.0)) {
    refuse("options: drag", write_text(options.drag, " 1/s"), "0 or a positive number");
  }
}

}  // namespace palpate
