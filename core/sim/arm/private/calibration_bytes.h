// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "palpate/sim/arm/calibration.h"

namespace palpate {

/// A calibration as the device's pages have it. Throws std::invalid_argument.
std::vector<std::uint8_t> write_calibration(const Calibration& calibration);

/// None where the bytes hold a number that is out of range, or are of another version.
std::optional<Calibration> read_calibration(std::span<const std::uint8_t> bytes);

/// Into an image of the device's EEPROM of 1024 bytes. Throws std::invalid_argument.
void write_eeprom(const Calibration& calibration, std::span<std::uint8_t> eeprom);

}  // namespace palpate
