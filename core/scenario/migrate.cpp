// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/migrate.h"

namespace palpate::scenario {

void migrate(std::span<const Migration> steps, Container& container) {
  const int newest = static_cast<int>(steps.size()) + 1;
  for (; container.version < newest; ++container.version) {
    steps[static_cast<std::size_t>(container.version) - 1](container);
  }
}

/// Version 1 is the first.
std::span<const Migration> migrations() noexcept { return {}; }

int newest_version() noexcept { return static_cast<int>(migrations().size()) + 1; }

}  // namespace palpate::scenario
