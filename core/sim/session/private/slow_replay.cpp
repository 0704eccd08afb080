// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/session/private/slow_replay.h"

#include "palpate/sim/base/private/refuse.h"

namespace palpate {
namespace {

/// The tissue is told of the hands in the first tick, and again whenever it has answered.
std::vector<std::int64_t> list_exchanges(const Record& record, int ticks) {
  std::vector<std::int64_t> taken;
  std::int64_t last = 0;
  for (const Event& event : record.events) {
    if (event.kind != EventKind::tissue_exchanged) continue;
    if (event.tick - event.index != last || event.index < ticks) {
      refuse(write_text("replay: tissue exchanged at tick ", event.tick),
             write_text(event.index, " ticks after its hands were told"),
             write_text(event.tick - last, ", since the exchange before it, and no fewer than ",
                        ticks));
    }
    taken.push_back(last = event.tick);
  }
  return taken;
}

}  // namespace

SlowReplay::SlowReplay(const Scene& scene, const Record& record)
    : scene_(scene),
      slow_(scene, count_exchange_ticks(scene)),
      exchange_(slow_.world()),
      fast_(scene, LocalForceMode::local_stiffness, 1.0 / scene.rate, count_exchange_ticks(scene)),
      taken_at_(list_exchanges(record, count_exchange_ticks(scene))) {}

void SlowReplay::tick(std::span<const HapticSample> samples, World& shown,
                      std::span<HapticCommand> commands) {
  if (shown.tick_count == 0) {
    for (std::size_t i = 0; i < shown.instruments.size(); ++i) {
      fast_.set_passive_stiffness(i, shown.instruments[i].device.passive_stiffness);
    }
  }
  fast_.follow(samples);
  const bool takes = next_ < taken_at_.size() && taken_at_[next_] == shown.tick_count;
  if (takes) {
    slow_.follow(exchange_);
    fast_.take(exchange_);
    show_exchange(exchange_, shown);
    ++next_;
  }
  if (takes || !fast_.has_told()) fast_.tell(exchange_);
  fast_.render(commands);
  show_tick(fast_, scene_, commands, shown);
}

}  // namespace palpate
