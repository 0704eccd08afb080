// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace palpate {

/// The vector targets this machine can run ("AVX3", "AVX2", "SSE4", ...), the best first; empty
/// where Palpate was built without vector code.
std::vector<std::string> simd_targets();

}  // namespace palpate
