// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/tick/world.h"

namespace palpate {

/// Whether the device of an instrument bears less of a spring than the instrument's own coupling.
inline bool limits_coupling(const Instrument& instrument, const InstrumentState& state) noexcept {
  const double passive = state.device.passive_stiffness;
  return passive > 0.0 && passive < instrument.coupling.stiffness;
}

/// What draws the tool to the hand in this tick.
inline Coupling find_coupling(const Instrument& instrument, const InstrumentState& state) noexcept {
  Coupling coupling = instrument.coupling;
  if (limits_coupling(instrument, state)) coupling.stiffness = state.device.stiffness;
  return coupling;
}

/// Begins a tick of `dt` [s] in which the hand has gone by `travel` [m]: its spring goes towards
/// what fit_coupling says of the tissue that was learnt. Nothing where the device bears the
/// instrument's own.
void choose_coupling(const Instrument& instrument, double travel, double dt,
                     InstrumentState& state) noexcept;

/// Whether the spring follows the tissue that was learnt.
void follow_tissue_stiffness(DeviceCoupling& device) noexcept;

/// Ends a tick: learns how the force of the contact grows as the tool goes against it.
void learn_tissue(const Instrument& instrument, InstrumentState& state) noexcept;

/// [-] The part of the tissue's stiffness that the hand does not feel: K / (k + K); 0 where nothing
/// is touched, or the device bears the instrument's own coupling.
inline double find_stiffness_error(const DeviceCoupling& device) noexcept {
  return device.tissue > 0.0 ? device.tissue / (device.stiffness + device.tissue) : 0.0;
}

/// Before a tick of dt [s]: a hand whose instrument, or a rigid body that it pushes, strains tissue
/// nearly as far as would end the run pushes no harder, and with less until that is no more so
/// [stability: what tissue bears]. Writes HandMotion::bearable.
void limit_hand(const Scene& scene, std::size_t instrument, double dt, World& world) noexcept;

/// The spring of an instrument to its hand in this tick, with what its tissue bears.
Coupling find_limited_coupling(const Scene& scene, std::size_t instrument, World& world) noexcept;

}  // namespace palpate
