// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/simavr/emulated_core.h"

#include <Eigen/LU>
#include <algorithm>
#include <deque>
#include <stdexcept>

#include "palpate/sim/arm/private/calibration_bytes.h"
#include "palpate/sim/base/error.h"

namespace palpate {
namespace {

constexpr std::uint64_t kStep = SimAvr::kTick / 20;  ///< [cycles] between reads of pins and wire
constexpr double kStepTime = static_cast<double>(kStep) / SimAvr::kFrequency;  ///< [s]

std::vector<std::uint8_t> build_eeprom(const Plant& plant) {
  validate(plant);
  std::vector<std::uint8_t> eeprom(SimAvr::kEepromBytes, 0xff);
  write_eeprom(find_calibration(plant), eeprom);
  return eeprom;
}

struct TimedByte {
  double time = 0.0;  ///< [s] of arrival
  std::uint8_t byte = 0;
};

}  // namespace

struct EmulatedCore::Impl {
  Impl(const std::string& image, const Plant& plant_in, const EmulatedCoreOptions& options_in)
      : plant(plant_in),
        options(options_in),
        state(plant_in),
        chip(image, options.baud, build_eeprom(plant)) {
    if (!(options.link_delay >= 0.0 && options.link_delay <= 0.1)) {
      throw std::invalid_argument("emulated core: link_delay [s] must be 0 to 0.1, got " +
                                  std::to_string(options.link_delay));
    }
  }

  void live_step();
  void live_until(double time) noexcept;

  const Plant plant;
  const EmulatedCoreOptions options;
  PlantState state;
  SimAvr chip;
  HandTarget hand;
  Drive drive;
  std::deque<TimedByte> to_host, to_device;
  double clock = 0.0;       ///< [s] since it was made
  double run_clock = 0.0;   ///< [s] where the run's time was zero
  double last_time = 0.0;   ///< [s] of the run
  std::uint64_t until = 0;  ///< [cycles] of the chip
  bool plugged = true;
};

void EmulatedCore::Impl::live_step() {
  std::vector<std::uint8_t> coming;
  while (!to_device.empty() && to_device.front().time <= clock) {
    coming.push_back(to_device.front().byte);
    to_device.pop_front();
  }
  chip.receive(coming);
  const auto counts = read_sensors(plant, state);
  for (int j = 0; j < 6; ++j) chip.set_position(j, counts[static_cast<std::size_t>(j)]);
  // an instruction is not divided, so a step may have run a cycle or two over
  until += kStep;
  chip.run(until - chip.cycle());
  for (int m = 0; m < 3; ++m) drive.duty[m] = chip.duty(m);
  drive.enabled = chip.enabled();
  move_plant(plant, drive, hand, kStepTime, state);
  hand.position += hand.velocity * kStepTime;
  clock += kStepTime;
  for (const std::uint8_t byte : chip.take()) {
    if (plugged) to_host.push_back({clock + options.link_delay, byte});
  }
}

void EmulatedCore::Impl::live_until(double time) noexcept {
  if (time < last_time) run_clock = clock - time;  // a new run goes on from here
  last_time = time;
  try {
    while (clock < run_clock + time - 1e-9) live_step();
  } catch (const DeviceError&) {
    plugged = false;
  }
}

EmulatedCore::EmulatedCore(const std::string& image, const Plant& plant,
                           const EmulatedCoreOptions& options)
    : impl_(std::make_unique<Impl>(image, plant, options)) {}
EmulatedCore::~EmulatedCore() = default;

std::size_t EmulatedCore::read(double time, std::span<std::uint8_t> bytes) noexcept {
  impl_->live_until(time);
  auto& queue = impl_->to_host;
  std::size_t taken = 0;
  while (taken < bytes.size() && !queue.empty() && queue.front().time <= impl_->clock) {
    bytes[taken++] = queue.front().byte;
    queue.pop_front();
  }
  return taken;
}

void EmulatedCore::write(double time, std::span<const std::uint8_t> bytes) noexcept {
  impl_->live_until(time);
  if (!impl_->plugged) return;
  for (const std::uint8_t byte : bytes) {
    impl_->to_device.push_back({impl_->clock + impl_->options.link_delay, byte});
  }
}

bool EmulatedCore::is_open() const noexcept { return impl_->plugged; }

void EmulatedCore::advance(double time) noexcept {
  impl_->live_until(time);
  impl_->to_host.clear();
}

void EmulatedCore::hold(const HandTarget& hand) noexcept { impl_->hand = hand; }

void EmulatedCore::pull_cable() noexcept {
  impl_->plugged = false;
  impl_->to_host.clear();
  impl_->to_device.clear();
}

const Plant& EmulatedCore::plant() const noexcept { return impl_->plant; }
const PlantState& EmulatedCore::state() const noexcept { return impl_->state; }
PlantState& EmulatedCore::state() noexcept { return impl_->state; }
const Drive& EmulatedCore::drive() const noexcept { return impl_->drive; }
SimAvr& EmulatedCore::chip() noexcept { return impl_->chip; }

Vec3 EmulatedCore::motor_force() const noexcept {
  const Vec3 torque = compute_motor_torque(impl_->plant, impl_->drive, impl_->state.rates);
  const Mat3 jacobian = compute_jacobian(find_arm(impl_->plant), impl_->state.joints);
  return jacobian.transpose().inverse() * torque;
}

}  // namespace palpate
