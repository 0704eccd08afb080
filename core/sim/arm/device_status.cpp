// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/arm/serial_device.h"

extern "C" {
#include "protocol/messages.h"
}

namespace palpate {
namespace {

/// What to do about a fault that cut the motors.
std::string find_remedy(int fault) {
  switch (fault) {
    case PALPATE_FAULT_STOP_PRESSED:
      return "release the emergency stop, then clear";
    case PALPATE_FAULT_DRIVER:
      return "check the motor drivers and their supply, then clear";
    case PALPATE_FAULT_SENSOR:
      return "check the sensors' wires, then clear";
    case PALPATE_FAULT_OVERHEATED:
      return "let the motors cool, then clear";
    case PALPATE_FAULT_CALIBRATION:
      return "calibrate the device";
    default:
      return "clear to go on";
  }
}

/// Why a device does not know what its counts mean.
std::string describe_memory(const DeviceStatus& status) {
  if (status.blank) {
    return "blank board: no calibration was ever stored in it, so its motors stay off; calibrate "
           "the device";
  }
  if (status.damaged) {
    return "the newest copy of its calibration in the EEPROM is damaged, so its motors stay off; "
           "calibrate the device";
  }
  return "not calibrated: its motors stay off";
}

}  // namespace

std::string name_fault(int fault) {
  return palpate_fault_name(static_cast<std::uint8_t>(fault < 0 || fault > 15 ? 15 : fault));
}

std::string describe_status(const DeviceStatus& status) {
  switch (status.link) {
    case LinkState::greeting:
      return "no answer yet";
    case LinkState::loading:
      return "reading its calibration";
    case LinkState::uncalibrated:
      return describe_memory(status);
    case LinkState::lost:
      return "lost: the cable is out, or the device is silent";
    case LinkState::ready:
      break;
  }
  if (status.mode == DeviceMode::faulted) {
    return "motors off: " + name_fault(status.first_fault) + "; " + find_remedy(status.first_fault);
  }
  if (status.degraded) return "reports are missing: the force is taken back";
  return palpate_mode_name(static_cast<std::uint8_t>(status.mode));
}

}  // namespace palpate
