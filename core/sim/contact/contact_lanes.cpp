// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "palpate/sim/base/private/vector_targets.h"
#include "palpate/sim/contact/find_candidates.h"
#include "palpate/sim/contact/private/capsule_slices.h"

#ifdef PALPATE_SIMD

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "palpate/sim/contact/contact_lanes.cpp"
#include <hwy/foreach_target.h>
// after it, or its first pass would be the last
#include <hwy/highway.h>

#include "palpate/sim/contact/private/contact_lanes-inl.h"

#if HWY_ONCE
namespace palpate {
namespace {

struct Entry {
  std::int64_t target;
  ContactLanes::Find find, find_capsules, find_jaws;
  int (*width)() noexcept;
};

constexpr Entry kEntries[] = {
#if HWY_ARCH_X86
    {HWY_AVX3, HWY_CHOOSE_AVX3(find_contacts), HWY_CHOOSE_AVX3(find_capsule_contacts),
     HWY_CHOOSE_AVX3(find_jaw_contacts), HWY_CHOOSE_AVX3(count_lanes)},
    {HWY_AVX2, HWY_CHOOSE_AVX2(find_contacts), HWY_CHOOSE_AVX2(find_capsule_contacts),
     HWY_CHOOSE_AVX2(find_jaw_contacts), HWY_CHOOSE_AVX2(count_lanes)},
    {HWY_SSE4, HWY_CHOOSE_SSE4(find_contacts), HWY_CHOOSE_SSE4(find_capsule_contacts),
     HWY_CHOOSE_SSE4(find_jaw_contacts), HWY_CHOOSE_SSE4(count_lanes)},
#elif HWY_ARCH_ARM
    {HWY_NEON, HWY_CHOOSE_NEON(find_contacts), HWY_CHOOSE_NEON(find_capsule_contacts),
     HWY_CHOOSE_NEON(find_jaw_contacts), HWY_CHOOSE_NEON(count_lanes)},
#endif
};

void choose_target(std::string_view target, ContactLanes& lanes) {
  for (const Entry& entry : kEntries) {
    const bool meant = target.empty() || target == hwy::TargetName(entry.target);
    if (!meant || !entry.find || (hwy::SupportedTargets() & entry.target) == 0) continue;
    lanes.find = entry.find;
    lanes.find_capsules = entry.find_capsules;
    lanes.find_jaws = entry.find_jaws;
    lanes.width = entry.width();
    return;
  }
}

}  // namespace

std::int64_t find_target(const ContactLanes& lanes) noexcept {
  for (const Entry& entry : kEntries) {
    if (lanes.find != nullptr && lanes.find == entry.find) return entry.target;
  }
  return 0;
}

}  // namespace palpate
#endif

#else

namespace palpate {
namespace {

void choose_target(std::string_view, ContactLanes&) {}

}  // namespace

std::int64_t find_target(const ContactLanes&) noexcept { return 0; }

}  // namespace palpate

#endif

#if !defined(HWY_ONCE) || HWY_ONCE
namespace palpate {

ContactLanes::ContactLanes(int capacity, std::string_view target, int capsules) {
  choose_target(target, *this);
  if (find == nullptr) return;
  const auto size = static_cast<std::size_t>(capacity * std::max(1, capsules) + width);
  if (capsules > 0) {
    capsule.resize(size);
    for (Column& column : axis) column.resize(size);
  }
  triangle.resize(size);
  border.resize(size);
  for (Column& column : corners) column.resize(size);
  for (Column& column : weights) column.resize(size);
  for (Column& column : direction) column.resize(size);
  for (Column* column : {&rest_area, &distance, &force, &stiffness}) column->resize(size);
}

}  // namespace palpate
#endif
