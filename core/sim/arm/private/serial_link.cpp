// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/arm/private/serial_link.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/arm/private/calibration_bytes.h"
#include "palpate/sim/arm/private/local_law.h"

namespace palpate {
namespace {

constexpr double kAskAgain = 50e-3;    // [s] until a question counts as lost
constexpr double kStoreAgain = 3.0;    // [s] that the device may take to write its EEPROM
constexpr double kQuiet = 0.1;         // [s] without a report: the device was reset, or is gone
constexpr double kGone = 1.0;          // [s] without a report: it is gone
constexpr double kAway = 20e-3;        // [s] most that counts as silence between two reads
constexpr double kShortest = 0.75e-3;  // [s] between two commands, whatever the host's rate
constexpr double kTripBin = 0.25e-3;   // [s] of DeviceStatus::round_trips
constexpr int kZerosNeeded = 3;        // commands before the motors may be switched on

std::int64_t to_nanoseconds(double seconds) noexcept {
  return std::llround(1e9 * std::clamp(seconds, 0.0, 1e3));
}

}  // namespace

void SerialLink::greet() noexcept {
  state_ = LinkState::greeting;
  palpate_skip_to_delimiter(&decoder_);
  asked_ = has_info_ = has_report_ = wrong_version_ = false;
  page_ = zero_commands_ = 0;
  calibration_.reset();
  clock_.clear();
  sent_at_.fill(-1.0);
  silence_ = 0.0;
}

bool SerialLink::receive(double time) noexcept {
  if (time < last_time_) {  // a new run: no question is older than it
    last_time_ = last_heard_ = last_asked_ = last_command_ = second_began_ = time;
    reports_before_ = reports_;
    sent_at_.fill(-1.0);
    clock_.restart();
    silence_ = 0.0;
  }
  // a host that was stopped for a while has not listened: the device may have spoken
  silence_ += std::min(time - last_time_, kAway);
  last_time_ = time;
  if (state_ == LinkState::lost) return false;
  const long before = reports_;
  std::array<std::uint8_t, 512> bytes;
  for (std::size_t count = bytes.size(); count == bytes.size();) {
    count = transport_.read(time, bytes);
    for (std::size_t i = 0; i < count; ++i) {
      const palpate_decoded decoded = palpate_decode_byte(&decoder_, bytes[i]);
      if (decoded == PALPATE_FRAME) take_frame(time);
      // what came before the first whole frame began in the middle of one
      if (decoded == PALPATE_DAMAGED) ++(has_info_ ? damaged_ : strange_);
    }
  }
  ask(time);
  return reports_ > before && state_ == LinkState::ready;
}

void SerialLink::take_frame(double time) noexcept {
  switch (decoder_.body[0]) {
    case PALPATE_STATE:
      return take_report(time);
    case PALPATE_INFO:
      return take_info();
    case PALPATE_PAGE:
      return take_page();
    case PALPATE_ANSWER:
      return take_answer();
    default:
      return;  // perhaps of a newer protocol, which this driver does not know
  }
}

void SerialLink::take_report(double time) noexcept {
  palpate_state report;
  if (!palpate_read_state(decoder_.body, decoder_.count, &report)) return;
  // one that was overtaken, or comes again, is no news
  const auto gap = static_cast<std::int16_t>(report.tick - report_.tick);
  if (reports_ > 0 && (gap == 0 || (has_report_ && gap < 0))) return;
  report_ = report;
  for (std::size_t j = 0; j < counts_.size(); ++j) counts_[j] = report.position[j];
  counters_[report.seq & 7] = report.aux;
  last_heard_ = time;
  silence_ = 0.0;
  ++reports_;
  measure(time);
  // what ended the last host's run is no reason against ours
  if (!has_report_ && report.first_fault == PALPATE_FAULT_HOST_SILENT) clear_fault();
  has_report_ = true;
}

/// The clocks, the path to and fro, and how many reports come: by the arrival of this one.
void SerialLink::measure(double time) noexcept {
  const double now = transport_.now(time);
  const double late = clock_.add(report_.tick, now);
  jitters_.add(to_nanoseconds(std::abs(late)));
  if (has_report_ && clock_.gap() > 1) lost_ += clock_.gap() - 1;
  double& sent = sent_at_[report_.ack];
  if (sent >= 0.0) {
    round_trips_.add(to_nanoseconds(now - sent));
    const double last = double(round_trip_counts_.size() - 1);
    ++round_trip_counts_[static_cast<std::size_t>(std::clamp((now - sent) / kTripBin, 0.0, last))];
  }
  sent = -1.0;  // the same acknowledgement comes with every report until the next command
  if (now - second_began_ >= 1.0 || now < second_began_) {
    rate_ = double(reports_ - reports_before_) / std::max(1e-3, now - second_began_);
    reports_before_ = reports_;
    second_began_ = now;
  }
}

void SerialLink::take_info() noexcept {
  palpate_info info;
  if (!palpate_read_info(decoder_.body, decoder_.count, &info) || state_ == LinkState::lost) return;
  const bool known = state_ != LinkState::greeting && info.version == info_.version &&
                     info.calibration_crc == info_.calibration_crc;
  info_ = info;
  // each HELLO begins a session, so of several answers that come late the last one counts
  zero_commands_ = 0;
  if (known) return;
  has_info_ = true;
  wrong_version_ = info.version != PALPATE_PROTOCOL_VERSION;
  if (wrong_version_) {
    state_ = LinkState::lost;
  } else {
    state_ = info.calibration_crc == 0 ? LinkState::uncalibrated : LinkState::loading;
  }
  asked_ = false;
}

void SerialLink::take_page() noexcept {
  palpate_page page;
  if (state_ != LinkState::loading ||
      !palpate_read_page(decoder_.body, decoder_.count, PALPATE_PAGE, &page) ||
      page.page != page_) {
    return;
  }
  std::copy(std::begin(page.bytes), std::end(page.bytes),
            pages_.begin() + page_ * PALPATE_PAGE_BYTES);
  asked_ = false;
  if (++page_ < PALPATE_PAGES) return;
  page_ = 0;
  // a page that changed on its way would have failed its frame's check; this is the whole
  if (palpate_compute_crc(pages_.data(), static_cast<std::uint16_t>(pages_.size())) !=
      info_.calibration_crc) {
    return;
  }
  calibration_ = read_calibration(pages_);
  state_ = calibration_ ? LinkState::ready : LinkState::uncalibrated;
  was_ready_ = was_ready_ || state_ == LinkState::ready;
}

void SerialLink::take_answer() noexcept {
  palpate_answer answer;
  if (!palpate_read_answer(decoder_.body, decoder_.count, &answer)) return;
  // someone else has said HELLO since, or the answer to our own is lost
  if (answer.result == PALPATE_WRONG_SESSION && state_ == LinkState::ready) greet();
  if (store_result_ != StoreResult::under_way || answer.seq != store_seq_) return;
  const bool storing = answer.type == PALPATE_STORE;
  if (answer.result == PALPATE_BUSY || answer.result == PALPATE_WRONG_MODE) return;  // ask again
  store_answer_ = answer.result;
  asked_ = false;
  if (answer.result != PALPATE_DONE) {
    store_result_ = StoreResult::refused;
  } else if (storing) {
    store_result_ = StoreResult::done;
  } else {
    ++store_page_;
  }
}

bool SerialLink::is_due(double time, double pause) noexcept {
  if (asked_ && time - last_asked_ < pause) return false;
  asked_ = true;
  last_asked_ = time;
  return true;
}

/// Whatever has to be asked next: one question at a time, and again when no answer came.
void SerialLink::ask(double time) noexcept {
  if (!transport_.is_open()) {
    state_ = LinkState::lost;
    return;
  }
  if (was_ready_ && silence_ > kGone) state_ = LinkState::lost;
  if (state_ == LinkState::lost) return;
  if (state_ == LinkState::ready && silence_ > kQuiet) {
    const double silence = silence_;
    greet();
    silence_ = silence;  // greeting is no sign of life
  }
  if (store_result_ == StoreResult::under_way) {
    send_store(time);
  } else if (state_ == LinkState::greeting && is_due(time, kAskAgain)) {
    const palpate_hello hello{++seq_, PALPATE_PROTOCOL_VERSION, seq_};
    send(time, palpate_write_hello(&hello, body_.data()));
  } else if (state_ == LinkState::loading && is_due(time, kAskAgain)) {
    send(time, palpate_write_read_page(++seq_, static_cast<std::uint8_t>(page_), body_.data()));
  }
}

void SerialLink::begin_store(std::vector<std::uint8_t> bytes) {
  store_ = std::move(bytes);
  store_page_ = 0;
  store_result_ = StoreResult::under_way;
  asked_ = false;
}

void SerialLink::send_store(double time) noexcept {
  const bool last = store_page_ == PALPATE_PAGES;
  if (!is_due(time, last ? kStoreAgain : kAskAgain)) return;
  if (driving()) {
    disable(time);
    return;
  }
  store_seq_ = ++seq_;
  if (last) {
    const palpate_store order{
        store_seq_, palpate_compute_crc(store_.data(), PALPATE_PAGES * PALPATE_PAGE_BYTES)};
    send(time, palpate_write_store(&order, body_.data()));
    return;
  }
  palpate_page page{store_seq_, static_cast<std::uint8_t>(store_page_), {}};
  std::copy_n(store_.begin() + store_page_ * PALPATE_PAGE_BYTES, PALPATE_PAGE_BYTES, page.bytes);
  send(time, palpate_write_page(PALPATE_WRITE_PAGE, &page, body_.data()));
}

std::string SerialLink::store_refusal() const { return palpate_result_name(store_answer_); }

Vec3 SerialLink::torque_max() const noexcept {
  if (!calibration_) return Vec3::Zero();
  return calibration_->torque_full.cwiseAbs() *
         (double(info_.duty_max) / double(PALPATE_DUTY_FULL));
}

/// Motors on or off, or a fault forgotten, where the device is not yet as wanted. True if an order
/// went out.
bool SerialLink::send_order(double time) noexcept {
  const bool wanted = enabled_.load(std::memory_order_relaxed);
  const bool clearing = clearing_.load(std::memory_order_relaxed);
  if (clearing && report_.mode != PALPATE_FAULTED) {
    clearing_.store(false, std::memory_order_relaxed);
    return false;
  }
  const bool on = wanted && report_.mode == PALPATE_IDLE && zero_commands_ >= kZerosNeeded;
  const bool off = !wanted && driving();
  if (!(clearing || on || off) || !is_due(time, kAskAgain)) return false;
  if (off) {
    disable(time);
    return true;
  }
  const palpate_order order{++seq_, info_.session};
  send(time, palpate_write_order(clearing ? PALPATE_CLEAR : PALPATE_ENABLE, &order, body_.data()));
  // once: whether the cause is gone, the next report tells
  clearing_.store(false, std::memory_order_relaxed);
  return true;
}

void SerialLink::command(double time, const Vec3& torque, const Mat3& stiffness) noexcept {
  if (state_ != LinkState::ready || !has_report_) return;
  const double since = time - last_command_;
  if (since >= 0.0 && since < kShortest && commands_ > 0) return;
  last_command_ = time;
  send_order(time);
  palpate_command command{};
  command.seq = ++seq_;
  if (driving()) {
    for (int m = 0; m < PALPATE_MOTORS; ++m) {
      const double part = torque[m] / calibration_->torque_full[m];
      command.torque[m] = static_cast<std::int16_t>(
          std::lround(std::clamp(part, -1.0, 1.0) * double(PALPATE_TORQUE_FULL)));
    }
    if (!stiffness.isZero(0.0)) add_law(*calibration_, stiffness, counts_, command);
    zero_commands_ = 0;
  } else {
    ++zero_commands_;
  }
  sent_at_[command.seq] = transport_.now(time);
  ++commands_;
  send(time, palpate_write_command(&command, body_.data()));
}

void SerialLink::disable(double time) noexcept {
  send(time, palpate_write_disable(++seq_, body_.data()));
}

void SerialLink::send(double time, std::uint8_t count) noexcept {
  std::array<std::uint8_t, PALPATE_WIRE_MAX> wire;
  const std::size_t length = palpate_encode_frame(body_.data(), count, wire.data());
  transport_.write(time, std::span(wire).first(length));
}

}  // namespace palpate
