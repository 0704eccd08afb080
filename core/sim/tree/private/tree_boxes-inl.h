// SPDX-License-Identifier: BSD-3-Clause
// Included once per target by tree_kernels.cpp, once by tree_kernels_plain.cpp: the boxes of a
// node, in float.
//
// Boxes and what is asked of them are rounded outwards, and a bound is widened by more than the few
// roundings that come after it. So no child is passed over that double would visit, and what a
// triangle offers is then measured in double: the answers are those of double.
#if defined(PALPATE_TREE_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_TREE_BOXES_INL_H
#undef PALPATE_TREE_BOXES_INL_H
#else
#define PALPATE_TREE_BOXES_INL_H
#endif

#include "palpate/sim/tree/private/tree_points-inl.h"

#if PALPATE_TREE_TARGETED
PALPATE_TREE_BEGIN
namespace palpate::tree_kernels::PALPATE_TREE_TARGET {

/// A bound that is not negative, widened by more than ten roundings of a float.
inline constexpr float kWiden = 1.0f + 2e-6f;
inline constexpr float kWidenLeast = 1e-37f;
PALPATE_TREE_INLINE float widen(double most) {
  return most < 1e38 ? static_cast<float>(most) * kWiden + kWidenLeast
                     : std::numeric_limits<float>::infinity();
}

/// A point, between floats.
struct Cell {
  explicit Cell(const Vec3& p) noexcept {
    store_rounded_down(load_point(p), low);
    store_rounded_up(load_point(p), high);
  }
  alignas(16) float low[4];
  alignas(16) float high[4];
};

/// [m²] As compute_squared_distance(), or less.
PALPATE_TREE_INLINE Eight measure_distances(const Cell& p, const AabbTree::Node& node) {
  const Eight zero = set_eight(0.0f);
  Eight squares[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const Eight below = load_eight(node.low[k].data()) - set_eight(p.high[k]);
    const Eight above = set_eight(p.low[k]) - load_eight(node.high[k].data());
    const Eight d = max(max(below, above), zero);
    squares[k] = d * d;
  }
  return squares[0] + squares[1] + squares[2];
}

/// A segment and by how much boxes are grown, between floats.
struct Slabs {
  explicit Slabs(const Segment& segment) noexcept : end(widen(segment.end)) {
    store_rounded_down(load_point(segment.from) - set(segment.grow), lower);
    store_rounded_up(load_point(segment.from) + set(segment.grow), upper);
    for (int k = 0; k < 3; ++k) {
      const double size = std::abs(segment.direction[k]);
      // what float cannot divide by parts no boxes
      kind[k] = size == 0.0 ? parallel : size > 1e-30 && size < 1e30 ? crossing : unknown;
      inverse[k] = kind[k] == crossing ? static_cast<float>(segment.inverse[k]) : 0.0f;
    }
  }
  enum Kind { parallel, crossing, unknown };
  Kind kind[3];
  alignas(16) float lower[4];
  alignas(16) float upper[4];
  float inverse[3];
  float end;
};

/// As enter_box(), or earlier.
PALPATE_TREE_INLINE Eight enter_boxes(const Slabs& segment, const AabbTree::Node& node) {
  const Eight infinity = set_eight(std::numeric_limits<float>::infinity());
  const Eight zero = set_eight(0.0f);
  Eight in = zero, out = set_eight(segment.end);
  for (std::size_t k = 0; k < 3; ++k) {
    if (segment.kind[k] == Slabs::unknown) continue;
    const Eight to_low = load_eight(node.low[k].data()) - set_eight(segment.upper[k]);
    const Eight to_high = load_eight(node.high[k].data()) - set_eight(segment.lower[k]);
    if (segment.kind[k] == Slabs::parallel) {
      out = select((to_low <= zero) & (zero <= to_high), out, set_eight(-1.0f));
      continue;
    }
    const Eight inverse = set_eight(segment.inverse[k]);
    const Eight t0 = to_low * inverse, t1 = to_high * inverse;
    in = max(in, min(t0, t1));
    out = min(out, max(t0, t1));
  }
  // what float cannot count is far, not missed
  const Eight held = min(in, set_eight(std::numeric_limits<float>::max()));
  return select(in <= out * set_eight(kWiden) + set_eight(kWidenLeast), held, infinity);
}

}  // namespace palpate::tree_kernels::PALPATE_TREE_TARGET
PALPATE_TREE_END
#endif

#endif  // PALPATE_TREE_BOXES_INL_H
