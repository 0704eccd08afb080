// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <utility>

#include "palpate/sim/device/device.h"

namespace palpate {

/// A hand that is where, and turned as, a function of the time [s] says.
class TurningHand : public HapticDevice {
 public:
  explicit TurningHand(std::function<HapticSample(double)> move) : move_(std::move(move)) {}

  HapticSample read(double time) noexcept override {
    HapticSample sample = move_(time);
    sample.time = time;
    return sample;
  }
  void write(const HapticCommand&) noexcept override {}
  std::string name() const override { return "turning hand"; }

 private:
  std::function<HapticSample(double)> move_;
};

}  // namespace palpate
