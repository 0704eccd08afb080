// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/arm/device_bench.h"
#include "palpate/simavr/emulated_core.h"
#include "sim_bench.h"

namespace palpate {

/// The driver on the chip's image.
struct EmulatedBench : BenchOf<EmulatedCore> {
  explicit EmulatedBench(const Plant& plant = {}, const EmulatedCoreOptions& options = {})
      : BenchOf(image(options.baud), plant, options) {}

  void start() {
    BenchOf::start();
    REQUIRE(status().mode == DeviceMode::run);
  }
};

}  // namespace palpate
