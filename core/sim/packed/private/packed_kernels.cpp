// SPDX-License-Identifier: BSD-3-Clause
// The file highway compiles once for every vector target, and the list of what came of it.
#include "palpate/sim/packed/private/packed_kernels.h"

#include "palpate/sim/base/private/vector_targets.h"

#ifdef PALPATE_SIMD

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "palpate/sim/packed/private/packed_kernels.cpp"
#include <hwy/foreach_target.h>
// after it, or its first pass would be the last
#include <hwy/highway.h>

#include "palpate/sim/packed/private/packed_compare-inl.h"
#include "palpate/sim/packed/private/packed_maxwell-inl.h"
#include "palpate/sim/packed/private/packed_prisms-inl.h"
#include "palpate/sim/packed/private/packed_triangles-inl.h"
#include "palpate/sim/packed/private/packed_volumes-inl.h"

// a machine without vectors runs the reference kernels
#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace palpate::packed_kernels {
namespace HWY_NAMESPACE {

template <const auto PackedModel::*packs>
bool has_packs(const PackedModel& model) noexcept {
  return (model.*packs).pack_count > 0;
}

/// In the sequence in which their forces are added.
constexpr PackedLaw kLaws[] = {
    {&has_packs<&PackedModel::triangles>, &accumulate_triangles},
    {&has_packs<&PackedModel::prisms>, &accumulate_prisms},
    {&has_packs<&PackedModel::volumes>, &accumulate_volumes},
    {&relaxes, &accumulate_maxwell, &count_maxwell},
};

const Kernels& kernels() noexcept {
  static const Kernels kernels = {hwy::TargetName(HWY_TARGET),
                                  static_cast<int>(kWidth),
                                  kLaws,
                                  &accumulate_pressure,
                                  &advance,
                                  &compute_pressure_work,
                                  &unpack,
                                  &find_moved};
  return kernels;
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate::packed_kernels
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace palpate::packed_kernels {
namespace {

std::vector<const Kernels*> find_available() {
  struct Entry {
    std::int64_t target;
    const Kernels& (*kernels)() noexcept;
  };
  const Entry entries[] = {
#if HWY_ARCH_X86
    {HWY_AVX3, HWY_CHOOSE_AVX3(kernels)},
    {HWY_AVX2, HWY_CHOOSE_AVX2(kernels)},
    {HWY_SSE4, HWY_CHOOSE_SSE4(kernels)},
#elif HWY_ARCH_ARM
    {HWY_NEON, HWY_CHOOSE_NEON(kernels)},
#endif
  };
  std::vector<const Kernels*> found;
  for (const Entry& entry : entries) {
    if (entry.kernels == nullptr || (hwy::SupportedTargets() & entry.target) == 0) continue;
    found.push_back(&entry.kernels());
  }
  return found;
}

}  // namespace

std::span<const Kernels* const> available() noexcept {
  static const std::vector<const Kernels*> kernels = find_available();
  return kernels;
}

}  // namespace palpate::packed_kernels
#endif

#else

namespace palpate::packed_kernels {

std::span<const Kernels* const> available() noexcept { return {}; }

}  // namespace palpate::packed_kernels

#endif
