// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// Calls `action(i)` for every particle that is not fixed, in ascending order.
template <class Action>
void for_each_free(const TissueModel& model, Action action) {
  auto held = model.fixed.begin();
  for (int i = 0; i < particle_count(model); ++i) {
    if (held != model.fixed.end() && *held == i) {
      ++held;
    } else {
      action(i);
    }
  }
}

}  // namespace palpate
