// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/simavr/sim_avr.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

extern "C" {
#include <simavr/avr_eeprom.h>
}

#include "palpate/simavr/chip.h"

namespace palpate {
namespace {

// addresses in the data space of the ATmega328P
constexpr int kPortB = 0x25, kPortD = 0x2b, kOcr1a = 0x88, kOcr1b = 0x8a, kOcr2b = 0xb4;
constexpr std::uint8_t kEnable = 1 << 5;

}  // namespace

SimAvr::SimAvr(const std::string& image, int baud, std::span<const std::uint8_t> eeprom) {
  if (!eeprom.empty() && eeprom.size() != kEepromBytes) {
    throw std::invalid_argument("eeprom must have 1024 bytes, got " +
                                std::to_string(eeprom.size()));
  }
  chip_ = std::make_unique<Chip>(image, baud, eeprom);
}

SimAvr::~SimAvr() = default;
SimAvr::SimAvr(SimAvr&&) noexcept = default;
SimAvr& SimAvr::operator=(SimAvr&&) noexcept = default;

void SimAvr::run(std::uint64_t cycles) { chip_->run(cycles); }
std::uint64_t SimAvr::cycle() const { return chip_->avr->cycle; }

void SimAvr::set_position(int joint, int counts) {
  assert(joint >= 0 && joint < 6);
  chip_->set_position(joint, counts);
}

void SimAvr::set_stop_open(bool open) { chip_->set_pin('D', 2, open); }
void SimAvr::set_driver_fault(bool fault) { chip_->set_pin('D', 6, !fault); }

void SimAvr::set_buttons(int buttons) {
  chip_->set_pin('B', 3, !(buttons & 1));
  chip_->set_pin('B', 4, !(buttons & 2));
}

bool SimAvr::enabled() const { return chip_->avr->data[kPortD] & kEnable; }

void SimAvr::stop_converter() {
  constexpr avr_io_addr_t kAdcsra = 0x7a;
  constexpr std::uint8_t kAden = 0x80;
  avr_t* avr = chip_->avr;
  const auto value = static_cast<std::uint8_t>(avr->data[kAdcsra] & ~kAden);
  const auto& io = avr->io[AVR_DATA_TO_IO(kAdcsra)];
  io.w.c(avr, kAdcsra, value, io.w.param);
}

int SimAvr::duty(int motor) const {
  assert(motor >= 0 && motor < 3);
  if (!enabled()) return 0;
  const std::uint8_t* data = chip_->avr->data;
  constexpr int registers[] = {kOcr1a, kOcr1b, kOcr2b};
  const bool back = motor == 0   ? data[kPortD] & 1 << 4
                    : motor == 1 ? data[kPortD] & 1 << 7
                                 : data[kPortB] & 1 << 0;
  const int size = data[registers[motor]];
  return back ? -size : size;
}

void SimAvr::receive(std::span<const std::uint8_t> bytes) {
  std::uint64_t start = std::max<std::uint64_t>(chip_->avr->cycle + 1, chip_->wire_free);
  for (std::uint8_t byte : bytes) {
    chip_->coming.emplace_back(start, byte);
    start += chip_->byte_cycles;
  }
  chip_->wire_free = start;
}

std::uint64_t SimAvr::receive_end() const { return chip_->wire_free; }

std::vector<std::uint8_t> SimAvr::take() {
  std::vector<std::uint8_t> bytes;
  auto& leaving = chip_->leaving;
  while (!leaving.empty() && leaving.front().first <= chip_->avr->cycle) {
    bytes.push_back(leaving.front().second);
    leaving.pop_front();
  }
  return bytes;
}

std::array<std::uint8_t, SimAvr::kEepromBytes> SimAvr::eeprom() const {
  std::array<std::uint8_t, kEepromBytes> bytes;
  avr_eeprom_desc_t all{bytes.data(), 0, kEepromBytes};
  avr_ioctl(chip_->avr, AVR_IOCTL_EEPROM_GET, &all);
  return bytes;
}

// Once asleep the main loop is at a known place: where it goes on when woken.
void SimAvr::hang_main_loop() {
  while (chip_->avr->state != cpu_Sleeping) chip_->run(1);
  constexpr std::uint8_t jump_to_itself[] = {0xff, 0xcf};
  chip_->patched_at = chip_->avr->pc;
  std::uint8_t* at = chip_->avr->flash + chip_->patched_at;
  std::copy(at, at + 2, chip_->patched);
  std::copy(jump_to_itself, jump_to_itself + 2, at);
}

void SimAvr::restore_main_loop() {
  std::copy(chip_->patched, chip_->patched + 2, chip_->avr->flash + chip_->patched_at);
}

void SimAvr::start_profile() {
  chip_->due.clear();
  chip_->meter.start(chip_->avr->cycle);
}

SimAvrProfile SimAvr::profile() const { return chip_->meter.profile(chip_->avr->cycle); }

int SimAvr::stack_free() const { return chip_->avr->ramend + 1 - chip_->stack_bottom; }

int SimAvr::stack_used() const {
  // the lowest byte that is no longer painted; what is below .noinit never was the stack's
  constexpr int kNoinit = 16;
  const std::uint8_t* data = chip_->avr->data;
  int deepest = chip_->stack_bottom + kNoinit;
  while (deepest <= chip_->avr->ramend && data[deepest] == 0xa5) ++deepest;
  return chip_->avr->ramend + 1 - deepest;
}

}  // namespace palpate
