// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/arm/private/calibration_bytes.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/refuse.h"

extern "C" {
#include "board/host.h"
#include "protocol/calibration.h"
}

namespace palpate {
namespace {

constexpr double kHeatUnits = 1048.576;  ///< [s] the time constant of a heat rate of 1

std::int32_t to_micro(double value) { return static_cast<std::int32_t>(std::lround(1e6 * value)); }

palpate_calibration to_wire(const Calibration& from) {
  validate(from);
  palpate_calibration to{};
  to.speed_max = static_cast<std::uint8_t>(from.speed_max);
  for (std::size_t j = 0; j < 6; ++j) {
    const JointSensor& joint = from.joints[j];
    to.joint[j] = {.zero = static_cast<std::uint16_t>(joint.zero),
                   .scale_nrad = static_cast<std::int32_t>(std::lround(1e9 * joint.scale)),
                   .min = static_cast<std::uint16_t>(joint.min),
                   .max = static_cast<std::uint16_t>(joint.max)};
  }
  to.link_um[0] = static_cast<std::uint32_t>(to_micro(from.upper_length));
  to.link_um[1] = static_cast<std::uint32_t>(to_micro(from.forearm_length));
  for (std::size_t m = 0; m < 3; ++m) {
    to.torque_uNm[m] = to_micro(from.torque_full[static_cast<int>(m)]);
    to.deadband[m] = static_cast<std::uint8_t>(from.deadband[m]);
    to.continuous_duty[m] = static_cast<std::uint8_t>(from.continuous_duty[m]);
  }
  to.gravity_uNm[0] = to_micro(from.upper_weight);
  to.gravity_uNm[1] = to_micro(from.forearm_weight);
  to.heat_rate =
      static_cast<std::uint16_t>(std::clamp(std::lround(kHeatUnits / from.heat_time), 1L, 32767L));
  to.serial_number = from.serial_number;
  return to;
}

Calibration from_wire(const palpate_calibration& from) {
  Calibration to;
  to.speed_max = from.speed_max;
  for (std::size_t j = 0; j < 6; ++j) {
    const palpate_joint_calibration& joint = from.joint[j];
    to.joints[j] = {joint.zero, 1e-9 * joint.scale_nrad, joint.min, joint.max};
  }
  to.upper_length = 1e-6 * from.link_um[0];
  to.forearm_length = 1e-6 * from.link_um[1];
  for (std::size_t m = 0; m < 3; ++m) {
    to.torque_full[static_cast<int>(m)] = 1e-6 * from.torque_uNm[m];
    to.deadband[m] = from.deadband[m];
    to.continuous_duty[m] = from.continuous_duty[m];
  }
  to.upper_weight = 1e-6 * from.gravity_uNm[0];
  to.forearm_weight = 1e-6 * from.gravity_uNm[1];
  to.heat_time = kHeatUnits / from.heat_rate;
  to.serial_number = from.serial_number;
  return to;
}

}  // namespace

std::vector<std::uint8_t> write_calibration(const Calibration& calibration) {
  const palpate_calibration wire = to_wire(calibration);
  std::vector<std::uint8_t> bytes(PALPATE_CALIBRATION_BYTES);
  palpate_write_calibration(&wire, bytes.data());
  return bytes;
}

std::optional<Calibration> read_calibration(std::span<const std::uint8_t> bytes) {
  palpate_calibration wire;
  if (bytes.size() != PALPATE_CALIBRATION_BYTES) return std::nullopt;
  if (!palpate_read_calibration(bytes.data(), &wire)) return std::nullopt;
  return from_wire(wire);
}

void write_eeprom(const Calibration& calibration, std::span<std::uint8_t> eeprom) {
  if (eeprom.size() != PALPATE_EEPROM_BYTES) {
    refuse("eeprom", write_text(eeprom.size(), " bytes"), "1024");
  }
  const palpate_calibration wire = to_wire(calibration);
  palpate_write_eeprom(&wire, eeprom.data());
}

}  // namespace palpate
