// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "palpate/simavr/sim_avr.h"

namespace palpate {

/// Adds up what a processor does. Interrupts cost what the emulator leaves out: four cycles to
/// enter, and four more to wake.
class LoadMeter {
 public:
  void start(std::uint64_t cycle) { *this = LoadMeter(cycle); }
  LoadMeter() = default;

  void spend(std::uint64_t cycle, std::uint64_t busy);
  void tick(std::uint64_t cycle);
  void enter_interrupt(bool woken) { owed_ += woken ? 8 : 4; }
  void receive(std::uint64_t delay) {
    if (delay > profile_.receive_delay_max) profile_.receive_delay_max = delay;
  }
  void overrun() { ++profile_.bytes_overrun; }
  /// A byte that leaves at `cycle`; zero ends a frame.
  void send(std::uint8_t byte, std::uint64_t cycle);
  SimAvrProfile profile(std::uint64_t cycle) const;

 private:
  explicit LoadMeter(std::uint64_t cycle) : begin_(cycle), slot_(cycle / kSlot) {}

  static constexpr std::uint64_t kSlots = 16;
  static constexpr std::uint64_t kSlot = SimAvr::kTick / kSlots;
  void close_slot();

  SimAvrProfile profile_;
  std::uint64_t begin_ = 0, slot_ = 0, busy_ = 0, owed_ = 0;
  std::array<std::uint64_t, kSlots> slots_{};  ///< busy cycles of the last millisecond
  std::uint64_t window_ = 0, worst_ = 0, closed_ = 0;
  std::uint64_t last_tick_ = 0;
  std::uint64_t frame_tick_ = 0;  ///< the tick that the frame being sent came from; 0: none is
  double delay_sum_ = 0.0;
  long delays_ = 0;
};

}  // namespace palpate
