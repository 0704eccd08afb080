// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by packed_kernels.cpp: links, and the step of a slice.
#if defined(PALPATE_PACKED_ADVANCE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_PACKED_ADVANCE_INL_H
#undef PALPATE_PACKED_ADVANCE_INL_H
#else
#define PALPATE_PACKED_ADVANCE_INL_H
#endif

#include <cmath>
#include <limits>

#include "palpate/sim/packed/private/packed_kernels.h"
#include "palpate/sim/packed/private/packed_vector-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace palpate::packed_kernels {
namespace HWY_NAMESPACE {

enum class Damping { none, axis, isotropic };

/// What is measured on the way, lane by lane: energies, and lengths and volumes in parts of those
/// at rest; the longest displacement squared, work of gravity, and 0, or NaN once a particle is
/// nowhere.
struct Sums {
  Real kinetic, elastic, longest, shortest, smallest_volume, smallest_mean;
  Real move, fallen, nowhere;
  Real least_rest, most_rest;  ///< parts that lengths at rest are of lengths
};

HWY_INLINE Sums begin_sums() {
  const Real zero = hn::Zero(kLanes), one = hn::Set(kLanes, 1.0f);
  return {zero, zero, one, one, one, one, zero, zero, zero, one, one};
}

HWY_INLINE void add_sums(const Sums& sums, PackedMeasure& measure) {
  measure.kinetic += hn::GetLane(hn::SumOfLanes(kLanes, sums.kinetic));
  measure.elastic += hn::GetLane(hn::SumOfLanes(kLanes, sums.elastic));
  const double longest = hn::GetLane(hn::MaxOfLanes(kLanes, sums.longest));
  const double shortest = hn::GetLane(hn::MinOfLanes(kLanes, sums.shortest));
  const double least_rest = hn::GetLane(hn::MinOfLanes(kLanes, sums.least_rest));
  const double most_rest = hn::GetLane(hn::MaxOfLanes(kLanes, sums.most_rest));
  measure.stretch.longest = std::max({measure.stretch.longest, longest, 1.0 / least_rest});
  measure.stretch.shortest = std::min({measure.stretch.shortest, shortest, 1.0 / most_rest});
  const double volume = hn::GetLane(hn::MinOfLanes(kLanes, sums.smallest_volume));
  const double mean = hn::GetLane(hn::MinOfLanes(kLanes, sums.smallest_mean));
  measure.stretch.smallest_volume = std::min(measure.stretch.smallest_volume, volume);
  measure.stretch.smallest_mean = std::min(measure.stretch.smallest_mean, mean);
  const bool somewhere = hn::GetLane(hn::SumOfLanes(kLanes, sums.nowhere)) == 0.0f;
  const double move = std::sqrt(double(hn::GetLane(hn::MaxOfLanes(kLanes, sums.move))));
  measure.largest_move =
      std::max(measure.largest_move, somewhere ? move : std::numeric_limits<double>::infinity());
  measure.gravity_work += hn::GetLane(hn::SumOfLanes(kLanes, sums.fallen));
}

/// Notes what `sums` has of one slice or pack, where that is wanted, and adds what was before.
HWY_INLINE void keep_energy(const Real before, std::size_t index, CacheAligned<float>& energies,
                            Sums& sums) {
  if (!energies.empty()) energies[index] = hn::GetLane(hn::SumOfLanes(kLanes, sums.elastic));
  sums.elastic = hn::Add(before, sums.elastic);
}

using Indices = hn::Rebind<int, Lanes>;

/// Lanes whose two numbers differ.
HWY_INLINE hn::Mask<Lanes> differ(const int* a, const int* b) {
  const Indices d;
  return hn::RebindMask(kLanes, hn::Ne(hn::Load(d, a), hn::Load(d, b)));
}

/// Notes how much `length` is of a rest length, where a lane has one.
HWY_INLINE void measure_part(const hn::Mask<Lanes> has_rest, const Real length,
                             const Real inverse_rest, Sums& sums) {
  const Real part = hn::IfThenElse(has_rest, hn::Mul(length, inverse_rest), hn::Set(kLanes, 1.0f));
  sums.longest = hn::Max(part, sums.longest);
  sums.shortest = hn::Min(part, sums.shortest);
}

/// Half of k (l - L)² / 2 for each link of a slot: its other end adds the other half.
HWY_INLINE void measure_slot(const PackedLinks& links, std::size_t slot, const int* self,
                             const Real square, const Real inverse, Sums& sums) {
  const auto is_link = differ(links.neighbour.data() + kWidth * slot, self);
  const Real k = load(links.stiffness.block(slot)),
             rest_tension = load(links.rest_tension.block(slot));
  const Real length = hn::Mul(square, inverse);
  const Real rest =
      hn::IfThenElseZero(hn::Ne(k, hn::Zero(kLanes)), hn::Mul(rest_tension, invert(k)));
  const Real tension = hn::MulSub(k, length, rest_tension);
  const Real energy = hn::Mul(hn::Mul(tension, hn::Sub(length, rest)), hn::Set(kLanes, 0.25f));
  sums.elastic = hn::Add(sums.elastic, hn::IfThenElseZero(is_link, energy));
  const auto weighs = hn::And(is_link, hn::Gt(rest, hn::Zero(kLanes)));
  measure_part(weighs, length, hn::Mul(k, invert(rest_tension)), sums);
}

/// The same energy where every lane has a link with a stiffness and a length. With the pull
/// p = k - k L / l it is (l p)² / (2 k), and L/l is what p was made of: no division is left.
HWY_INLINE void measure_plain(const Real k, const Real rest_tension, const Real square,
                              const Real inverse, const Real compliance, Sums& sums) {
  const Real rest_part = hn::Mul(hn::Mul(rest_tension, inverse), compliance);
  const Real pull = hn::NegMulAdd(rest_tension, inverse, k);
  const Real quarter = hn::Mul(compliance, hn::Set(kLanes, 0.25f));
  sums.elastic = hn::MulAdd(hn::Mul(hn::Mul(pull, pull), quarter), square, sums.elastic);
  sums.least_rest = hn::Min(rest_part, sums.least_rest);
  sums.most_rest = hn::Max(rest_part, sums.most_rest);
}

/// Adds the pull of all links of slice s on its particles at x, with velocities v. In the form
///
///     f += (k - k L / |d| + c (w·d) / |d|²) d,   d = x_j - x,  w = v_j - v
///
/// the law of accumulate_links (forces.cpp) needs one inverse root and no division. A link is
/// computed at both of its ends, with the same numbers but for the sign: momentum is kept.
template <Damping damping, bool measured>
HWY_INLINE Points add_links(const PackedModel& model, const PackedState& state, std::size_t s,
                            const Points& x, const Points& v, Points f, Sums& sums) {
  const PackedLinks& links = model.links;
  const auto here = static_cast<std::size_t>(state.current);
  const float* position_rows = state.position_rows[here].data();
  const float* velocity_rows = state.velocity_rows[here].data();
  const Real least = hn::Set(kLanes, links.least_square);
  const auto end = static_cast<std::size_t>(links.first_slot[s + 1]);
  const auto plain_end = static_cast<std::size_t>(links.plain_end[s]);
  const bool alike = links.stiffness.stride == 0;
  Real compliance = invert(load(links.stiffness.block(0)));
  for (auto slot = static_cast<std::size_t>(links.first_slot[s]); slot < end; ++slot) {
    const int* neighbour = links.neighbour.data() + kWidth * slot;
    const Points d = gather(position_rows, neighbour) - x;
    const Real square = hn::Max(dot(d, d), least);
    const Real inverse = invert_root(square);
    const Real k = load(links.stiffness.block(slot));
    const Real rest_tension = load(links.rest_tension.block(slot));
    if (measured && slot < plain_end) {
      if (!alike) compliance = invert(k);
      measure_plain(k, rest_tension, square, inverse, compliance, sums);
    } else if constexpr (measured) {
      measure_slot(links, slot, model.self.data() + kWidth * s, square, inverse, sums);
    }
    Real scale = hn::NegMulAdd(rest_tension, inverse, k);
    if constexpr (damping != Damping::none) {
      const Points w = gather(velocity_rows, neighbour) - v;
      const Real c = load(links.damping.block(slot));
      if constexpr (damping == Damping::isotropic) f = add_scaled(c, w, f);
      if constexpr (damping == Damping::axis) {
        scale = hn::MulAdd(hn::Mul(c, dot(w, d)), hn::Mul(inverse, inverse), scale);
      }
    }
    f = add_scaled(scale, d, f);
  }
  return f;
}

/// Kinetic energy with the velocity half way through the kick, m |v + v'|² / 8, and that of home.
HWY_INLINE void measure_slice(const PackedModel& model, std::size_t s, const Points& u,
                              const Points& v, const Points& v_new, Sums& sums) {
  const Points twice = v + v_new;
  const Real mass = hn::Mul(load(model.mass.data() + kWidth * s), hn::Set(kLanes, 0.125f));
  const Real home = hn::Mul(load(model.home.data() + kWidth * s), hn::Set(kLanes, 0.5f));
  sums.kinetic = hn::MulAdd(mass, dot(twice, twice), sums.kinetic);
  sums.elastic = hn::MulAdd(home, dot(u, u), sums.elastic);
}

/// How far the particles of a slice have gone since the last check, and how far fallen.
HWY_INLINE void measure_moves(const PackedModel& model, std::size_t s, const Points& gravity,
                              const Points& move, const Points& v, Sums& sums) {
  const Real square = dot(move, move);
  sums.move = hn::Max(square, sums.move);
  sums.nowhere = hn::MulAdd(hn::Zero(kLanes), hn::Add(square, dot(v, v)), sums.nowhere);
  sums.fallen = hn::MulAdd(load(model.mass.data() + kWidth * s), dot(gravity, move), sums.fallen);
}

/// One step of one slice: v += dt (f/m + g - drag v), u += dt v with the new v.
template <Damping damping, bool measured>
HWY_INLINE void advance_slice(const PackedModel& model, const Points& gravity, float dt,
                              std::size_t s, PackedState& state, Sums& sums) {
  const Points rest = load_points(model.rest.data() + 3 * kWidth * s);
  float* displacement = state.displacement.data() + 3 * kWidth * s;
  float* velocity = state.velocity.data() + 3 * kWidth * s;
  const Points u = load_points(displacement), v = load_points(velocity);
  const Points x = rest + u;

  Points f = hn::Neg(load(model.home.data() + kWidth * s)) * u;
  f = add_links<damping, measured>(model, state, s, x, v, f, sums);
  if (state.pushed[s] != 0) {
    float* rows = state.force_rows.data() + 4 * kWidth * s;
    f = f + gather(rows, model.self.data());
    for (std::size_t i = 0; i < 4 * kWidth; i += kWidth) {
      hn::Store(hn::Zero(kLanes), kLanes, rows + i);
    }
  }

  const Real inverse_mass = load(model.inverse_mass.data() + kWidth * s);
  const Real step = hn::Set(kLanes, dt), kept = hn::Set(kLanes, 1.0f - dt * model.drag);
  const auto free = hn::Gt(inverse_mass, hn::Zero(kLanes));
  const Points fall = {hn::IfThenElseZero(free, gravity.x), hn::IfThenElseZero(free, gravity.y),
                       hn::IfThenElseZero(free, gravity.z)};
  const Points kick = add_scaled(inverse_mass, f, fall);
  const Points v_new = add_scaled(step, kick, kept * v);
  const Points u_new = add_scaled(step, v_new, u);

  float* last = state.last_displacement.data() + 3 * kWidth * s;
  if (state.checked) store_points(u, last);
  if constexpr (measured) {
    measure_slice(model, s, u, v, v_new, sums);
    measure_moves(model, s, gravity, u_new - load_points(last), v_new, sums);
  }
  store_points(v_new, velocity);
  store_points(u_new, displacement);
  const auto there = static_cast<std::size_t>(1 - state.current);
  scatter(rest + u_new, model.self.data(), state.position_rows[there].data() + 4 * kWidth * s);
  if constexpr (damping != Damping::none) {
    scatter(v_new, model.self.data(), state.velocity_rows[there].data() + 4 * kWidth * s);
  }
}

template <Damping damping, bool measured>
void advance_all(const PackedModel& model, const Eigen::Vector3f& gravity, float dt,
                 PackedState& state, Sums& sums) {
  const Points g = {hn::Set(kLanes, gravity.x()), hn::Set(kLanes, gravity.y()),
                    hn::Set(kLanes, gravity.z())};
  for (const int slice : state.slices.span()) {
    const auto s = static_cast<std::size_t>(slice);
    if constexpr (measured) {
      const Real before = sums.elastic;
      sums.elastic = hn::Zero(kLanes);
      advance_slice<damping, measured>(model, g, dt, s, state, sums);
      keep_energy(before, s, state.slice_energy, sums);
    } else {
      advance_slice<damping, measured>(model, g, dt, s, state, sums);
    }
  }
}

template <Damping damping>
void advance_under(const PackedModel& model, const Eigen::Vector3f& gravity, float dt,
                   PackedState& state, PackedMeasure* measure) {
  Sums sums = begin_sums();
  if (measure == nullptr) {
    advance_all<damping, false>(model, gravity, dt, state, sums);
  } else {
    advance_all<damping, true>(model, gravity, dt, state, sums);
    add_sums(sums, *measure);
  }
}

void advance(const PackedModel& model, const Eigen::Vector3f& gravity, float dt, PackedState& state,
             PackedMeasure* measure) noexcept {
  if (state.velocity_rows[0].empty()) {
    advance_under<Damping::none>(model, gravity, dt, state, measure);
  } else if (model.damping_law == DampingLaw::axis) {
    advance_under<Damping::axis>(model, gravity, dt, state, measure);
  } else {
    advance_under<Damping::isotropic>(model, gravity, dt, state, measure);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate::packed_kernels
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET

#endif  // PALPATE_PACKED_ADVANCE_INL_H
