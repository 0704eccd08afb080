// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/choose_substeps.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/dynamics/private/measure_stretch.h"
#include "palpate/sim/tick/private/linear_tick.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// The share of the stability limit that a tick with contact uses: the row-sum bound looks at the
/// start of the tick, and contacts grow within it.
constexpr double kStepShare = 0.75;

/// Substeps that contact has at least: with one, the three Newton steps of the tool are all there
/// are in a tick, and what they leave over lags behind the tissue and feeds it energy.
constexpr double kFewestInContact = 3.0;

/// How far a particle may go in one substep, in shortest links; the guard's own [motion: alarm].
constexpr double kLongestMove = 0.3;

/// A tissue that is this much stiffer gets other substeps: 0.9² of stable_step() has room for it.
constexpr double kStiffening = 1.2;

/// [s] The longest stable step where w² [1/s²] and c [1/s] are the largest eigenvalues of M⁻¹K and
/// M⁻¹C:
///
///     dt <= (sqrt(c² + 4 w²) - c) / w²
///
/// which is 2/w (sqrt(1 + z²) - z) with z = c/(2w) [motion: step].
double find_limit(double w2, double c) noexcept { return (std::sqrt(c * c + 4.0 * w2) - c) / w2; }

/// Takes note of a tissue that stretch has made stiffer, or that has come back.
void follow_stretch(const Stretch& stretch, WorldInternals& work) noexcept {
  const double now = bound_stiffness(work.spectrum, stretch), rest = work.spectrum.rest;
  if (now > kStiffening * work.chosen_stiffness) work.chosen_stiffness = now;
  if (now * kStiffening < work.chosen_stiffness) {
    work.chosen_stiffness = now > kStiffening * rest ? now : rest;
  }
}

/// Substeps in the air: the scene's own at rest, more by as much as the limit has come down. At
/// rest dt/stable_step() of them are needed, of which scene.substeps is the next whole number.
double count_free_substeps(const Scene& scene, double dt, const WorldInternals& work) noexcept {
  const double fewest = scene.substeps, rest = work.spectrum.rest;
  if (!(work.chosen_stiffness > rest)) return fewest;
  const double c = scene.spectrum_damping;
  const double limit = find_limit(work.chosen_stiffness, c);
  if (!(rest > 0.0)) return std::max(fewest, std::ceil(dt / (kStepShare * limit)));
  const double rest_limit = find_limit(rest, c);
  const double needed = std::min(fewest, dt / (kStepShare * rest_limit));
  return std::max(fewest, std::ceil(needed * rest_limit / limit));
}

/// How many substeps contact asks for to be stable, with the contacts' part k/m of the spectrum:
/// w² <= w0² + max k/m.
double count_stable_substeps(const Scene& scene, double dt, World& world) noexcept {
  WorldInternals& work = internals(world);
  const double contact = bound_contact_stiffness(
      scene.tool, world.candidates, scene.tissue.triangles, surface_position(world),
      work.surface_mass, world.tool, work.vertex_scratch);
  if (!(contact > 0.0)) return 1.0;
  const double limit = find_limit(work.chosen_stiffness + contact, scene.spectrum_damping);
  return std::ceil(dt / (kStepShare * limit));
}

/// How many substeps an impact asks for: a particle far lighter than the hand leaves it at up to
/// twice its speed, more where neighbours push with it, and must not fly past them in one substep.
double count_impact_substeps(double travel, const World& world) noexcept {
  return std::ceil(3.0 * travel / (kLongestMove * world.guard.shortest_rest_length));
}

}  // namespace

/// Near the tissue substeps only rise: a step that is long while a contact closes and short while
/// it opens, or the other way round, is no longer symplectic and pumps a bouncing contact up. They
/// are taken back one by one once the tool is away, while the tissue calms.
int choose_substeps(const Scene& scene, double travel, double dt, World& world) noexcept {
  WorldInternals& work = internals(world);
  if (const ResponseKernel* kernel = find_response(world)) {
    return count_linear_substeps(scene, travel, dt, *kernel, world);
  }
  follow_stretch(world.stretch, work);
  const double fewest = count_free_substeps(scene, dt, work);
  double wanted = std::max(fewest, double(world.substeps - 1));
  if (world.candidates.count > 0 || world.tool.hold_count > 0) {
    wanted =
        std::max({kFewestInContact, fewest, static_cast<double>(world.substeps),
                  count_stable_substeps(scene, dt, world), count_impact_substeps(travel, world)});
  }
  return static_cast<int>(std::clamp(wanted, double(scene.substeps), double(scene.substeps_max)));
}

}  // namespace palpate
