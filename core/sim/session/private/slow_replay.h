// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "palpate/sim/multirate/private/exchange.h"
#include "palpate/sim/session/record.h"

namespace palpate {

/// A recorded run of a scene with an exchange_rate: what the tissue told is taken up in the ticks
/// in which the live loop took it up, however long either needs.
class SlowReplay {
 public:
  /// Throws std::invalid_argument for exchanges that no run of the scene has.
  SlowReplay(const Scene& scene, const Record& record);

  /// In the place of tick(); `shown` as the live loop has it (TissueWorker::tick).
  void tick(std::span<const HapticSample> samples, World& shown, std::span<HapticCommand> commands);
  const World& world() const noexcept { return slow_.world(); }  ///< of the tissue

 private:
  const Scene& scene_;
  SlowSide slow_;
  Exchange exchange_;
  FastSide fast_;
  std::vector<std::int64_t> taken_at_;  // tick of every exchange
  std::size_t next_ = 0;
};

}  // namespace palpate
