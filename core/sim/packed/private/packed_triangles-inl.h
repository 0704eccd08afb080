// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by packed_kernels.cpp: bonds, angles and pressure of triangles.
#if defined(PALPATE_PACKED_TRIANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_PACKED_TRIANGLES_INL_H
#undef PALPATE_PACKED_TRIANGLES_INL_H
#else
#define PALPATE_PACKED_TRIANGLES_INL_H
#endif

#include "palpate/sim/dynamics/private/tensions.h"
#include "palpate/sim/packed/private/packed_advance-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace palpate::packed_kernels {
namespace HWY_NAMESPACE {

/// One number per lane for each of the three sides of a triangle, or for the corners opposite.
struct Sides {
  Real a, b, c;
};

HWY_INLINE Sides load_sides(const float* from) {
  return {load(from), load(from + kWidth), load(from + 2 * kWidth)};
}
HWY_INLINE Sides operator*(const Sides& p, const Sides& q) {
  return {hn::Mul(p.a, q.a), hn::Mul(p.b, q.b), hn::Mul(p.c, q.c)};
}
HWY_INLINE Sides operator-(const Sides& p, const Sides& q) {
  return {hn::Sub(p.a, q.a), hn::Sub(p.b, q.b), hn::Sub(p.c, q.c)};
}
/// p q + r
HWY_INLINE Sides multiply_add(const Sides& p, const Sides& q, const Sides& r) {
  return {hn::MulAdd(p.a, q.a, r.a), hn::MulAdd(p.b, q.b, r.b), hn::MulAdd(p.c, q.c, r.c)};
}
/// For each side the product of the two others.
HWY_INLINE Sides multiply_others(const Sides& p) {
  return {hn::Mul(p.b, p.c), hn::Mul(p.c, p.a), hn::Mul(p.a, p.b)};
}
/// For each side the sum of the two others.
HWY_INLINE Sides add_others(const Sides& p) {
  return {hn::Add(p.b, p.c), hn::Add(p.c, p.a), hn::Add(p.a, p.b)};
}

/// The lengths of the sides and what they divide by: Divisors of tensions.h, lane by lane.
/// `direction` is that of bonds, `pull` that of tensions: both 1/l, rounded as each always was.
struct Measured {
  Sides square, length, inverse, slope, direction, pull;
  hn::Mask<Lanes> blunt;
  bool any_blunt;
};

/// What a side divides by where lanes of a pack are shorter than `least`; unused ones always are.
HWY_INLINE void blunt(Real square, Real rest, Real least, Real& length, Real& inverse, Real& slope,
                      Real& direction, Real& pull) {
  const Real one = hn::Set(kLanes, 1.0f), two = hn::Set(kLanes, 2.0f);
  const Real directed = hn::Mul(hn::Set(kLanes, static_cast<float>(kNoDirection)), rest);
  const auto is_short = hn::Lt(square, hn::Mul(least, least));
  length = hn::Sqrt(square);
  direction = hn::IfThenElseZero(hn::Gt(length, directed), hn::Div(one, length));
  const Real part = hn::Div(length, hn::IfThenElse(is_short, least, one));
  const Real blunted = hn::Div(two, hn::Mul(least, hn::MulAdd(part, part, one)));
  inverse = hn::IfThenElse(is_short, blunted, inverse);
  slope = hn::IfThenElse(is_short, hn::Mul(part, blunted), slope);
  pull = hn::IfThenElse(is_short, direction, pull);
}

HWY_INLINE Measured measure(const Sides& rest, const Points& side_a, const Points& side_b,
                            const Points& side_c) {
  const Real share = hn::Set(kLanes, static_cast<float>(kBluntSide));
  const Sides shortest = {hn::Mul(share, rest.a), hn::Mul(share, rest.b), hn::Mul(share, rest.c)};
  const Sides least = shortest * shortest;
  Measured m;
  m.square = {dot(side_a, side_a), dot(side_b, side_b), dot(side_c, side_c)};
  m.inverse = {invert_root(hn::Max(m.square.a, least.a)), invert_root(hn::Max(m.square.b, least.b)),
               invert_root(hn::Max(m.square.c, least.c))};
  m.length = m.square * m.inverse;
  m.slope = m.direction = m.pull = m.inverse;
  m.blunt = hn::Or(hn::Or(hn::Lt(m.square.a, least.a), hn::Lt(m.square.b, least.b)),
                   hn::Lt(m.square.c, least.c));
  m.any_blunt = !hn::AllFalse(kLanes, m.blunt);
  if (m.any_blunt) {
    blunt(m.square.a, rest.a, shortest.a, m.length.a, m.inverse.a, m.slope.a, m.direction.a,
          m.pull.a);
    blunt(m.square.b, rest.b, shortest.b, m.length.b, m.inverse.b, m.slope.b, m.direction.b,
          m.pull.b);
    blunt(m.square.c, rest.c, shortest.c, m.length.c, m.inverse.c, m.slope.c, m.direction.c,
          m.pull.c);
  }
  return m;
}

/// cos_a = (b² + c² - a²) / (2 b^ c^) and cyclic, within [-1, 1].
HWY_INLINE Sides compute_cosines(const Measured& m, const Sides& inverse_others) {
  const Real one = hn::Set(kLanes, 1.0f), half = hn::Set(kLanes, 0.5f);
  const Real sum = hn::Mul(half, hn::Add(hn::Add(m.square.a, m.square.b), m.square.c));
  const auto cosine = [&](Real square, Real others) HWY_ATTR {
    return hn::Clamp(hn::Mul(hn::Sub(sum, square), others), hn::Neg(one), one);
  };
  return {cosine(m.square.a, inverse_others.a), cosine(m.square.b, inverse_others.b),
          cosine(m.square.c, inverse_others.c)};
}

/// The changes of angle that tensions and energies are made of.
struct Bent {
  Sides cosine, bend, inverse_others;
};

HWY_INLINE Bent compute_bend(const PackedTriangles& triangles, std::size_t pack,
                             const Measured& m) {
  Bent bent;
  bent.inverse_others = multiply_others(m.inverse);
  bent.cosine = compute_cosines(m, bent.inverse_others);
  bent.bend = bent.cosine - load_sides(triangles.rest_cosine.block(pack));
  return bent;
}

/// Eq 9 and Eq 11, or Eq 10, as tensions of the sides: the equations stand in tensions.h.
template <AngleLaw law>
HWY_INLINE Sides compute_tensions(const PackedTriangles& triangles, std::size_t pack,
                                  const Measured& m, const Bent& bent, const Sides& stretch) {
  const auto& [cosine, bend, inverse_others] = bent;
  const Sides stiffness = load_sides(triangles.bend_stiffness.block(pack));
  if constexpr (law == AngleLaw::eq10) {
    const Sides t = stiffness * bend;
    return {hn::Neg(t.a), hn::Neg(t.b), hn::Neg(t.c)};
  }
  const Sides coupling = load_sides(triangles.stretch_coupling.block(pack));
  const Sides torque = multiply_add(stiffness, bend, coupling * add_others(stretch));
  const Sides w = torque * m.length * inverse_others;
  const Sides s = add_others(coupling * bend);
  const auto pull = [](Real s_a, Real w_a, Real w_b, Real w_c, Real cos_b, Real cos_c) HWY_ATTR {
    return hn::MulAdd(w_b, cos_c, hn::MulAdd(w_c, cos_b, hn::Sub(s_a, w_a)));
  };
  Sides tension = {pull(s.a, w.a, w.b, w.c, cosine.b, cosine.c),
                   pull(s.b, w.b, w.c, w.a, cosine.c, cosine.a),
                   pull(s.c, w.c, w.a, w.b, cosine.a, cosine.b)};
  if (m.any_blunt) {
    const Sides near = m.length * m.inverse;
    const auto turn = [](Real torque, Real near_side, Real inverse, Real cos, Real slope) HWY_ATTR {
      return hn::Mul(torque, hn::NegMulAdd(cos, slope, hn::Mul(near_side, inverse)));
    };
    const auto pull_blunt = [&](Real now, Real s_a, Real w_a, Real by_b, Real by_c) HWY_ATTR {
      return hn::IfThenElse(m.blunt, hn::Add(hn::Add(by_b, by_c), hn::Sub(s_a, w_a)), now);
    };
    tension = {
        pull_blunt(tension.a, s.a, w.a, turn(torque.b, near.a, m.inverse.c, cosine.b, m.slope.a),
                   turn(torque.c, near.a, m.inverse.b, cosine.c, m.slope.a)),
        pull_blunt(tension.b, s.b, w.b, turn(torque.c, near.b, m.inverse.a, cosine.c, m.slope.b),
                   turn(torque.a, near.b, m.inverse.c, cosine.a, m.slope.b)),
        pull_blunt(tension.c, s.c, w.c, turn(torque.a, near.c, m.inverse.b, cosine.a, m.slope.c),
                   turn(torque.b, near.c, m.inverse.a, cosine.b, m.slope.c))};
  }
  return tension;
}

/// Bonds k (l - L)² / 2, angles and stretch-bend (K q / 2 + K_t (d + d')) q.
template <AngleLaw law>
HWY_INLINE Real compute_pack_energy(const PackedTriangles& triangles, std::size_t pack,
                                    const Bent& bent, const Sides& stretch) {
  const Real half = hn::Set(kLanes, 0.5f);
  const Sides bond = load_sides(triangles.bond_stiffness.block(pack)) * stretch * stretch;
  Real energy = hn::Mul(half, hn::Add(hn::Add(bond.a, bond.b), bond.c));
  if constexpr (law == AngleLaw::gradient) {
    const Sides bending = load_sides(triangles.bend_stiffness.block(pack)) * bent.bend;
    const Sides coupled = load_sides(triangles.stretch_coupling.block(pack)) * add_others(stretch);
    const Sides angle = multiply_add({half, half, half}, bending, coupled) * bent.bend;
    energy = hn::Add(energy, hn::Add(hn::Add(angle.a, angle.b), angle.c));
  }
  return energy;
}

/// Energy and stretch, where a lane holds a triangle.
template <AngleLaw law>
HWY_INLINE void measure_pack(const PackedTriangles& triangles, std::size_t pack, const Sides& rest,
                             const Measured& m, const Bent& bent, const Sides& stretch,
                             Sums& sums) {
  const int* corner = triangles.corner.data() + 3 * kWidth * pack;
  const auto is_triangle = differ(corner, corner + kWidth);
  const Real energy = compute_pack_energy<law>(triangles, pack, bent, stretch);
  sums.elastic = hn::Add(sums.elastic, hn::IfThenElseZero(is_triangle, energy));
  measure_part(is_triangle, m.length.a, invert(rest.a), sums);
  measure_part(is_triangle, m.length.b, invert(rest.b), sums);
  measure_part(is_triangle, m.length.c, invert(rest.c), sums);
}

/// The pulls along the three sides of the triangles of a pack.
struct Pulls {
  Points a, b, c;
};

/// Adds the damping of the bonds; velocities of the corners are at `rows`.
template <Damping damping>
HWY_INLINE void add_damping(const PackedTriangles& triangles, std::size_t pack, const float* rows,
                            const Points& side_a, const Points& side_b, const Points& side_c,
                            const Measured& m, Pulls& pull) {
  const int* corner = triangles.corner.data() + 3 * kWidth * pack;
  const Points a = gather(rows, corner), b = gather(rows, corner + kWidth);
  const Points c = gather(rows, corner + 2 * kWidth);
  const Sides damp = load_sides(triangles.bond_damping.block(pack));
  if constexpr (damping == Damping::isotropic) {
    pull.a = add_scaled(damp.a, b - c, pull.a);
    pull.b = add_scaled(damp.b, c - a, pull.b);
    pull.c = add_scaled(damp.c, a - b, pull.c);
  } else {
    const Sides rate = {dot(b - c, side_a), dot(c - a, side_b), dot(a - b, side_c)};
    const Sides scale = damp * rate * (m.direction * m.direction);
    pull.a = add_scaled(scale.a, side_a, pull.a);
    pull.b = add_scaled(scale.b, side_b, pull.b);
    pull.c = add_scaled(scale.c, side_c, pull.c);
  }
}

template <AngleLaw law, Damping damping, bool measured>
HWY_INLINE void accumulate_pack(const PackedTriangles& triangles, std::size_t pack,
                                const float* position_rows, const float* velocity_rows,
                                float* force_rows, Sums& sums) {
  const int* corner = triangles.corner.data() + 3 * kWidth * pack;
  const Points at_a = gather(position_rows, corner);
  const Points at_b = gather(position_rows, corner + kWidth);
  const Points at_c = gather(position_rows, corner + 2 * kWidth);
  const Points side_a = at_b - at_c, side_b = at_c - at_a, side_c = at_a - at_b;

  const Sides rest = load_sides(triangles.rest_length.block(pack));
  const Measured m = measure(rest, side_a, side_b, side_c);
  const Sides stretch = m.length - rest;
  const Sides bond = load_sides(triangles.bond_stiffness.block(pack)) * stretch;
  const Bent bent = compute_bend(triangles, pack, m);
  if constexpr (measured) measure_pack<law>(triangles, pack, rest, m, bent, stretch, sums);
  const Sides tension = compute_tensions<law>(triangles, pack, m, bent, stretch);
  const Sides scale = multiply_add(tension, m.pull, bond * m.direction);
  Pulls pull = {scale.a * side_a, scale.b * side_b, scale.c * side_c};
  if constexpr (damping != Damping::none) {
    add_damping<damping>(triangles, pack, velocity_rows, side_a, side_b, side_c, m, pull);
  }
  scatter_add(pull.b - pull.c, corner, force_rows);
  scatter_add(pull.c - pull.a, corner + kWidth, force_rows);
  scatter_add(pull.a - pull.b, corner + 2 * kWidth, force_rows);
}

template <AngleLaw law, Damping damping, bool measured>
void accumulate_packs(const PackedModel& model, PackedState& state, Sums& sums) {
  const auto here = static_cast<std::size_t>(state.current);
  for (const int pack : state.packs.span()) {
    const auto p = static_cast<std::size_t>(pack);
    const Real before = sums.elastic;
    if constexpr (measured) sums.elastic = hn::Zero(kLanes);
    accumulate_pack<law, damping, measured>(model.triangles, p, state.position_rows[here].data(),
                                            state.velocity_rows[here].data(),
                                            state.force_rows.data(), sums);
    if constexpr (measured) keep_energy(before, p, state.pack_energy, sums);
  }
}

template <AngleLaw law, Damping damping>
void accumulate_damped(const PackedModel& model, PackedState& state, PackedMeasure* measure) {
  Sums sums = begin_sums();
  if (measure == nullptr) {
    accumulate_packs<law, damping, false>(model, state, sums);
  } else {
    accumulate_packs<law, damping, true>(model, state, sums);
    add_sums(sums, *measure);
  }
}

template <AngleLaw law>
void accumulate_under(const PackedModel& model, PackedState& state, PackedMeasure* measure) {
  if (model.triangles.bond_damping.values.empty()) {
    accumulate_damped<law, Damping::none>(model, state, measure);
  } else if (model.damping_law == DampingLaw::axis) {
    accumulate_damped<law, Damping::axis>(model, state, measure);
  } else {
    accumulate_damped<law, Damping::isotropic>(model, state, measure);
  }
}

void accumulate_triangles(const PackedModel& model, PackedState& state, Internal&,
                          PackedMeasure* measure) noexcept {
  if (model.angle_law == AngleLaw::gradient) {
    accumulate_under<AngleLaw::gradient>(model, state, measure);
  } else {
    accumulate_under<AngleLaw::eq10>(model, state, measure);
  }
}

void accumulate_pressure(const PackedModel& model, PackedState& state) noexcept {
  const float* rows = state.position_rows[static_cast<std::size_t>(state.current)].data();
  const Real sixth = hn::Set(kLanes, model.pressure / 6.0f);
  for (const int pack : state.skin.span()) {
    const int* corner = model.skin.corner.data() + 3 * kWidth * static_cast<std::size_t>(pack);
    const Points a = gather(rows, corner);
    const Points push =
        sixth * cross(gather(rows, corner + kWidth) - a, gather(rows, corner + 2 * kWidth) - a);
    for (std::size_t c = 0; c < 3; ++c) {
      scatter_add(push, corner + c * kWidth, state.force_rows.data());
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate::packed_kernels
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET

#endif  // PALPATE_PACKED_TRIANGLES_INL_H
