// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <cstring>

#include "my_device.h"
#include "palpate/sim/device/conformance.h"
#include "palpate/sim/device/safe_device.h"

/// Says of MyDevice what it keeps of what a device owes, bare and behind the safety wrapper.
/// With the word `live`, tick by tick in real time: hold the stylus.
int main(int count, char** words) {
  palpate::ConformanceOptions options;
  options.live = count > 1 && std::strcmp(words[1], "live") == 0;
  MyDevice device;
  palpate::SafeDevice safe(device, {.force_max = 3.0});
  bool passed = true;
  for (palpate::HapticDevice* one :
       {static_cast<palpate::HapticDevice*>(&device), static_cast<palpate::HapticDevice*>(&safe)}) {
    for (const palpate::DeviceCheck& check : palpate::check_conformance(*one, options)) {
      std::printf("%-6s %s: %s\n", check.passed ? "ok" : "FAILED", check.name.c_str(),
                  check.detail.c_str());
      passed = passed && check.passed;
    }
  }
  return passed ? 0 : 1;
}
