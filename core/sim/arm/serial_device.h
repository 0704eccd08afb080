// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "palpate/sim/arm/calibration.h"
#include "palpate/sim/arm/transport.h"
#include "palpate/sim/base/types.h"
#include "palpate/sim/device/device.h"

namespace palpate {

/// How far a host has come with a device.
enum class LinkState {
  greeting,      ///< asks who is there
  loading,       ///< reads its calibration
  uncalibrated,  ///< hears its counts, and cannot know what they mean
  ready,         ///< knows where the hand is
  lost,          ///< gone for good: unplugged, silent or of another protocol
};

/// What a device does, by its own word.
enum class DeviceMode { boot, idle, ramp, run, faulted };

/// Everything there is to know of a device, as its driver left it for others some milliseconds ago.
struct DeviceStatus {
  LinkState link = LinkState::greeting;
  DeviceMode mode = DeviceMode::boot;
  bool blank = false;     ///< no calibration was ever stored in it
  bool damaged = false;   ///< the newest calibration in its EEPROM is not what was stored
  bool degraded = false;  ///< reports are missing: the force is taken back
  int first_fault = 15;   ///< bit that cut the motors, 15 for none: see name_fault
  int faults = 0;         ///< bits: whatever was noticed
  int buttons = 0;        ///< bits 0 and 1: pressed, by the last report

  double time = 0.0;                    ///< [s] of the last report, by the host's clock
  std::array<int, 6> counts{};          ///< of the sensors
  Vec3 joints = Vec3::Zero();           ///< [rad] yaw, elevation, forearm
  Vec3 gimbal = Vec3::Zero();           ///< [rad]
  Vec3 tip = Vec3::Zero();              ///< [m] in the arm's frame
  Vec3 force_commanded = Vec3::Zero();  ///< [N]
  Vec3 force_applied = Vec3::Zero();    ///< [N] by the duties the motors really got
  std::array<int, 3> duty{};            ///< -255 to 255
  std::array<int, 8> counters{};        ///< heat of three motors, then the device's own counts

  long reports = 0;                                      ///< from the device
  long lost_reports = 0;                                 ///< that its own count says are missing
  long damaged_frames = 0;                               ///< that failed their check, here
  long commands = 0;                                     ///< to the device
  double report_rate = 0.0;                              ///< [Hz] over the last second
  double round_trip_median = 0.0, round_trip_p99 = 0.0;  ///< [s] command to its acknowledgement
  std::array<long, 40> round_trips{};  ///< that took 0 to 0.25 ms, to 0.5 ms ...; last all longer
  double jitter_p99 = 0.0;             ///< [s] reports off the line through their times
  double clock_drift = 0.0;            ///< by how much the device's clock is fast, 1e-6 for 1 ppm
  double local_stiffness = 0.0;        ///< [N/m] along the force that it answers by itself

  std::array<int, 3> release{};  ///< of the firmware
  std::uint32_t serial_number = 0;
};
static_assert(alignof(DeviceStatus) == 8);

/// A fault's name in words, for instance "host silent"; "none" for no fault.
std::string name_fault(int fault);

/// One sentence: what the device does, or what is wrong and what to do.
std::string describe_status(const DeviceStatus& status);

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
  /// The motors' braking at the tip where it is now, along the direction in which that is least;
  /// the delay as it was measured last.
  DeviceDynamics dynamics() const noexcept override;
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
