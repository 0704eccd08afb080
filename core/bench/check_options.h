// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/bench/bench.h"

namespace palpate::bench {

/// Whether a work was asked for.
bool is_wanted(const std::string& work, const BenchOptions& options);

/// Throws std::invalid_argument, beginning with `where`, for a work that is not among `known` and
/// for substeps that are none.
void check_options(const std::string& where, const std::vector<std::string>& known,
                   const BenchOptions& options);

}  // namespace palpate::bench
