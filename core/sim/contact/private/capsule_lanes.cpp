// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/base/private/vector_targets.h"
#include "palpate/sim/contact/private/capsule_slices.h"

#ifdef PALPATE_SIMD

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "palpate/sim/contact/private/capsule_lanes.cpp"
#include <hwy/foreach_target.h>
// after it, or its first pass would be the last
#include <hwy/highway.h>

#include "palpate/sim/contact/private/capsule_lanes-inl.h"

#if HWY_ONCE
namespace palpate {

SumSlices find_slice_sums(const ContactLanes& lanes) noexcept {
  switch (find_target(lanes)) {
#if HWY_ARCH_X86
    case HWY_AVX3:
      return HWY_CHOOSE_AVX3(sum_slices);
    case HWY_AVX2:
      return HWY_CHOOSE_AVX2(sum_slices);
    case HWY_SSE4:
      return HWY_CHOOSE_SSE4(sum_slices);
#elif HWY_ARCH_ARM
    case HWY_NEON:
      return HWY_CHOOSE_NEON(sum_slices);
#endif
    default:
      return nullptr;
  }
}

}  // namespace palpate
#endif

#else

namespace palpate {

SumSlices find_slice_sums(const ContactLanes&) noexcept { return nullptr; }

}  // namespace palpate

#endif
