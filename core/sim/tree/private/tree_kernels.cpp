// SPDX-License-Identifier: BSD-3-Clause
// The file highway compiles once for every vector target, and the list of what came of it.
#include "palpate/sim/tree/private/tree_kernels.h"

#include <bit>

#include "palpate/sim/base/private/vector_targets.h"
#include "palpate/sim/tree/private/four_targets.h"

#ifdef PALPATE_SIMD

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "palpate/sim/tree/private/tree_kernels.cpp"
#include <hwy/foreach_target.h>
// after it, or its first pass would be the last
#include <hwy/highway.h>

#include "palpate/sim/tree/private/four-inl.h"
#include "palpate/sim/tree/private/tree_queries-inl.h"

#if PALPATE_TREE_TARGETED
HWY_BEFORE_NAMESPACE();
namespace palpate::tree_kernels {
namespace HWY_NAMESPACE {

const Kernels& kernels() noexcept {
  static const Kernels kernels = list_kernels(hwy::TargetName(HWY_TARGET));
  return kernels;
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate::tree_kernels
HWY_AFTER_NAMESPACE();
#endif

#endif  // PALPATE_SIMD

#if !defined(PALPATE_SIMD) || HWY_ONCE
namespace palpate::tree_kernels {
namespace {

std::vector<const Kernels*> find_available() {
#if defined(PALPATE_SIMD) && HWY_ARCH_X86
  const TargetKernels<Kernels> compiled[] = {{HWY_AVX3, HWY_CHOOSE_AVX3(kernels)},
                                             {HWY_AVX2, HWY_CHOOSE_AVX2(kernels)}};
  return list_supported<Kernels>(compiled, hwy::SupportedTargets(), plain());
#else
  return list_supported<Kernels>({}, 0, plain());
#endif
}

}  // namespace

std::span<const Kernels* const> available() noexcept {
  static const std::vector<const Kernels*> kernels = find_available();
  return kernels;
}

const Kernels& best() noexcept {
  static const Kernels& kernels = *available().front();
  return kernels;
}

}  // namespace palpate::tree_kernels
#endif
