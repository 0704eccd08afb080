// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/scenario/container.h"

namespace palpate::scenario {

/// Makes of a container of one version the same container of the next; its version is counted up
/// by migrate(). Throws FileError for what no program ever wrote.
using Migration = void (*)(Container& container);

/// Takes a container from its version to steps.size() + 1; steps[v - 1] leads from v to v + 1.
void migrate(std::span<const Migration> steps, Container& container);

/// The steps of `.palpate`, one for each version before the newest.
std::span<const Migration> migrations() noexcept;

/// The newest version of `.palpate`.
int newest_version() noexcept;

}  // namespace palpate::scenario
