// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/simavr/load_meter.h"

#include <algorithm>

namespace palpate {

void LoadMeter::close_slot() {
  std::uint64_t& oldest = slots_[(slot_ + 1) % kSlots];
  window_ -= oldest;
  oldest = 0;
  ++slot_;
}

void LoadMeter::spend(std::uint64_t cycle, std::uint64_t busy) {
  busy += owed_;
  owed_ = 0;
  while (cycle / kSlot > slot_) {
    if (++closed_ >= kSlots) worst_ = std::max(worst_, window_);
    close_slot();
  }
  slots_[slot_ % kSlots] += busy;
  window_ += busy;
  busy_ += busy;
}

void LoadMeter::tick(std::uint64_t cycle) {
  if (last_tick_ != 0) {
    const std::uint64_t period = cycle - last_tick_;
    profile_.tick_period_min =
        profile_.ticks == 0 ? period : std::min(profile_.tick_period_min, period);
    profile_.tick_period_max = std::max(profile_.tick_period_max, period);
    ++profile_.ticks;
  }
  last_tick_ = cycle;
}

void LoadMeter::send(std::uint8_t byte, std::uint64_t cycle) {
  if (frame_tick_ == 0) frame_tick_ = last_tick_;
  if (byte != 0 || frame_tick_ == 0) return;
  const double delay = static_cast<double>(cycle - frame_tick_) / SimAvr::kFrequency;
  frame_tick_ = 0;
  profile_.state_delay_max = std::max(profile_.state_delay_max, delay);
  delay_sum_ += delay;
  ++delays_;
}

SimAvrProfile LoadMeter::profile(std::uint64_t cycle) const {
  SimAvrProfile done = profile_;
  if (cycle > begin_) done.mean_load = static_cast<double>(busy_) / (cycle - begin_);
  done.worst_load = static_cast<double>(worst_) / SimAvr::kTick;
  if (delays_ > 0) done.state_delay_mean = delay_sum_ / static_cast<double>(delays_);
  return done;
}

}  // namespace palpate
