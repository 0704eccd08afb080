// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by contact_lanes.cpp: closest points, and the contact law.
#if defined(PALPATE_CONTACT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_CONTACT_LANES_INL_H
#undef PALPATE_CONTACT_LANES_INL_H
#else
#define PALPATE_CONTACT_LANES_INL_H
#endif

#include <hwy/highway.h>

#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/contact/find_candidates.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace palpate {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<double, 8>;
using Real = hn::Vec<Lanes>;
inline constexpr Lanes kLanes;

struct Points {
  Real x, y, z;
};

HWY_INLINE Points operator-(const Points& a, const Points& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Points operator+(const Points& a, const Points& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Points add_scaled(const Real s, const Points& a, const Points& b) {
  return {hn::MulAdd(s, a.x, b.x), hn::MulAdd(s, a.y, b.y), hn::MulAdd(s, a.z, b.z)};
}
HWY_INLINE Real dot(const Points& a, const Points& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE Points cross(const Points& a, const Points& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
HWY_INLINE Points choose(const hn::Mask<Lanes> mask, const Points& yes, const Points& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
          hn::IfThenElse(mask, yes.z, no.z)};
}
template <std::size_t size>
HWY_INLINE Points load_points(const std::array<ContactLanes::Column, size>& columns,
                              std::size_t first, std::size_t at) {
  return {hn::Load(kLanes, columns[first].data() + at),
          hn::Load(kLanes, columns[first + 1].data() + at),
          hn::Load(kLanes, columns[first + 2].data() + at)};
}
HWY_INLINE void store_points(const Points& points, std::size_t at,
                             std::array<ContactLanes::Column, 3>& columns) {
  hn::Store(points.x, kLanes, columns[0].data() + at);
  hn::Store(points.y, kLanes, columns[1].data() + at);
  hn::Store(points.z, kLanes, columns[2].data() + at);
}

/// The closest point so far: its weights, the arm from it to the centre and its square.
struct Closest {
  Points weights, arm;
  Real square;
};

/// Keeps the nearer one; `arm` goes from the new point to the centre.
HWY_INLINE void keep_nearer(const Points& weights, const Points& arm, Closest& best) {
  const Real square = dot(arm, arm);
  const auto nearer = hn::Lt(square, best.square);
  best.weights = choose(nearer, weights, best.weights);
  best.arm = choose(nearer, arm, best.arm);
  best.square = hn::IfThenElse(nearer, square, best.square);
}

/// Where along an edge, from 0 to 1, the point closest to the end of `to` from its start lies.
HWY_INLINE Real find_on_edge(const Points& to, const Points& edge) {
  const Real zero = hn::Zero(kLanes), one = hn::Set(kLanes, 1.0), square = dot(edge, edge);
  const auto has_length = hn::Gt(square, zero);
  const Real t = hn::Div(dot(to, edge), hn::IfThenElse(has_length, square, one));
  return hn::IfThenElseZero(has_length, hn::Min(hn::Max(t, zero), one));
}

/// The foot of the perpendicular where that falls inside, and the nearest points of the edges:
/// the nearest of the four [Ericson04].
HWY_INLINE Closest find_closest(const Points& p, const Points& a, const Points& b,
                                const Points& c) {
  const Real zero = hn::Zero(kLanes), one = hn::Set(kLanes, 1.0);
  const Points ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const Real on_ab = find_on_edge(ap, ab), on_bc = find_on_edge(bp, c - b);
  const Real on_ca = find_on_edge(cp, a - c);
  Closest best;
  best.weights = {hn::Sub(one, on_ab), on_ab, zero};
  best.arm = add_scaled(hn::Neg(on_ab), ab, ap);
  best.square = dot(best.arm, best.arm);
  keep_nearer({zero, hn::Sub(one, on_bc), on_bc}, add_scaled(hn::Neg(on_bc), c - b, bp), best);
  keep_nearer({on_ca, zero, hn::Sub(one, on_ca)}, add_scaled(hn::Neg(on_ca), a - c, cp), best);

  const Real aa = dot(ab, ab), cc = dot(ac, ac), bc = dot(ab, ac);
  const Real determinant = hn::MulSub(aa, cc, hn::Mul(bc, bc));
  const auto is_plane = hn::Gt(determinant, zero);
  const Real inverse = hn::Div(one, hn::IfThenElse(is_plane, determinant, one));
  const Real d1 = dot(ab, ap), d2 = dot(ac, ap);
  const Real v = hn::Mul(hn::MulSub(cc, d1, hn::Mul(bc, d2)), inverse);
  const Real w = hn::Mul(hn::MulSub(aa, d2, hn::Mul(bc, d1)), inverse);
  const Real u = hn::Sub(one, hn::Add(v, w));
  const auto inside = hn::And(is_plane, hn::Ge(hn::Min(hn::Min(u, v), w), zero));
  const Points arm = add_scaled(hn::Neg(w), ac, add_scaled(hn::Neg(v), ab, ap));
  const Real square = hn::IfThenElse(inside, dot(arm, arm), best.square);
  const auto nearer = hn::Lt(square, best.square);
  best.weights = choose(nearer, {u, v, w}, best.weights);
  best.arm = choose(nearer, arm, best.arm);
  best.square = hn::IfThenElse(nearer, square, best.square);
  return best;
}

HWY_INLINE Real clamp_unit(const Real t) {
  return hn::Min(hn::Max(t, hn::Zero(kLanes)), hn::Set(kLanes, 1.0));
}

/// a/b, and 0 where b is not positive.
HWY_INLINE Real divide(const Real a, const Real b) {
  const auto positive = hn::Gt(b, hn::Zero(kLanes));
  return hn::IfThenElseZero(positive,
                            hn::Div(a, hn::IfThenElse(positive, b, hn::Set(kLanes, 1.0))));
}

/// The nearest points of an axis and an edge that starts at `start`: weights of the edge's start
/// and end, and the arm between them.
struct OnEdge {
  Real start, end;
  Points arm;
};

HWY_INLINE OnEdge find_axis_on_edge(const Points& from, const Points& axis, const Points& start,
                                    const Points& edge) {
  const Points r = from - start;
  const Real a = dot(axis, axis), e = dot(edge, edge), b = dot(axis, edge);
  const Real c = dot(axis, r), f = dot(edge, r);
  const Real determinant = hn::MulSub(a, e, hn::Mul(b, b));
  const Real least = hn::Mul(hn::Set(kLanes, kParallel), hn::Mul(a, e));
  const Real s0 = hn::IfThenElse(hn::Gt(determinant, least),
                                 clamp_unit(divide(hn::MulSub(b, f, hn::Mul(c, e)), determinant)),
                                 hn::Set(kLanes, 0.5));
  const Real t = clamp_unit(divide(hn::MulAdd(b, s0, f), e));
  const Real s = clamp_unit(divide(hn::MulSub(b, t, c), a));
  return {hn::Sub(hn::Set(kLanes, 1.0), t), t,
          add_scaled(hn::Neg(t), edge, add_scaled(s, axis, r))};
}

/// The closest points of a capsule's axis and a triangle that it does not cross, of those of both
/// ends and of the edges.
HWY_INLINE Closest find_closest_of_axis(const Points& from, const Points& to, const Points& a,
                                        const Points& b, const Points& c, const Closest& at_from,
                                        const Closest& at_to) {
  const Real zero = hn::Zero(kLanes);
  Closest best = at_from;
  keep_nearer(at_to.weights, at_to.arm, best);
  const Points axis = to - from;
  const OnEdge ab = find_axis_on_edge(from, axis, a, b - a);
  keep_nearer({ab.start, ab.end, zero}, ab.arm, best);
  const OnEdge bc = find_axis_on_edge(from, axis, b, c - b);
  keep_nearer({zero, bc.start, bc.end}, bc.arm, best);
  const OnEdge ca = find_axis_on_edge(from, axis, c, a - c);
  keep_nearer({ca.end, zero, ca.start}, ca.arm, best);
  return best;
}

/// Weights of points of a triangle, by the squares of how wide the capsule is where it cuts them.
struct Spread {
  Points weights;
  Real all;
};

HWY_INLINE void add_point(double radius, const Points& weights, const Real square, Spread& sum) {
  const Real part = hn::Max(hn::Zero(kLanes), hn::Sub(hn::Set(kLanes, radius * radius), square));
  sum.weights = add_scaled(part, weights, sum.weights);
  sum.all = hn::Add(sum.all, part);
}

/// Weights of the point of an edge at t, of its start and end.
struct SpreadOnEdge {
  Real start, end, square;
};

HWY_INLINE SpreadOnEdge spread_on_edge(const Points& from, const Points& axis, const Points& start,
                                       const Points& edge) {
  const Points r = from - start;
  const Real aa = dot(axis, axis), ee = dot(edge, edge), ab = dot(axis, edge);
  const Real ar = dot(axis, r), er = dot(edge, r);
  const Real whole = hn::Mul(aa, ee), most = hn::Mul(hn::Set(kLanes, kJawSpread), whole);
  const Real over =
      hn::Add(hn::MulSub(aa, er, hn::Mul(ab, ar)), hn::Mul(hn::Set(kLanes, 0.5), most));
  const Real t = clamp_unit(divide(over, hn::Add(hn::NegMulAdd(ab, ab, whole), most)));
  const Real s = clamp_unit(divide(hn::MulSub(ab, t, ar), aa));
  const Points arm = add_scaled(hn::Neg(t), edge, add_scaled(s, axis, r));
  return {hn::Sub(hn::Set(kLanes, 1.0), t), t, dot(arm, arm)};
}

/// spread_contact() with the closest points of both ends of the axis.
HWY_INLINE void spread(double radius, const Points& from, const Points& axis, const Points& a,
                       const Points& b, const Points& c, const Closest& at_from,
                       const Closest& at_to, Closest& best) {
  const Real zero = hn::Zero(kLanes);
  Spread sum{{zero, zero, zero}, zero};
  add_point(radius, at_from.weights, at_from.square, sum);
  add_point(radius, at_to.weights, at_to.square, sum);
  const SpreadOnEdge ab = spread_on_edge(from, axis, a, b - a);
  add_point(radius, {ab.start, ab.end, zero}, ab.square, sum);
  const SpreadOnEdge bc = spread_on_edge(from, axis, b, c - b);
  add_point(radius, {zero, bc.start, bc.end}, bc.square, sum);
  const SpreadOnEdge ca = spread_on_edge(from, axis, c, a - c);
  add_point(radius, {ca.end, zero, ca.start}, ca.square, sum);
  const auto pressed = hn::Gt(sum.all, zero);
  const Real inverse =
      hn::Div(hn::Set(kLanes, 1.0), hn::IfThenElse(pressed, sum.all, hn::Set(kLanes, 1.0)));
  const Points mean = {hn::Mul(sum.weights.x, inverse), hn::Mul(sum.weights.y, inverse),
                       hn::Mul(sum.weights.z, inverse)};
  best.weights = choose(pressed, mean, best.weights);
}

/// The law of find_contact for the lanes from `at` on, of triangles a, b, c.
HWY_INLINE void write_contacts_at(std::size_t at, double radius, double stiffness,
                                  const Closest& closest, const Points& a, const Points& b,
                                  const Points& c, ContactLanes& lanes) {
  const Real zero = hn::Zero(kLanes), one = hn::Set(kLanes, 1.0), r = hn::Set(kLanes, radius);
  const Real distance = hn::Sqrt(closest.square), depth = hn::Sub(r, distance);
  const Points normal = cross(b - a, c - a);
  const Real twice_area = hn::Sqrt(dot(normal, normal));

  const auto has_arm = hn::Gt(distance, hn::Set(kLanes, kNoArm * radius));
  const Real side = hn::Set(kLanes, lanes.side);
  const Points front = {hn::Mul(side, normal.x), hn::Mul(side, normal.y), hn::Mul(side, normal.z)};
  const Points arm = choose(has_arm, closest.arm, front);
  const Real length = hn::IfThenElse(has_arm, distance, twice_area);
  const auto has_length = hn::Gt(length, zero);
  const Real inverse = hn::Div(one, hn::IfThenElse(has_length, length, one));
  const Real facing = hn::Mul(dot(closest.arm, front),
                              hn::Div(inverse, hn::Max(twice_area, hn::Set(kLanes, 1e-300))));
  const Real share = hn::IfThenElse(
      has_arm, hn::Min(one, hn::Mul(facing, hn::Set(kLanes, 1.0 / kFullFacing))), one);
  const auto touches = hn::And(hn::And(hn::Gt(depth, zero), has_length), hn::Gt(share, zero));

  const Real area = hn::Max(hn::Load(kLanes, lanes.rest_area.data() + at),
                            hn::Mul(twice_area, hn::Set(kLanes, 0.5)));
  const Real k =
      hn::IfThenElseZero(touches, hn::Mul(hn::Mul(share, hn::Set(kLanes, stiffness)), area));
  const Real z = hn::Max(hn::Set(kLanes, kBarrierFloor),
                         hn::NegMulAdd(depth, hn::Set(kLanes, 1.0 / radius), one));
  const Real slope = hn::Div(k, z);
  store_points(closest.weights, at, lanes.weights);
  store_points({hn::Mul(arm.x, inverse), hn::Mul(arm.y, inverse), hn::Mul(arm.z, inverse)}, at,
               lanes.direction);
  hn::Store(distance, kLanes, lanes.distance.data() + at);
  hn::Store(hn::Mul(slope, depth), kLanes, lanes.force.data() + at);
  hn::Store(hn::Div(slope, z), kLanes, lanes.stiffness.data() + at);
}

HWY_INLINE Points load_centre(const ContactLanes& lanes) {
  return {hn::Set(kLanes, lanes.centre.x()), hn::Set(kLanes, lanes.centre.y()),
          hn::Set(kLanes, lanes.centre.z())};
}

void find_contacts(ContactLanes& lanes, double radius, double stiffness) noexcept {
  const Points p = load_centre(lanes);
  for (std::size_t at = 0; at < static_cast<std::size_t>(lanes.count); at += hn::MaxLanes(kLanes)) {
    const Points a = load_points(lanes.corners, 0, at), b = load_points(lanes.corners, 3, at);
    const Points c = load_points(lanes.corners, 6, at);
    write_contacts_at(at, radius, stiffness, find_closest(p, a, b, c), a, b, c, lanes);
  }
}

template <bool spreads>
HWY_INLINE void find_axis_contacts(ContactLanes& lanes, double radius, double stiffness) {
  const Points p = load_centre(lanes);
  for (std::size_t at = 0; at < static_cast<std::size_t>(lanes.count); at += hn::MaxLanes(kLanes)) {
    const Points a = load_points(lanes.corners, 0, at), b = load_points(lanes.corners, 3, at);
    const Points c = load_points(lanes.corners, 6, at);
    const Points from = p + load_points(lanes.axis, 0, at), to = p + load_points(lanes.axis, 3, at);
    const Closest at_from = find_closest(from, a, b, c), at_to = find_closest(to, a, b, c);
    Closest best = find_closest_of_axis(from, to, a, b, c, at_from, at_to);
    if constexpr (spreads) {
      const auto pressed = hn::Lt(best.square, hn::Set(kLanes, radius * radius));
      if (!hn::AllFalse(kLanes, pressed)) {
        spread(radius, from, to - from, a, b, c, at_from, at_to, best);
      }
    }
    write_contacts_at(at, radius, stiffness, best, a, b, c, lanes);
  }
}

void find_capsule_contacts(ContactLanes& lanes, double radius, double stiffness) noexcept {
  find_axis_contacts<false>(lanes, radius, stiffness);
}

void find_jaw_contacts(ContactLanes& lanes, double radius, double stiffness) noexcept {
  find_axis_contacts<true>(lanes, radius, stiffness);
}

int count_lanes() noexcept { return static_cast<int>(hn::MaxLanes(kLanes)); }

}  // namespace HWY_NAMESPACE
}  // namespace palpate
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET

#endif  // PALPATE_CONTACT_LANES_INL_H
