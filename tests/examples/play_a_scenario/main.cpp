// SPDX-License-Identifier: BSD-3-Clause
// Opens a published file, presses its highest point for 1000 ticks, and prints what a hand feels.
#include <cmath>
#include <cstdio>

#include "palpate/scenario/read.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/device/safe_device.h"
#include "palpate/sim/tick/tick.h"

using namespace palpate;

namespace {

Vec3 find_highest(const Vec3Array& points) {
  Vec3 highest = points.front();
  for (const Vec3& point : points) {
    if (point.z() > highest.z()) highest = point;
  }
  return highest;
}

/// A hand that goes straight down on `top` from 2^-9 m (2 mm) above the touch to as much below it
/// in 512 ticks, and there it rests. Powers of two are exact in any arithmetic.
class ScriptedHand : public HapticDevice {
 public:
  ScriptedHand(const Vec3& top, double radius, double rate)
      : touch_(top.x(), top.y(), top.z() + radius), rate_(rate) {}

  HapticSample read(double time) noexcept override {
    const long tick = std::lround(time * rate_);
    const long step = tick < 512 ? 256 - tick : -256;
    HapticSample sample;
    sample.time = time;
    sample.position = touch_ + Vec3(0.0, 0.0, double(step) * 0x1p-17);
    return sample;
  }
  void write(const HapticCommand&) noexcept override {}
  std::string name() const override { return "scripted hand"; }

 private:
  const Vec3 touch_;   // [m]
  const double rate_;  // [Hz]
};

void play(const Scene& scene) {
  World world(scene);
  ScriptedHand hand(find_highest(scene.bodies[0].tissue.rest_position),
                    scene.instruments[0].tool.radius, scene.rate);
  SafeDevice device(hand);  // ramp, slew and energy limits stand between a tick and any device
  for (int i = 0; i < 1000; ++i) {
    const HapticSample sample = device.read(i / scene.rate);
    const HapticCommand command = tick(scene, sample, 1.0 / scene.rate, world);
    device.write(command);
    const Vec3& force = command.force;
    std::printf("%a %a %a\n", force.x(), force.y(), force.z());  // %a shows every bit
  }
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fputs("usage: play_a_scenario FILE.palpate\n", stderr);
    return 2;
  }
  try {
    const scenario::Scenario opened = scenario::read(words[1]);
    std::fprintf(stderr, "%s: %s\n", opened.title.c_str(), opened.task.c_str());
    play(opened.scene);
  } catch (const FileError& refused) {
    std::fprintf(stderr, "%s\n", refused.what());
    return 1;
  }
}
