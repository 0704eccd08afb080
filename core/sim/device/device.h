// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include "palpate/sim/base/types.h"

namespace palpate {

/// What a device says of the hand: six degrees of freedom in.
struct HapticSample {
  double time = 0.0;                                ///< [s] since the run began
  Vec3 position = Vec3::Zero();                     ///< [m]
  Quaternion orientation = Quaternion::Identity();  ///< unit
  Vec3 velocity = Vec3::Zero();                     ///< [m/s]
  std::uint8_t buttons = 0;  ///< bit 0: attach while held; of a tool with jaws, close them
  double grip = 0.0;         ///< [rad] by which a grip axis has closed each jaw, 0: open
};
static_assert(sizeof(HapticSample) == 104 && alignof(HapticSample) == 8);

inline constexpr std::uint8_t kAttachButton = 1;

/// What the device shall make the hand feel: three degrees of freedom out.
struct HapticCommand {
  Vec3 force = Vec3::Zero();  ///< [N]
};
static_assert(sizeof(HapticCommand) == 24 && alignof(HapticCommand) == 8);

/// Whether a device makes the hand feel the force that it is sent.
enum class MotorState {
  on,      ///< or coming on
  silent,  ///< it has not been heard for some ticks: the force is taken back until it is
  off,     ///< not on yet, or switched off on purpose
  cut,     ///< they were on: it took them off, was reset, fell silent or is gone
};

/// What a device declares of itself, from which follows how stiff what is felt through it may be.
struct DeviceDynamics {
  double damping = 0.0;  ///< [N·s/m] the least that the hand always feels of it; 0: none declared
  double delay = 0.0;    ///< [s] from a hand to the force that answers it, holding not included
  /// No force moves its hand: a script, a record, a mouse. What holding a force gives such a hand
  /// drives nothing.
  bool position_source = false;
};
static_assert(sizeof(DeviceDynamics) == 24 && alignof(DeviceDynamics) == 8);

/// [N/m] Up to which a spring that is told every `period` [s] calms the hand, b / (T/2 + d)
/// [Colgate97]; 0 where no damping is declared.
inline double find_passive_stiffness(const DeviceDynamics& dynamics, double period) noexcept {
  return dynamics.damping > 0.0 ? dynamics.damping / (0.5 * period + dynamics.delay) : 0.0;
}

/// Times as stiff as a tissue the hand's spring must be for nine tenths of its stiffness to be
/// felt: k K / (k + K) of the two in a row.
inline constexpr double kCouplingShare = 9.0;

/// [N/m] The hand's spring before tissue of stiffness `tissue` [N/m], of an instrument whose own
/// coupling is `coupling` [N/m], with a device that keeps `passive` [N/m] passive: never softer
/// than that, as stiff as lets nine tenths of the tissue be felt, and no stiffer than leaves what
/// is felt, k K / (k + K), passive [stability: weak coupling].
inline double fit_coupling(double coupling, double passive, double tissue) noexcept {
  double fit = std::max(passive, kCouplingShare * tissue);
  if (tissue > passive) fit = std::min(fit, passive * tissue / (tissue - passive));
  return std::min(coupling, fit);
}

/// A haptic device, real or simulated: the one thing chosen at run time.
/// read and write are called from the haptic thread: no exception, allocation, lock or log.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  /// The hand at `time` [s] since the run began; devices with a clock of their own may ignore it.
  virtual HapticSample read(double time) noexcept = 0;
  virtual void write(const HapticCommand& command) noexcept = 0;
  /// A run is over and nothing will be written for a while: a device with motors takes them off
  /// now, for it would take the silence that follows for a fault. The next write begins again.
  virtual void end() noexcept {}
  /// The run is paused and its time stands still: no force, and `seconds` of the world's time have
  /// passed since the last call of any of these. A device may take silence for a fault.
  virtual void rest(double seconds) noexcept {
    (void)seconds;
    write({});
  }
  virtual std::string name() const = 0;
  /// Asked for at the start of a run, not while it is on.
  virtual DeviceDynamics dynamics() const noexcept { return {}; }
  /// True once the device is gone for good: what it says and is told no longer counts. From the
  /// haptic thread too.
  virtual bool failed() const noexcept { return false; }
  /// Whether the hand feels what is written now. From the haptic thread; a device that has no
  /// motors to lose leaves it at this.
  virtual MotorState motors() const noexcept { return MotorState::on; }
  /// Why the motors are cut, or the device has failed, and what to do; empty where it cannot tell.
  /// From any thread.
  virtual std::string explain_fault() const { return {}; }
  /// [Hz] of the reports that can be waited for, 0 where the device has no clock of its own. Where
  /// it is that of the ticks, the live loop ticks when a report has come.
  virtual double report_rate() const noexcept { return 0.0; }
  /// Waits for a report that read has not seen, until `latest` [ns of the monotonic clock] at most.
  /// False if none came.
  virtual bool wait_for_report(std::int64_t latest) noexcept {
    (void)latest;
    return false;
  }
};

}  // namespace palpate
