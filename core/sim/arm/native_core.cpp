// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "palpate/sim/arm/private/calibration_bytes.h"
#include "palpate/sim/arm/simulated_arm.h"
#include "palpate/sim/base/private/refuse.h"

extern "C" {
#include "board/host.h"
}

namespace palpate {
namespace {

constexpr double kTick = 1e-3;       // [s] of the device
constexpr int kStepsPerTick = 20;    // at which it reads its wire
constexpr std::size_t kRing = 8192;  // bytes on their way; a power of two

/// Bytes that are on their way, each with the time it arrives. Full, it loses the newest.
class Wire {
 public:
  /// `time` [s] when the first of them may start, `byte_time` [s] for each.
  void push(double time, double byte_time, double delay,
            std::span<const std::uint8_t> bytes) noexcept {
    for (const std::uint8_t byte : bytes) {
      if (count_ == kRing) return;
      free_at_ = std::max(free_at_, time) + byte_time;
      slots_[(first_ + count_++) % kRing] = {free_at_ + delay, byte};
    }
  }
  std::size_t take(double time, std::span<std::uint8_t> bytes) noexcept {
    std::size_t taken = 0;
    while (taken < bytes.size() && count_ > 0 && slots_[first_].time <= time) {
      bytes[taken++] = slots_[first_].byte;
      first_ = (first_ + 1) % kRing;
      --count_;
    }
    return taken;
  }
  void clear() noexcept { count_ = 0; }

 private:
  struct Slot {
    double time = 0.0;
    std::uint8_t byte = 0;
  };
  std::array<Slot, kRing> slots_{};
  std::size_t first_ = 0, count_ = 0;
  double free_at_ = 0.0;
};

const NativeCoreOptions& validated(const NativeCoreOptions& options) {
  const auto require = [](bool good, const char* field, double value, const char* expected) {
    if (!good) refuse(std::string("native core: ") + field, write_text(value), expected);
  };
  require(options.baud >= 1e5 && options.baud <= 1e8, "baud [bit/s]", options.baud, "1e5 to 1e8");
  require(options.link_delay >= 0.0 && options.link_delay <= 0.1, "link_delay [s]",
          options.link_delay, "0 to 0.1");
  require(options.report_delay >= 0.0 && options.report_delay <= kTick, "report_delay [s]",
          options.report_delay, "0 to 0.001");
  require(std::abs(options.drift) <= 0.01, "drift", options.drift, "at most 0.01 either way");
  return options;
}

/// Both places where a copy may stand.
void damage(std::span<std::uint8_t> eeprom) {
  constexpr std::size_t kSecondCopy = 512, kInside = 40;
  for (const std::size_t at : {kInside, kSecondCopy + kInside}) eeprom[at] ^= 0x10;
}

}  // namespace

struct NativeCore::Impl {
  Impl(const Plant& plant_in, const NativeCoreOptions& options_in)
      : plant(plant_in), options(validated(options_in)), state(plant_in) {
    validate(plant);
    std::array<std::uint8_t, PALPATE_EEPROM_BYTES> eeprom;
    eeprom.fill(0xff);
    if (options.calibrated) write_eeprom(find_calibration(plant), eeprom);
    if (options.damaged) damage(eeprom);
    palpate_board_init(&board, eeprom.data());
  }

  void live_until(double time) noexcept;
  void live_step() noexcept;
  void run_tick() noexcept;

