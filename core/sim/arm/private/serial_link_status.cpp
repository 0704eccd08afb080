// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "palpate/sim/arm/private/serial_link.h"

namespace palpate {

void SerialLink::fill(DeviceStatus& status) const noexcept {
  status.link = state_;
  status.blank = has_info_ && (info_.features & PALPATE_FEATURE_BLANK) != 0;
  status.damaged = has_info_ && (info_.features & PALPATE_FEATURE_DAMAGED) != 0;
  status.mode = static_cast<DeviceMode>(std::min<int>(report_.mode, 4));
  status.first_fault = report_.first_fault;
  status.faults = report_.faults;
  status.time = last_heard_;
  std::copy(counts_.begin(), counts_.end(), status.counts.begin());
  for (std::size_t m = 0; m < 3; ++m) status.duty[m] = report_.duty[m];
  status.counters = counters_;
  status.reports = reports_;
  status.lost_reports = lost_;
  status.damaged_frames = damaged_;
  status.commands = commands_;
  status.report_rate = rate_;
  status.round_trip_median = 1e-9 * round_trips_.percentile(0.5);
  status.round_trip_p99 = 1e-9 * round_trips_.percentile(0.99);
  status.round_trips = round_trip_counts_;
  status.jitter_p99 = 1e-9 * jitters_.percentile(0.99);
  status.clock_drift = clock_.drift();
  std::copy(std::begin(info_.release), std::end(info_.release), status.release.begin());
  status.serial_number = info_.serial_number;
}

std::string SerialLink::explain_silence() const {
  if (!transport_.is_open()) return "the cable is out";
  if (wrong_version_) {
    return "speaks version " + std::to_string(info_.version) + " of the protocol, expected " +
           std::to_string(PALPATE_PROTOCOL_VERSION);
  }
  if (store_result_ == StoreResult::under_way) return "did not confirm what was to be stored";
  if (!has_info_) {
    return strange_ > 1 ? "sends what is no frame of ours: another device, or another baud rate"
                        : "does not answer: expected a Palpate device that is switched on";
  }
  return "answered, but not with its calibration or a report";
}

}  // namespace palpate
