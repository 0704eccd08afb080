// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "palpate/sim/device/device.h"

namespace palpate {

/// A shaft through a trocar: where its tip is when its handle is held, and the other way round.
struct Fulcrum {
  Vec3 trocar = Vec3::Zero();  ///< [m] where the shaft passes the abdominal wall
  double length = 0.0;         ///< [m] from the tip to the handle, positive
};

/// [m] The tip of a shaft whose handle is there [contact: trocar]; never nearer than 5 mm to the
/// trocar, on the side away from the handle.
Vec3 compute_fulcrum_tip(const Fulcrum& fulcrum, const Vec3& handle) noexcept;

/// [m] The handle of a shaft whose tip is there; likewise.
Vec3 compute_fulcrum_handle(const Fulcrum& fulcrum, const Vec3& tip) noexcept;

/// [N] On the handle of what pushes the tip by f [N], by virtual work. Across the shaft no more of
/// it is felt than leaves the handle as stiff as the tip is.
Vec3 carry_force(const Fulcrum& fulcrum, const Vec3& handle, const Vec3& f) noexcept;

/// Stands between a device that is the handle of an instrument and what wants to know of its tip.
class FulcrumDevice : public HapticDevice {
 public:
  /// `handle` must outlive this. Throws std::invalid_argument for a trocar that is not finite or a
  /// length that is not positive.
  FulcrumDevice(HapticDevice& handle, const Fulcrum& fulcrum);

  HapticSample read(double time) noexcept override;
  void write(const HapticCommand& command) noexcept override;
  void end() noexcept override { handle_.end(); }
  void rest(double seconds) noexcept override { handle_.rest(seconds); }
  std::string name() const override { return handle_.name(); }
  DeviceDynamics dynamics() const noexcept override { return handle_.dynamics(); }
  bool failed() const noexcept override { return handle_.failed(); }
  MotorState motors() const noexcept override { return handle_.motors(); }
  std::string explain_fault() const override { return handle_.explain_fault(); }
  double report_rate() const noexcept override { return handle_.report_rate(); }
  bool wait_for_report(std::int64_t latest) noexcept override {
    return handle_.wait_for_report(latest);
  }

 private:
  HapticDevice& handle_;
  Fulcrum fulcrum_;
  Vec3 at_;  // [m] of the handle, as read last
};

}  // namespace palpate