  const Plant plant;
  const NativeCoreOptions options;
  PlantState state;
  palpate_board board{};
  HandTarget hand;
  Drive drive;
  Wire to_host, to_device;
  double clock = 0.0;      ///< [s] its own, since it was made
  double run_clock = 0.0;  ///< [s] where the run's time was zero
  double last_time = 0.0;  ///< [s] of the run
  long steps = 0;
  bool plugged = true;
  std::array<bool, 6> cut{};
};

void NativeCore::Impl::run_tick() noexcept {
  const auto counts = read_sensors(plant, state);
  for (std::size_t j = 0; j < counts.size(); ++j) board.adc[j] = cut[j] ? kSensorEnd : counts[j];
  palpate_board_tick(&board);
  std::array<std::uint8_t, PALPATE_SEND_BYTES> bytes;
  const auto count = palpate_board_take(&board, bytes.data(), bytes.size());
  if (plugged) {
    to_host.push(clock + options.report_delay, 10.0 / options.baud, options.link_delay,
                 std::span(bytes).first(count));
  }
}

/// A twentieth of the device's millisecond: bytes in, a tick where one is due, then the arm moves.
void NativeCore::Impl::live_step() noexcept {
  std::array<std::uint8_t, 64> bytes;
  const std::size_t count = to_device.take(clock, bytes);
  if (count > 0) {
    palpate_board_receive(&board, bytes.data(), static_cast<std::uint16_t>(count));
  }
  if (steps++ % kStepsPerTick == 0) run_tick();
  drive.duty = Vec3(board.duty[0], board.duty[1], board.duty[2]);
  drive.enabled = board.enabled;
  const double dt = kTick / kStepsPerTick / (1.0 + options.drift);
  move_plant(plant, drive, hand, dt, state);
  hand.position += hand.velocity * dt;
  clock += dt;
}

void NativeCore::Impl::live_until(double time) noexcept {
  if (time < last_time) run_clock = clock - time;  // a new run goes on from here
  last_time = time;
  const double until = run_clock + time;
  while (clock < until - 1e-9) live_step();
}

NativeCore::NativeCore(const Plant& plant, const NativeCoreOptions& options)
    : impl_(std::make_unique<Impl>(plant, options)) {}
NativeCore::~NativeCore() = default;

std::size_t NativeCore::read(double time, std::span<std::uint8_t> bytes) noexcept {
  impl_->live_until(time);
  return impl_->plugged ? impl_->to_host.take(impl_->clock, bytes) : 0;
}

void NativeCore::write(double time, std::span<const std::uint8_t> bytes) noexcept {
  impl_->live_until(time);
  if (!impl_->plugged) return;
  impl_->to_device.push(impl_->clock, 10.0 / impl_->options.baud, impl_->options.link_delay, bytes);
}

bool NativeCore::is_open() const noexcept { return impl_->plugged; }

void NativeCore::advance(double time) noexcept {
  impl_->live_until(time);
  impl_->to_host.clear();
}

double NativeCore::time() const noexcept { return impl_->last_time; }

void NativeCore::hold(const HandTarget& hand) noexcept { impl_->hand = hand; }

void NativeCore::press_buttons(std::uint8_t buttons) noexcept { impl_->board.buttons = buttons; }

void NativeCore::press_stop(bool pressed) noexcept { impl_->board.stop_open = pressed; }

void NativeCore::cut_sensor(int joint, bool is_cut) noexcept {
  if (joint >= 0 && joint < 6) impl_->cut[static_cast<std::size_t>(joint)] = is_cut;
}

void NativeCore::pull_cable() noexcept {
  impl_->plugged = false;
  impl_->to_host.clear();
  impl_->to_device.clear();
}

void NativeCore::reset() noexcept {
  palpate_board_reset(&impl_->board, 1);
  impl_->to_host.clear();
}

const Plant& NativeCore::plant() const noexcept { return impl_->plant; }
const PlantState& NativeCore::state() const noexcept { return impl_->state; }
PlantState& NativeCore::state() noexcept { return impl_->state; }
const Drive& NativeCore::drive() const noexcept { return impl_->drive; }

Vec3 NativeCore::motor_force() const noexcept {
  const Vec3 torque = compute_motor_torque(impl_->plant, impl_->drive, impl_->state.rates);
  const Mat3 jacobian = compute_jacobian(find_arm(impl_->plant), impl_->state.joints);
  return jacobian.transpose().inverse() * torque;
}

}  // namespace palpate
