// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/simavr/chip.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

extern "C" {
#include <simavr/avr_adc.h>
#include <simavr/avr_eeprom.h>
#include <simavr/avr_ioport.h>
#include <simavr/sim_cycle_timers.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_interrupts.h>
}

#include "palpate/sim/base/error.h"

namespace palpate {
namespace {

using Chip = SimAvr::Chip;

// interrupt numbers of the ATmega328P
constexpr int kTickVector = 14, kReceiveVector = 18;
constexpr int kMostVectors = 26;
constexpr std::uint8_t kPaint = 0xa5;

// Called instead of sleeping in real time; the emulator then moves its clock by one cycle more.
void see_sleep(avr_t* avr, avr_cycle_count_t cycles) {
  static_cast<Chip*>(avr->custom.data)->slept += 1 + cycles;
}

void see_byte(avr_irq_t*, std::uint32_t value, void* param) {
  Chip& chip = *static_cast<Chip*>(param);
  const std::uint64_t end = chip.avr->cycle + chip.byte_cycles;
  chip.leaving.emplace_back(end, static_cast<std::uint8_t>(value));
  chip.meter.send(static_cast<std::uint8_t>(value), end);
}

void see_interrupt(avr_irq_t*, std::uint32_t running, void* param) {
  Chip& chip = *static_cast<Chip*>(param);
  if (running) chip.meter.enter_interrupt(chip.slept > 0);
}

void see_tick(avr_irq_t*, std::uint32_t running, void* param) {
  Chip& chip = *static_cast<Chip*>(param);
  if (running) chip.meter.tick(chip.avr->cycle);
}

void see_receive(avr_irq_t*, std::uint32_t running, void* param) {
  Chip& chip = *static_cast<Chip*>(param);
  if (!running || chip.due.empty()) return;
  const std::uint64_t end = chip.due.front();
  chip.due.pop_front();
  if (chip.avr->cycle >= end) chip.meter.receive(chip.avr->cycle - end);
}

avr_cycle_count_t feed_next(avr_t*, avr_cycle_count_t when, void* param) {
  Chip& chip = *static_cast<Chip*>(param);
  while (!chip.coming.empty() && chip.coming.front().first <= when) {
    chip.feed(chip.coming.front().second);
    chip.coming.pop_front();
  }
  return chip.coming.empty() ? 0 : chip.coming.front().first;
}

avr_cycle_count_t stop_here(avr_t*, avr_cycle_count_t, void*) { return 0; }

void log_errors(avr_t*, int level, const char* format, va_list values) {
  if (level == LOG_ERROR) std::vfprintf(stderr, format, values);
}

void (*reset_core)(avr_t*) = nullptr;

void see_reset(avr_t* avr) {
  if (reset_core) reset_core(avr);
  static_cast<Chip*>(avr->custom.data)->was_reset = true;
}

avr_uart_t* find_uart(avr_t* avr) {
  for (avr_io_t* io = avr->io_port; io; io = io->next) {
    if (std::strcmp(io->kind, "uart") == 0) return reinterpret_cast<avr_uart_t*>(io);
  }
  return nullptr;
}

}  // namespace

SimAvr::Chip::Chip(const std::string& image, int baud, std::span<const std::uint8_t> eeprom) {
  if (baud <= 0) throw std::invalid_argument("baud must be positive, got " + std::to_string(baud));
  byte_cycles = 10 * kFrequency / static_cast<std::uint64_t>(baud);
  avr_global_logger_set(log_errors);
  elf_firmware_t firmware{};
  if (!std::filesystem::is_regular_file(image) || elf_read_firmware(image.c_str(), &firmware)) {
    throw FileError(image, "", "no ELF file that can be read", "the image of the firmware");
  }
  avr = avr_make_mcu_by_name("atmega328p");
  if (!avr) throw DeviceError("this libsimavr knows no ATmega328P");
  avr_init(avr);
  avr->log = LOG_ERROR;
  avr->sleep = see_sleep;
  avr->custom.data = this;
  reset_core = avr->reset;
  avr->reset = see_reset;
  avr->run_cycle_limit = 200;  // so that load is booked in the slot where it was spent
  firmware.frequency = kFrequency;
  std::strcpy(firmware.mmcu, "atmega328p");
  avr_load_firmware(avr, &firmware);
  avr->frequency = kFrequency;
  avr->vcc = avr->avcc = avr->aref = 5000;
  stack_bottom = 0x100 + static_cast<int>(firmware.datasize + firmware.bsssize);
  std::fill(avr->data + stack_bottom, avr->data + avr->ramend + 1, kPaint);
  if (!eeprom.empty()) {
    std::vector<std::uint8_t> bytes(eeprom.begin(), eeprom.end());
    avr_eeprom_desc_t all{bytes.data(), 0, static_cast<std::uint32_t>(bytes.size())};
    avr_ioctl(avr, AVR_IOCTL_EEPROM_SET, &all);
  }
  uart = find_uart(avr);
  std::uint32_t no_flags = 0;
  avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &no_flags);
  avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), see_byte,
                          this);
  watch_interrupts();
  wire_pins();
}

