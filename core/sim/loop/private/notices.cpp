// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "palpate/sim/loop/private/loop_impl.h"

namespace palpate {

void Loop::Impl::notice_holds(long number) noexcept {
  for (std::size_t i = 0; i < held.size(); ++i) {
    const int now = count_held(world.instruments[i].tool);
    const auto instrument = static_cast<std::int32_t>(i);
    if (held[i] == 0 && now > 0) tell(number, EventKind::attached, now, 0.0, instrument);
    if (held[i] > 0 && now == 0) tell(number, EventKind::released, held[i], 0.0, instrument);
  }
}

void Loop::Impl::notice_safeguards(long number) noexcept {
  bool any = false;
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    const SoftState& body = world.bodies[b];
    any = any || body.safeguard != Safeguard::none;
    if (body.safeguard == safeguards[b]) continue;
    const bool averts = body.safeguard > safeguards[b];
    safeguards[b] = body.safeguard;
    if (averts && !world.alarm && !has_averted.load(std::memory_order_relaxed)) {
      averted = body.averted;
      averted_body = static_cast<int>(b);
      has_averted.store(true, std::memory_order_release);
    }
    tell(number, EventKind::safeguard, static_cast<std::int32_t>(body.safeguard),
         averts ? static_cast<double>(body.averted.kind) : 0.0, static_cast<std::int32_t>(b));
  }
  if (any && !world.alarm) safeguarded.fetch_add(1, std::memory_order_relaxed);
}

void Loop::Impl::notice_alarm(long number) noexcept {
  if (!world.alarm || has_alarm.load(std::memory_order_relaxed)) return;
  alarm = world.alarm;
  alarm_body = world.alarm_body;
  has_alarm.store(true, std::memory_order_release);
  tell(number, EventKind::alarm, static_cast<std::int32_t>(alarm.kind), alarm.value,
       std::max(alarm_body, 0));
}

void Loop::Impl::notice_devices(long number) noexcept {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    channels[i]->notice(number, static_cast<int>(i), log);
    channels[i]->notice_damping(number, static_cast<int>(i), log);
  }
}

/// What bounds the hand's springs is told in the first tick, before which a replay takes it over.
void Loop::Impl::notice_couplings(long number) noexcept {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const DeviceCoupling& device = world.instruments[i].device;
    const auto instrument = static_cast<std::int32_t>(i);
    if (number == 0 && device.passive_stiffness > 0.0) {
      tell(number, EventKind::coupling_limited, channels[i]->delay_us(), device.passive_stiffness,
           instrument);
    }
    if (device.follows_tissue == bool(follows[i])) continue;
    follows[i] = device.follows_tissue;
    tell(number, EventKind::coupling_follows, follows[i], device.tissue, instrument);
  }
}

}  // namespace palpate
