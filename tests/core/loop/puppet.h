// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/tick/press_scene.h"
#include "palpate/sim/loop/loop.h"

namespace palpate::testing {

/// Follows a script; what else it does at a read is up to the test.
struct Puppet : HapticDevice {
  explicit Puppet(ScriptedDevice hand_in) : hand(std::move(hand_in)) {}
  HapticSample read(double time) noexcept override {
    times.push_back(time);
    HapticSample sample = hand.read(time);
    if (on_read) on_read(static_cast<int>(times.size()) - 1, sample);
    return sample;
  }
  void write(const HapticCommand& command) noexcept override { forces.push_back(command.force); }
  std::string name() const override { return "puppet"; }

  ScriptedDevice hand;
  std::vector<double> times;
  std::vector<Vec3> forces;
  void (*on_read)(int count, HapticSample& sample) = nullptr;
};

inline Puppet make_puppet(double depth = 0.004, double duration = 0.5) {
  Puppet puppet(press_script(depth, duration));
  puppet.times.reserve(20000);
  puppet.forces.reserve(20000);
  return puppet;
}

struct Taken {
  std::vector<TickLog::Tick> ticks;
  std::vector<Event> events;
  std::vector<StateHash> hashes;
  explicit Taken(TickLog& log) { log.take(ticks, events, hashes); }
  long count(EventKind kind) const {
    long sum = 0;
    for (const Event& event : events) {
      if (event.kind == kind) sum += kind == EventKind::missed_ticks ? event.index : 1;
    }
    return sum;
  }
};

inline void run(Loop& loop) {
  loop.start();
  while (!loop.wait(10.0)) {
  }
  loop.stop();
}

}  // namespace palpate::testing
