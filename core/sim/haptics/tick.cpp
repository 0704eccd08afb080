// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/haptics/tick.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/haptics/place_tool.h"

namespace palpate {
namespace {

/// The share of the stability limit that a tick with contact uses: the row-sum bound looks at the
/// start of the tick, and contacts grow within it.
constexpr double kStepShare = 0.75;

/// How many substeps contact asks for in this tick. With the contacts' part k/m of the spectrum,
///
///     w^2 <= w0^2 + max k/m,   dt <= 0.75 (sqrt(c^2 + 4 w^2) - c) / w^2
///
/// which is 2/w (sqrt(1 + z^2) - z) with z = c/(2w): TOOLS section 1, SCIENCE section 3.
int choose_substeps(const Scene& scene, double dt, World& world) noexcept {
  const double contact =
      bound_contact_stiffness(scene.tool, world.candidates, scene.tissue.triangles,
                              world.tissue.position, scene.tissue.mass, world.tool, world.scratch);
  if (!(contact > 0.0)) return scene.substeps;
  const double w2 = scene.spectrum_stiffness + contact;
  const double c = scene.spectrum_damping;
  const double limit = (std::sqrt(c * c + 4.0 * w2) - c) / w2;
  const double wanted = std::ceil(dt / (kStepShare * limit));
  return static_cast<int>(std::clamp(wanted, double(scene.substeps), double(scene.substeps_max)));
}

/// Attaches when the button goes down, releases when it comes up.
void follow_button(const Scene& scene, std::uint8_t buttons, World& world) noexcept {
  const bool pressed = (buttons & kAttachButton) != 0;
  if (pressed && !world.attach_pressed) {
    attach_tool(world.load, scene.tissue.triangles, world.tissue.position, scene.hold_stiffness,
                world.tool);
  } else if (!pressed && world.attach_pressed) {
    release_tool(world.tool);
  }
  world.attach_pressed = pressed;
}

/// [W] what the pushes do to the tissue at velocities v; times the substep it is their work to the
/// last bit, because symplectic Euler moves particles with the new velocity.
double compute_push_power(std::span<const Push> pushes, std::span<const Triangle> triangles,
                          std::span<const Vec3> v) noexcept {
  double power = 0.0;
  for (const Push& push : pushes) {
    const auto& [i, j, k] = triangles[static_cast<std::size_t>(push.triangle)];
    const Vec3 patch = push.weights[0] * v[i] + push.weights[1] * v[j] + push.weights[2] * v[k];
    power += push.force.dot(patch);
  }
  return power;
}

}  // namespace

HapticCommand tick(const Scene& scene, const HapticSample& sample, double dt,
                   World& world) noexcept {
  ++world.tick_count;
  if (world.alarm) return {};

  State& tissue = world.tissue;
  world.tree.refit(tissue.position);
  if (place_tool(world.tree, tissue.position, sample.position, world.tool)) {
    find_candidates(world.tree, tissue.position, scene.tool, world.tool.position, sample.position,
                    scene.rest_areas, world.candidates);
    follow_button(scene, sample.buttons, world);
  }
  world.substeps = choose_substeps(scene, dt, world);
  const double substep = dt / world.substeps;

  // Which triangles may be touched is settled once per tick. Where and how hard they are touched
  // changes with every substep: held over the tick, it would buzz on the hand and diverge.
  Vec3 felt = Vec3::Zero();
  double work = 0.0;
  for (int s = 0; s < world.substeps; ++s) {
    if (world.tool.placed) {
      felt += balance_tool(scene.tool, scene.coupling, sample.position, world.candidates,
                           scene.tissue.triangles, tissue.position, world.tool, world.load);
    }
    step(scene.tissue, world.load, substep, tissue);
    work +=
        substep * compute_push_power(world.load.pushes(), scene.tissue.triangles, tissue.velocity);
  }
  world.alarm = check(scene.tissue, scene.gravity, tissue, work, world.guard);
  if (world.alarm) return {};
  return {.force = felt / world.substeps};
}

Felt compute_felt(const HapticCommand& command, const World& world) noexcept {
  Felt felt;
  felt.force = command.force.cast<float>();
  felt.position = world.tool.position.cast<float>();
  felt.touched = static_cast<std::uint8_t>((world.tool.touching ? 1 : 0) |
                                           (world.tool.hold_count > 0 ? 2 : 0));
  return felt;
}

}  // namespace palpate