void SimAvr::Chip::wire_pins() {
  for (int pin : {2, 6}) set_pin('D', pin, pins_d >> pin & 1);
  for (int pin : {3, 4}) set_pin('B', pin, pins_b >> pin & 1);
  for (int joint = 0; joint < 6; ++joint) set_position(joint, counts[joint]);
}

// The emulator gives floor(mV 1023 / 5000); so many mV give exactly these counts.
void SimAvr::Chip::set_position(int joint, int value) {
  counts[static_cast<std::size_t>(joint)] = std::clamp(value, 0, 1023);
  const int millivolts = (counts[static_cast<std::size_t>(joint)] * 5000 + 1022) / 1023;
  avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, joint),
                static_cast<std::uint32_t>(millivolts));
}

SimAvr::Chip::~Chip() {
  avr_terminate(avr);
  std::free(avr);
}

void SimAvr::Chip::watch_interrupts() {
  for (int vector = 1; vector < kMostVectors; ++vector) {
    avr_irq_t* irq = avr_get_interrupt_irq(avr, static_cast<std::uint8_t>(vector));
    if (!irq) continue;
    avr_irq_register_notify(irq + AVR_INT_IRQ_RUNNING, see_interrupt, this);
    if (vector == kTickVector) avr_irq_register_notify(irq + AVR_INT_IRQ_RUNNING, see_tick, this);
    if (vector == kReceiveVector) {
      avr_irq_register_notify(irq + AVR_INT_IRQ_RUNNING, see_receive, this);
    }
  }
}

void SimAvr::Chip::set_pin(char port, int pin, bool high) {
  std::uint8_t& pins = port == 'D' ? pins_d : pins_b;
  const auto bit = static_cast<std::uint8_t>(1 << pin);
  pins = static_cast<std::uint8_t>(high ? pins | bit : pins & ~bit);
  // a raised pin alone is forgotten at the next write to PORT, which sets the pull-ups again
  avr_ioport_external_t external{};
  external.name = static_cast<unsigned long>(port);
  external.mask = port == 'D' ? 0x44 : 0x18;
  external.value = pins;
  avr_ioctl(avr, AVR_IOCTL_IOPORT_SET_EXTERNAL(port), &external);
  // only a change is heard, and after a reset the pin's own value is gone
  avr_irq_t* irq = avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ(port), pin);
  avr_raise_irq(irq, !high);
  avr_raise_irq(irq, high);
}

// The chip holds two bytes and a third in its shift register; the emulator would hold 64.
void SimAvr::Chip::feed(std::uint8_t byte) {
  uart->cycles_per_byte = byte_cycles;
  const unsigned unread = (uart->input.write - uart->input.read) & (uart_fifo_fifo_size - 1u);
  if (unread >= 3) {
    meter.overrun();
    return;
  }
  due.push_back(avr->cycle + byte_cycles);
  avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT), byte);
}

void SimAvr::Chip::run(std::uint64_t cycles) {
  const std::uint64_t end = avr->cycle + cycles;
  if (!coming.empty()) {
    avr_cycle_timer_cancel(avr, feed_next, this);
    const std::uint64_t first = coming.front().first;
    avr_cycle_timer_register(avr, first > avr->cycle ? first - avr->cycle : 1, feed_next, this);
  }
  avr_cycle_timer_cancel(avr, stop_here, this);
  avr_cycle_timer_register(avr, cycles, stop_here, this);
  while (avr->cycle < end) {
    // the emulator counts eleven bits to a byte; the wire has ten
    uart->cycles_per_byte = byte_cycles;
    const std::uint64_t before = avr->cycle;
    slept = 0;
    const int state = avr_run(avr);
    if (state == cpu_Done || state == cpu_Crashed) {
      throw DeviceError("the emulated processor stopped at address " + std::to_string(avr->pc));
    }
    if (was_reset) {
      was_reset = false;
      wire_pins();
    }
    meter.spend(avr->cycle, avr->cycle - before - slept);
  }
}

}  // namespace palpate
