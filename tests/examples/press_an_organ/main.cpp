// SPDX-License-Identifier: BSD-3-Clause
// Presses a dome of tissue with the default tip, 1000 times a second, and prints what a hand feels.
#include <cstdio>

#include "palpate/sim/device/safe_device.h"
#include "palpate/sim/device/simulated_devices.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/tick/tick.h"

using namespace palpate;

int main() {
  constexpr int n = 21;  // vertices along a side of 10 cm; the dome is 3 cm high
  SurfaceMesh dome;
  for (int i = 0; i < n * n; ++i) {
    const double x = 0.1 * (i % n) / (n - 1) - 0.05, y = 0.1 * (i / n) / (n - 1) - 0.05;
    dome.vertices.emplace_back(x, y, 0.03 - 6.0 * (x * x + y * y));
    if (i % n == n - 1 || i / n == n - 1) continue;
    dome.triangles.push_back({i, i + 1, i + n + 1});
    dome.triangles.push_back({i, i + n + 1, i + n});
  }
  const Material wall{.wall_thickness = 0.004};
  const Scene scene = build_scene(make_scene(build_mass_spring(dome, wall, 600.0)));

  // from 5 mm above the top to 5 mm inside, in 2 s; a device of metal would stand in its place
  const double touch = 0.03 + scene.instruments[0].tool.radius;
  ScriptedDevice hand({{0.0, {0, 0, touch + 0.005}}, {2.0, {0, 0, touch - 0.005}}});
  SafeDevice device(hand);  // what any hand is to feel goes through its limits

  World world(scene);
  double hover = 0.0, deepest = 0.0;
  for (int i = 0; i <= 2000; ++i) {
    const HapticSample sample = device.read(i / scene.rate);
    device.write(tick(scene, sample, 1.0 / scene.rate, world));
    deepest = device.sent().force.z();
    if (i < 900) hover = std::max(hover, std::abs(deepest));
    if (i % 200 == 0)
      std::printf("hand at %6.2f mm: %7.4f N\n", 1e3 * sample.position.z(), deepest);
  }
  const bool holds = hover == 0.0 && deepest > 0.05 && deepest < 5.0 && !world.alarm &&
                     device.fault() == DeviceFault::none;
  std::puts(holds ? "nothing above the dome, a force inside it" : "this is not how tissue feels");
  return holds ? 0 : 1;
}
