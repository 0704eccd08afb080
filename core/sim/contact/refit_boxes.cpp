// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/refit_boxes.h"

#include <utility>

#include "palpate/sim/contact/box.h"

#ifdef PALPATE_SIMD

// a point takes a vector of four doubles, which narrower targets do not have
#define HWY_DISABLED_TARGETS \
  (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_SSE4 | HWY_NEON)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "palpate/sim/contact/refit_boxes.cpp"
#include <hwy/foreach_target.h>
// after it, or its first pass would be the last
#include <hwy/highway.h>

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
HWY_BEFORE_NAMESPACE();
namespace palpate {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Four = hn::FixedTag<double, 4>;
using Real = hn::Vec<Four>;

using Two = hn::Half<Four>;

/// Three numbers, and nothing read beyond them.
HWY_INLINE Real load_point(const double* from) {
  return hn::MaskedLoad(hn::FirstN(Four(), 3), Four(), from);
}
/// The same in two parts, as store_corner wrote them: what was written a moment ago is read from
/// the store that is under way only where that store holds all of it.
HWY_INLINE Real load_corner(const double* from) {
  return hn::Combine(Four(), hn::Set(Two(), from[2]), hn::LoadU(Two(), from));
}
HWY_INLINE void store_corner(const Real v, double* to) {
  hn::StoreU(hn::LowerHalf(Two(), v), Two(), to);
  to[2] = hn::GetLane(hn::UpperHalf(Two(), v));
}

void refit(const TreeBoxes& boxes) noexcept {
  const Vec3* x = boxes.x.data();
  AabbTree::Node* nodes = boxes.nodes.data();
  for (const auto& [node, first, count] : boxes.leaves) {
    const int* particle = boxes.particles.data() + first;
    Real low = load_point(x[*particle].data()), high = low;
    for (int done = 0; done < count; done += TreeBoxes::kBlock, particle += TreeBoxes::kBlock) {
      for (int k = 0; k < TreeBoxes::kBlock; ++k) {
        const Real point = load_point(x[particle[k]].data());
        low = hn::Min(low, point);
        high = hn::Max(high, point);
      }
    }
    store_corner(low, nodes[node].low.data());
    store_corner(high, nodes[node].high.data());
  }
  for (const int i : boxes.inner) {
    AabbTree::Node& node = nodes[i];
    const AabbTree::Node &left = nodes[i + 1], &right = nodes[node.first];
    const Real low = hn::Min(load_corner(left.low.data()), load_corner(right.low.data()));
    const Real high = hn::Max(load_corner(left.high.data()), load_corner(right.high.data()));
    store_corner(low, node.low.data());
    store_corner(high, node.high.data());
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate
HWY_AFTER_NAMESPACE();
#endif

#endif

#if !defined(HWY_ONCE) || HWY_ONCE
namespace palpate {
namespace {

using Refit = void (*)(const TreeBoxes& boxes) noexcept;

void refit_plainly(const TreeBoxes& boxes) noexcept {
  for (const auto& [node, first, count] : boxes.leaves) {
    Box box;
    for (int k = first; k < first + count; ++k) box.add(boxes.x[boxes.particles[k]]);
    boxes.nodes[node].low = box.low;
    boxes.nodes[node].high = box.high;
  }
  for (const int i : boxes.inner) {
    AabbTree::Node& node = boxes.nodes[i];
    const AabbTree::Node &left = boxes.nodes[i + 1], &right = boxes.nodes[node.first];
    node.low = left.low.cwiseMin(right.low);
    node.high = left.high.cwiseMax(right.high);
  }
}

Refit choose_refit() noexcept {
#if defined(PALPATE_SIMD) && HWY_ARCH_X86
  const std::pair<std::int64_t, Refit> refits[] = {{HWY_AVX3, HWY_CHOOSE_AVX3(refit)},
                                                   {HWY_AVX2, HWY_CHOOSE_AVX2(refit)}};
  for (const auto& [target, refit] : refits) {
    if (refit && (hwy::SupportedTargets() & target) != 0) return refit;
  }
#endif
  return &refit_plainly;
}

}  // namespace

void refit_boxes(const TreeBoxes& boxes) noexcept {
  static const Refit refit = choose_refit();
  refit(boxes);
}

}  // namespace palpate
#endif
