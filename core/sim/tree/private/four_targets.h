// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

// How code over four doubles is compiled: once for every vector target that highway has, or, in a
// file that defines PALPATE_TREE_PLAIN first, once without vector code.

#ifdef PALPATE_TREE_PLAIN
#define PALPATE_TREE_TARGETED 1
#define PALPATE_TREE_TARGET plain_code
#define PALPATE_TREE_BEGIN
#define PALPATE_TREE_END
#define PALPATE_TREE_INLINE inline
#else
// doubles come four at a time from AVX2 on
#define PALPATE_TREE_TARGETED (HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#define PALPATE_TREE_TARGET HWY_NAMESPACE
#define PALPATE_TREE_BEGIN HWY_BEFORE_NAMESPACE();
#define PALPATE_TREE_END HWY_AFTER_NAMESPACE();
#define PALPATE_TREE_INLINE HWY_INLINE
#endif

namespace palpate {

/// Kernels as compiled for one of highway's targets; null where that is not compiled for.
template <class Kernels>
struct TargetKernels {
  std::int64_t target;
  const Kernels& (*kernels)() noexcept;
};

/// Those of a machine that has these targets, in their order, and plain code last.
template <class Kernels>
std::vector<const Kernels*> list_supported(std::span<const TargetKernels<Kernels>> compiled,
                                           std::int64_t supported, const Kernels& plain) {
  std::vector<const Kernels*> found;
  for (const TargetKernels<Kernels>& each : compiled) {
    if (each.kernels == nullptr || (supported & each.target) == 0) continue;
    found.push_back(&each.kernels());
  }
  found.push_back(&plain);
  return found;
}

}  // namespace palpate
