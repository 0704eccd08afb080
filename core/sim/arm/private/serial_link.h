// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <vector>

#include "palpate/sim/arm/calibration.h"
#include "palpate/sim/arm/private/clock_fit.h"
#include "palpate/sim/arm/serial_device.h"
#include "palpate/sim/arm/transport.h"
#include "palpate/sim/base/private/duration_histogram.h"

extern "C" {
#include "protocol/frame.h"
#include "protocol/messages.h"
}

namespace palpate {

enum class StoreResult { none, under_way, done, refused };

/// The host's end of the protocol of firmware/protocol/PROTOCOL.md: frames to messages, who is
/// there, what has to be asked next. Knows no kinematics. One thread calls it, but for the two
/// requests that say otherwise.
class SerialLink {
 public:
  explicit SerialLink(Transport& transport) : transport_(transport) { greet(); }

  /// Starts again with the device at the other end.
  void greet() noexcept;
  /// Takes what has come by `time` [s] and asks for what is missing. True if a report was in it.
  bool receive(double time) noexcept;
  /// One command of `torque` [N·m], and whatever order is due before it. Zero torques go out
  /// until the motors are on. The device adds `stiffness` [N·m/rad], if any, times the path that
  /// the joints have gone since the newest report, against it.
  void command(double time, const Vec3& torque, const Mat3& stiffness = Mat3::Zero()) noexcept;
  void disable(double time) noexcept;
  void clear_fault() noexcept { clearing_.store(true, std::memory_order_relaxed); }  ///< any thread
  void enable(bool on) noexcept { enabled_.store(on, std::memory_order_relaxed); }   ///< any thread
  bool is_enabled() const noexcept { return enabled_.load(std::memory_order_relaxed); }

  void begin_store(std::vector<std::uint8_t> bytes);
  StoreResult store_result() const noexcept { return store_result_; }
  std::string store_refusal() const;

  LinkState state() const noexcept { return state_; }
  const Calibration* calibration() const noexcept {
    return calibration_ ? &*calibration_ : nullptr;
  }
  bool has_report() const noexcept { return has_report_; }
  const std::array<std::uint16_t, 6>& counts() const noexcept { return counts_; }
  std::uint8_t buttons() const noexcept { return report_.buttons; }
  int duty(int motor) const noexcept { return report_.duty[motor]; }
  bool faulted() const noexcept { return report_.mode == PALPATE_FAULTED; }
  int first_fault() const noexcept { return report_.first_fault; }  ///< PALPATE_FAULT_...
  bool driving() const noexcept {
    return report_.mode == PALPATE_RAMP || report_.mode == PALPATE_RUN;
  }
  bool obeys_law() const noexcept { return (info_.features & PALPATE_FEATURE_LAW) != 0; }
  double device_time() const noexcept { return clock_.device_time(); }
  Vec3 torque_max() const noexcept;  ///< [N·m] that the motors may be asked for
  void fill(DeviceStatus& status) const noexcept;
  std::string explain_silence() const;
  std::string name() const { return transport_.name(); }
  bool can_wait() const noexcept { return transport_.can_wait(); }
  bool wait(std::int64_t latest) noexcept { return transport_.wait(latest); }
  double now(double time) const noexcept { return transport_.now(time); }

 private:
  void take_frame(double time) noexcept;
  void take_report(double time) noexcept;
  void take_info() noexcept;
  void take_page() noexcept;
  void take_answer() noexcept;
  void ask(double time) noexcept;
  void ask_page(double time) noexcept;
  void send_store(double time) noexcept;
  bool send_order(double time) noexcept;
  void measure(double time) noexcept;
  void send(double time, std::uint8_t count) noexcept;
  bool is_due(double time, double pause) noexcept;

  Transport& transport_;
  palpate_decoder decoder_{};
  LinkState state_ = LinkState::greeting;
  std::array<std::uint8_t, PALPATE_BODY_MAX> body_{};
  std::uint8_t seq_ = 0;
  double last_time_ = 0.0, last_asked_ = 0.0, last_heard_ = 0.0, last_command_ = 0.0;
  double silence_ = 0.0;  ///< [s] that was listened to since the last report
  bool asked_ = false, was_ready_ = false;

  palpate_info info_{};
  bool has_info_ = false, wrong_version_ = false;
  std::array<std::uint8_t, PALPATE_PAGES * PALPATE_PAGE_BYTES> pages_{};
  int page_ = 0;
  std::optional<Calibration> calibration_;

  palpate_state report_{};
  std::array<std::uint16_t, 6> counts_{};
  bool has_report_ = false;
  int zero_commands_ = 0;

  std::vector<std::uint8_t> store_;
  int store_page_ = 0;
  StoreResult store_result_ = StoreResult::none;
  std::uint8_t store_seq_ = 0, store_answer_ = 0;

  std::atomic<bool> clearing_{false}, enabled_{true};
  std::array<double, 256> sent_at_{};  ///< [s] by seq, of commands; negative where none was
  ClockFit clock_;
  DurationHistogram round_trips_, jitters_;
  std::array<long, 40> round_trip_counts_{};  ///< as DeviceStatus::round_trips
  std::array<int, 8> counters_{};
  long reports_ = 0, lost_ = 0, damaged_ = 0, strange_ = 0, commands_ = 0;
  long reports_before_ = 0;
  double second_began_ = 0.0, rate_ = 0.0;
};

}  // namespace palpate
