// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "palpate/sim/arm/calibration.h"
#include "palpate/sim/arm/device_status.h"
#include "palpate/sim/arm/transport.h"
#include "palpate/sim/device/device.h"

namespace palpate {

/// The driver of the low-cost device, at the other end of whatever transport.
///
/// Of the reports that have come only the newest counts. A tick sends one command at most, and none
/// is made up for, so there is never a burst. Up to three missing reports are bridged, the hand
/// going on as it went and the force fading; then the force is zero until reports come again.
/// Nothing is sent twice.
///
/// What is too stiff for the path to the host and back the device answers by itself between two
/// commands (firmware/README.md, "The local law").
class SerialDevice : public HapticDevice {
 public:
  /// The workspace's centre shall lie at `origin` [m] of the scene. `transport` must outlive this.
  explicit SerialDevice(Transport& transport, const Vec3& origin = Vec3::Zero());
  ~SerialDevice() override;  ///< switches the motors off

  /// Greets the device, reads its calibration and waits for its first report; to be called before
  /// a run. Throws DeviceError in words where that does not come about within `timeout` [s].
  /// `stopped`, where given, is asked meanwhile: true ends the wait as its end would.
  void open(double timeout = 3.0, const std::function<bool()>& stopped = {});

  HapticSample read(double time) noexcept override;
  void write(const HapticCommand& command) noexcept override;
  void end() noexcept override;
  std::string name() const override;
  void rest(double seconds) noexcept override;
  bool failed() const noexcept override;
  MotorState motors() const noexcept override;
  std::string explain_fault() const override;
  /// 0 where the machine does not tell of bytes that come, or no reports do.
  double report_rate() const noexcept override;
  bool wait_for_report(std::int64_t latest) noexcept override;

  /// From any thread: asks the device to forget its fault, if the cause is gone.
  void clear_fault() noexcept;
  /// From any thread: motors on (as they are from the start) or off.
  void enable(bool on) noexcept;
  /// For one reader thread: true if something newer than last time was taken.
  bool take_status() noexcept;
  const DeviceStatus& status() const noexcept;

  /// As it was read when the link was made. Throws DeviceError where there is none.
  Calibration calibration() const;
  /// Writes a calibration to the device, which keeps it; then the device is greeted again. Not
  /// while a run is on. Throws DeviceError in words, and std::invalid_argument for numbers it
  /// cannot hold.
  void store(const Calibration& calibration, double timeout = 5.0,
             const std::function<bool()>& stopped = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace palpate
