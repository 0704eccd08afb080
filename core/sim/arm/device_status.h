// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "palpate/sim/base/types.h"

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

}  // namespace palpate
