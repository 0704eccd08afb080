// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/dynamics/energy.h"

namespace palpate {

enum class AlarmKind {
  none,
  not_finite,   ///< index: particle
  moved_far,    ///< index: particle; more than 0.3 of the shortest rest length in one step
  overstretched,///< index: link; strain above 2
  collapsed,    ///< index: link; shorter than 0.05 of its rest length
  energy,       ///< index: -1; total energy grows without work (SCIENCE 3)
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

/// The memory of the blow-up alarm between steps.
struct Guard {
  Guard() = default;
  Guard(const TissueModel& model, const Vec3& gravity, const State& state);

  Vec3Array last_position;
  double shortest_rest_length = 0.0;  ///< [m]
  double start_energy = 0.0;          ///< [J]
  double last_energy = 0.0;           ///< [J]
  double work = 0.0;                  ///< [J] done by loads since the start
  int rising_steps = 0;
};

/// Looks at a tissue after a step; the first thing wrong comes back. `work` [J] is what pushes
/// have done to the tissue in this step (gravity and pressure are energies and do not count).
Alarm check(const TissueModel& model, const Vec3& gravity, const State& state, double work,
            Guard& guard) noexcept;

}  // namespace palpate
