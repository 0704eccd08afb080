// SPDX-License-Identifier: BSD-3-Clause
// Included once per vector target by packed_kernels.cpp: links, and the step of a slice.
#if defined(PALPATE_PACKED_ADVANCE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PALPATE_PACKED_ADVANCE_INL_H
#undef PALPATE_PACKED_ADVANCE_INL_H
#else
#define PALPATE_PACKED_ADVANCE_INL_H
#endif

#include "palpate/sim/dynamics/packed_vector-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace palpate::packed_kernels {
namespace HWY_NAMESPACE {

enum class Damping { none, axis, isotropic };

/// Adds the pull of all links of slice s on its particles at x, with velocities v. In the form
///
///     f += (k - k L / |d| + c (w·d) / |d|²) d,   d = x_j - x,  w = v_j - v
///
/// the law of accumulate_links (forces.cpp) needs one inverse root and no division. A link is
/// computed at both of its ends, with the same numbers but for the sign: momentum is kept.
template <Damping damping>
HWY_INLINE Points add_links(const PackedModel& model, const PackedState& state, std::size_t s,
                            const Points& x, const Points& v, Points f) {
  const PackedLinks& links = model.links;
  const auto here = static_cast<std::size_t>(state.current);
  const float* position_rows = state.position_rows[here].data();
  const float* velocity_rows = state.velocity_rows[here].data();
  const Real least = hn::Set(kLanes, links.least_square);
  const auto end = static_cast<std::size_t>(links.first_slot[s + 1]);
  for (auto slot = static_cast<std::size_t>(links.first_slot[s]); slot < end; ++slot) {
    const int* neighbour = links.neighbour.data() + kWidth * slot;
    const Points d = gather(position_rows, neighbour) - x;
    const Real inverse = invert_root(hn::Max(dot(d, d), least));
    Real scale = hn::NegMulAdd(load(links.rest_tension.block(slot)), inverse,
                               load(links.stiffness.block(slot)));
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

/// One step of one slice: v += dt (f/m + g - drag v), u += dt v with the new v.
template <Damping damping>
HWY_INLINE void advance_slice(const PackedModel& model, const Points& gravity, float dt,
                              std::size_t s, PackedState& state) {
  const Points rest = load_points(model.rest.data() + 3 * kWidth * s);
  float* displacement = state.displacement.data() + 3 * kWidth * s;
  float* velocity = state.velocity.data() + 3 * kWidth * s;
  const Points u = load_points(displacement), v = load_points(velocity);
  const Points x = rest + u;

  Points f = hn::Neg(load(model.home.data() + kWidth * s)) * u;
  f = add_links<damping>(model, state, s, x, v, f);
  if (state.pushed[s] != 0) {
    float* rows = state.force_rows.data() + 4 * kWidth * s;
    f = f + gather(rows, model.lanes.data());
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

  store_points(v_new, velocity);
  store_points(u_new, displacement);
  const auto there = static_cast<std::size_t>(1 - state.current);
  scatter(rest + u_new, model.lanes.data(), state.position_rows[there].data() + 4 * kWidth * s);
  if constexpr (damping != Damping::none) {
    scatter(v_new, model.lanes.data(), state.velocity_rows[there].data() + 4 * kWidth * s);
  }
}

template <Damping damping>
void advance_all(const PackedModel& model, const Eigen::Vector3f& gravity, float dt,
                 PackedState& state) {
  const Points g = {hn::Set(kLanes, gravity.x()), hn::Set(kLanes, gravity.y()),
                    hn::Set(kLanes, gravity.z())};
  for (std::size_t s = 0; s < static_cast<std::size_t>(model.slice_count); ++s) {
    advance_slice<damping>(model, g, dt, s, state);
  }
}

void advance(const PackedModel& model, const Eigen::Vector3f& gravity, float dt,
             PackedState& state) noexcept {
  if (state.velocity_rows[0].empty()) {
    advance_all<Damping::none>(model, gravity, dt, state);
  } else if (model.damping_law == DampingLaw::axis) {
    advance_all<Damping::axis>(model, gravity, dt, state);
  } else {
    advance_all<Damping::isotropic>(model, gravity, dt, state);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace palpate::packed_kernels
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET

#endif  // PALPATE_PACKED_ADVANCE_INL_H
