// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/state.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// The most and the least that a link or a side of a triangle is of its rest length, and volumes of
/// theirs; 1 at rest.
struct Stretch {
  double longest = 1.0;          ///< [-] at least 1
  double shortest = 1.0;         ///< [-] at most 1
  double smallest_volume = 1.0;  ///< [-] of a tetrahedron; at most 1, below 0 inside out
  double smallest_mean = 1.0;    ///< [-] of the tetrahedra around a particle; at most 1
  double largest_face = 1.0;     ///< [-] of an area in a tetrahedron at finite strain; at least 1
  double stiffening = 0.0;       ///< [-] of its shear, in parts of mu, beyond that at rest
};

/// How stiff M⁻¹K of a tissue may get, from which of its terms; all in 1/s².
struct StretchSpectrum {
  StretchSpectrum() = default;
  /// `rest` is the largest eigenvalue at rest (estimate_spectrum).
  StretchSpectrum(const TissueModel& model, double rest);

  double rest = 0.0;
  double taut = 0.0;      ///< with links as stiff across as along: a bound
  double angles = 0.0;    ///< of angles, stretch-bend and prisms alone
  double pressure = 0.0;  ///< of pressure alone: a bound
  double volumes = 0.0;   ///< of each tetrahedron's volume alone
  double means = 0.0;     ///< of mean volumes alone
  double shear = 0.0;     ///< of mu at finite strain alone: a bound
  double faces = 0.0;     ///< of what goes with areas at finite strain alone: a bound
};

enum class AlarmKind {
  none,
  not_finite,     ///< index: particle
  moved_far,      ///< index: particle; more than 0.3 of the shortest rest length in one step
  overstretched,  ///< index: link, springs before bonds; strain above 2, ten checks in a row
  collapsed,      ///< index: link; shorter than 0.05 of its rest length, ten checks in a row
  energy,         ///< index: -1; elastic and kinetic energy exceed what was given
  inverted,       ///< index: tetrahedron; volume below 0.05 of that at rest, ten checks in a row
  pressed_deep,   ///< index: vertex of the surface; a linear solid moved beyond kShallow [m],
                  ///< likewise
  invalid_input,  ///< index: TickInput (tick/private/check_input.h); a tick cannot use what it was
                  ///< given
  not_solved,     ///< index: -1; an implicit step, of value [s], found no solution
};

/// What is wrong with a running tissue, as a value: the haptic thread never throws.
struct Alarm {
  AlarmKind kind = AlarmKind::none;
  int index = -1;
  double value = 0.0;  ///< what was measured
  double limit = 0.0;  ///< what it may be
  double time = 0.0;   ///< [s]
  explicit operator bool() const noexcept { return kind != AlarmKind::none; }
};

/// The memory of the blow-up alarm between checks.
struct Guard {
  Guard() = default;
  Guard(const TissueModel& model, const Vec3& gravity, const State& state);

  Vec3Array last_position;            ///< [m] at the last check that found nothing wrong
  double last_time = 0.0;             ///< [s] of the last check
  double shortest_rest_length = 0.0;  ///< [m]
  double start_energy = 0.0;          ///< [J] elastic and kinetic
  double last_energy = 0.0;           ///< [J] elastic and kinetic
  double work = 0.0;                  ///< [J] done by pushes, gravity and pressure since the start
  double given_energy = 0.0;          ///< [J] of start and work, less what has long been lost
  double unnoticed_energy = 0.0;      ///< [J] less than can be seen or felt
  double reference_energy = 0.0;      ///< [J] E_ref: the most that has lately been given
  int rising_steps = 0;               ///< checks in a row at which energy rose without work
  int strained_checks = 0;            ///< in a row at which a link or volume was out of bounds
  double torn_energy = 0.0;  ///< [J] of what has torn: the model has it, and the tissue has not
  /// 1 of each link that has torn and may have any length, springs before bonds; may be empty
  std::vector<unsigned char> torn_links;
};

/// Checks a tissue after a step; the first thing wrong comes back. `work` [J] is what pushes
/// have done to the tissue since the last check; what gravity and pressure have done is found here.
/// `steps` taken since then may have moved a particle that many times as far.
Alarm check(const TissueModel& model, const Vec3& gravity, const State& state, double work,
            Guard& guard, int steps = 1) noexcept;

}  // namespace palpate
