// SPDX-License-Identifier: BSD-3-Clause
// Opens a published file, presses its highest point for 1000 ticks, and prints what a hand feels.
#include <cstdio>

#include "palpate/scenario/read.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/haptics/tick.h"

using namespace palpate;

namespace {

Vec3 find_highest(const Vec3Array& points) {
  Vec3 highest = points.front();
  for (const Vec3& point : points) {
    if (point.z() > highest.z()) highest = point;
  }
  return highest;
}

/// [m] Where the hand is at a tick: straight down on `top` from 2^-9 m (2 mm) above the touch to
/// as much below it in 512 ticks, and there it rests. Powers of two are exact in any arithmetic.
Vec3 follow_script(const Vec3& top, double radius, int tick) {
  const int way = tick < 512 ? 256 - tick : -256;
  return {top.x(), top.y(), (top.z() + radius) + way * 0x1p-17};
}

void play(const Scene& scene) {
  World world(scene);
  const Vec3 top = find_highest(scene.tissue.rest_position);
  for (int i = 0; i < 1000; ++i) {
    HapticSample hand;
    hand.time = i / scene.rate;
    hand.position = follow_script(top, scene.tool.radius, i);
    const Vec3 force = tick(scene, hand, 1.0 / scene.rate, world).force;
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
