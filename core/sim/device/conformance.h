// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "palpate/sim/device/device.h"

namespace palpate {

/// One thing a device owes, and whether it keeps it.
struct DeviceCheck {
  std::string name;  ///< what is owed, as a sentence
  bool passed = false;
  std::string detail;  ///< what was found
};

struct ConformanceOptions {
  double duration = 1.0;  ///< [s] of each part; a real hand should move the device meanwhile
  double rate = 1000.0;   ///< [Hz]
  double force = 0.3;     ///< [N] of the pushes
  bool live = false;      ///< wait for the clock between ticks, as a device in real time needs
};

/// What any HapticDevice has to keep, ours or another maker's, before a person holds it: samples
/// that are finite, go by the time asked for, move no faster than a hand and with a velocity that
/// fits; commands of every kind taken; a failure that stays one. The device is pushed gently.
/// `stopped`, where given, is asked before every tick: true ends the pushes and with them the
/// check, whose findings so far come back. Throws std::invalid_argument, also for more than a day.
std::vector<DeviceCheck> check_conformance(HapticDevice& device,
                                           const ConformanceOptions& options = {},
                                           const std::function<bool()>& stopped = {});

}  // namespace palpate
