// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/choose_substeps.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/dynamics/private/measure_stretch.h"
#include "palpate/sim/dynamics/private/step_limit.h"
#include "palpate/sim/grasp/private/jaws.h"
#include "palpate/sim/tick/private/linear_tick.h"
#include "palpate/sim/tick/private/safeguard.h"
#include "palpate/sim/tick/private/touch_bodies.h"
#include "palpate/sim/tick/private/touch_rigid.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// The share of the stability limit that a tick with contact uses: the row-sum bound looks at the
/// start of the tick, and contacts grow within it.
constexpr double kStepShare = 0.75;

/// How many times as stiff as told at its start contacts may become within a tick: what the step
/// share above leaves them where nothing else is in a step, and the tissue its own share besides.
constexpr double kContactGrowth = kLimitShare * kLimitShare / (kStepShare * kStepShare);

/// Substeps that contact has at least: with one, the three Newton steps of the tool are all there
/// are in a tick, and what they leave over lags behind the tissue and feeds it energy.
constexpr double kFewestInContact = 3.0;

/// How far a particle may go in one substep, in shortest links; the guard's own [motion: alarm].
constexpr double kLongestMove = 0.3;

/// [s] What jaws hold stays near for minutes, and organs lie on each other: of substeps that are no
/// longer asked for one is taken back each time, so slowly that no contact is pumped up.
constexpr double kEased = 0.02;

/// Substeps that instruments on a solid under a skin may ask for at most. The particles under a
/// skin are heavy, none flies past an instrument in a substep as those of a membrane do, for which
/// there may be more; and what jaws squeeze, or a shaft lies along, is as stiff as its bound says
/// for its own small motions alone.
constexpr double kMostOnSkin = 8.0;

/// A tissue that is this much stiffer gets other substeps: 0.9² of stable_step() has room for it.
constexpr double kStiffening = 1.2;

/// [s] Of symplectic Euler with implicit damping where `added` [1/s²], which nothing damps, comes
/// to the tissue's w². With the limit dt0 of the tissue alone and s dt0 that of both,
/// dt² K - 2 dt C <= 4 s, and dt² `added` takes the rest:
///
///     4 s + s² dt0² added <= 4
///
/// and with the least damping time t, C >= t K: dt² (w² + added) - 2 dt t w² <= 4, and not beyond
/// 2/sqrt(added), where the softest has no room left. Each is enough, so the longer one holds.
double find_limit_with_implicit_damping(const SoftBody& body, double added) noexcept {
  const double dt0 = body.damped_limit, w2 = body.spectrum_stiffness + added;
  if (!(added > 0.0) || !(w2 > 0.0)) return dt0;
  if (!std::isfinite(dt0)) return 2.0 / std::sqrt(added);
  const double damped_part = body.spectrum_stiffness / w2;
  const double by_time = find_step_limit(body.integrator, {w2, body.spectrum_damping},
                                         damped_part * body.least_damping_time);
  return std::max(2.0 * dt0 / (1.0 + std::sqrt(1.0 + dt0 * dt0 * added)),
                  std::min(by_time, 2.0 / std::sqrt(added)));
}

/// [s] The longest stable step where w² [1/s²] and c [1/s] are the largest eigenvalues of M⁻¹K and
/// M⁻¹C:
///
///     dt <= (sqrt(c² + 4 w²) - c) / w²
///
/// which is 2/w (sqrt(1 + z²) - z) with z = c/(2w) [motion: step], and of other integrators what
/// they have. What makes a tissue stiffer than at rest damps it no more.
double find_limit(const SoftBody& body, double w2) noexcept {
  const double c = body.spectrum_damping;
  if (body.integrator == Integrator::symplectic_euler) {
    return (std::sqrt(c * c + 4.0 * w2) - c) / w2;
  }
  if (body.integrator == Integrator::symplectic_euler_implicit_damping) {
    return find_limit_with_implicit_damping(body, w2 - body.spectrum_stiffness);
  }
  const double damped_part = std::min(1.0, body.spectrum_stiffness / w2);
  return find_step_limit(body.integrator, {w2, c}, damped_part * body.least_damping_time);
}

/// Takes note of a tissue that stretch has made stiffer, or that has come back.
void follow_stretch(const Stretch& stretch, BodyInternals& work) noexcept {
  const double now = bound_stiffness(work.spectrum, stretch), rest = work.spectrum.rest;
  if (now > kStiffening * work.chosen_stiffness) work.chosen_stiffness = now;
  if (now * kStiffening < work.chosen_stiffness) {
    work.chosen_stiffness = now > kStiffening * rest ? now : rest;
  }
}

/// Substeps in the air: the body's own at rest, more by as much as the limit has come down. What it
/// has beyond steps of kStepShare of its limit at rest is room for that.
double count_free_substeps(const SoftBody& body, double dt, const BodyInternals& work) noexcept {
  const double fewest = body.substeps, rest = work.spectrum.rest;
  if (!(work.chosen_stiffness > rest) || is_implicit(body.integrator)) return fewest;
  const double limit = find_limit(body, work.chosen_stiffness);
  if (!(rest > 0.0)) return std::max(fewest, std::ceil(dt / (kStepShare * limit)));
  const double rest_limit = find_limit(body, rest);
  const double needed = std::min(fewest, dt / (kStepShare * rest_limit));
  return std::max(fewest, std::ceil(needed * rest_limit / limit));
}

/// Jaws on a body under a skin count by its particles, all else by vertices.
bool counts_by_particles(const Scene& scene, std::size_t instrument, std::size_t body) noexcept {
  return scene.instruments[instrument].tool.jaws && !scene.bodies[body].tissue.skin.corners.empty();
}

/// [1/s²] The largest row of the sum of what the instruments add to vertices.
double bound_by_vertices(const Scene& scene, std::size_t body, World& world) noexcept {
  BodyInternals& work = internals(world.bodies[body]);
  ContactRows rows{work.surface_mass, work.vertex_scratch};
  const auto for_each_part = [&](auto take) noexcept {
    for (std::size_t i = 0; i < world.instruments.size(); ++i) {
      if (counts_by_particles(scene, i, body)) continue;
      const std::size_t parts = scene.instruments[i].tool.jaws ? 2 : 1;
      for (std::size_t part = 0; part < parts; ++part) take(i, part);
    }
  };
  for_each_part([&](std::size_t i, std::size_t part) noexcept {
    add_rows(scene, i, part, body, rows, world);
  });
  for_each_part([&](std::size_t i, std::size_t part) noexcept {
    for_each_row(part == 0, find_touchable_part(scene, i, part, body, world),
                 world.instruments[i].tool,
                 [&](int v) noexcept { rows.sums[static_cast<std::size_t>(v)] = 0.0; });
  });
  return rows.largest;
}

/// [1/s²] The same of particles.
double bound_by_particles(const Scene& scene, std::size_t body, World& world) noexcept {
  const std::span<double> sums = internals(world.bodies[body]).vertex_scratch;
  ParticleRows rows{scene.bodies[body].tissue, sums};
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    if (!counts_by_particles(scene, i, body)) continue;
    add_jaws_on_skin(scene.instruments[i].tool, list_jaw_surfaces(scene, i, world),
                     static_cast<int>(body), world.instruments[i].tool, rows);
  }
  if (rows.largest > 0.0) std::ranges::fill(sums, 0.0);
  return rows.largest;
}

/// How many substeps contact asks for to be stable, with the contacts' part k/m of the spectrum:
/// w² <= w0² + max k/m, of all instruments together, and with what other bodies add. An implicit
/// step leaves them only the contacts: of x'' - 2 x' + x + a x'' + b x' = 0, with a of the tissue
/// and b of the contacts, b <= 4 + a is asked for.
///
/// With the share s of a step for the tissue and s' for contacts, which grow within a tick,
///
///     dt² w0²/s² + dt² (k/m)/s'² <= 4
///
/// is asked for of jaws alone on a wall. Of a solid it is too little, whose jaws then buzz, and of
/// all else s' is the share of both.
double count_stable_substeps(const Scene& scene, std::size_t body, double dt, bool jaws_on_wall,
                             World& world) noexcept {
  const SoftBody& soft = scene.bodies[body];
  BodyInternals& work = internals(world.bodies[body]);
  const double contact = bound_touch_stiffness(body, world) + bound_rigid_stiffness(body, world) +
                         bound_by_vertices(scene, body, world) +
                         bound_by_particles(scene, body, world);
  work.contact_stiffness = contact;
  if (!(contact > 0.0)) return 1.0;
  // no integrator bears more of what is told at the start of a step [motion: integrators]
  double step = kStepShare * (2.0 / std::sqrt(contact));
  if (!is_implicit(soft.integrator)) {
    const double share = jaws_on_wall ? kLimitShare : kStepShare;
    const double growth = jaws_on_wall ? kContactGrowth : 1.0;
    step = std::min(step, share * find_limit(soft, work.chosen_stiffness + growth * contact));
  }
  return std::ceil(dt / step);
}

/// How many substeps an impact asks for: a particle far lighter than the hand leaves it at up to
/// twice its speed, more where neighbours push with it, and must not fly past them in one substep.
double count_impact_substeps(double travel, const SoftState& state) noexcept {
  return std::ceil(3.0 * travel / (kLongestMove * state.guard.shortest_rest_length));
}

/// The smallest divisor of `finest` that is at least `wanted`.
int find_divisor(int finest, int wanted) noexcept {
  for (int n = wanted; n < finest; ++n) {
    if (finest % n == 0) return n;
  }
  return finest;
}

}  // namespace

TouchableSurface find_touchable_part(const Scene& scene, std::size_t instrument, std::size_t part,
                                     std::size_t body, World& world) noexcept {
  const SoftBody& soft = scene.bodies[body];
  return {part == 0 ? world.pair(instrument, body).candidates : second_jaw(world, instrument, body),
          soft.tissue.triangles,
          surface_position(world.bodies[body]),
          find_near_field(scene.instruments[instrument].tool, soft),
          static_cast<int>(body),
          find_friction_part(scene.instruments[instrument], body)};
}

void add_rows(const Scene& scene, std::size_t instrument, std::size_t part, std::size_t body,
              ContactRows& rows, World& world) noexcept {
  const Instrument& its = scene.instruments[instrument];
  const ToolState& tool = world.instruments[instrument].tool;
  const TouchableSurface surface = find_touchable_part(scene, instrument, part, body, world);
  if (its.tool.jaws) {
    add_jaw_rows(its.tool, static_cast<int>(part), surface, tool, its.coupling.stiffness, rows);
  } else {
    const Shape shape{its.tool, Axes(its.tool, tool.orientation)};
    add_shape_rows(shape, true, surface, tool, its.coupling.stiffness, rows);
  }
}

bool is_near(World& world, std::size_t instrument, std::size_t body) noexcept {
  if (world.pair(instrument, body).candidates.count > 0) return true;
  if (second_jaw(world, instrument, body).count > 0) return true;
  const ToolState& tool = world.instruments[instrument].tool;
  for (int k = 0; k < tool.anchor_count; ++k) {
    if (tool.anchors[static_cast<std::size_t>(k)].body == static_cast<int>(body)) return true;
  }
  for (int h = 0; h < tool.hold_count; ++h) {
    if (tool.holds[static_cast<std::size_t>(h)].body == static_cast<int>(body)) return true;
  }
  return false;
}

/// The substeps of the tick before; near jaws and other bodies alone one less every 20 ms.
double keep_substeps(bool near_jaws, double dt, long tick, const BodyInternals& work) noexcept {
  const long ticks = std::max(1L, std::lround(kEased / dt));
  return work.wanted_substeps - (near_jaws && tick % ticks == 0 ? 1.0 : 0.0);
}

/// Near the tissue substeps only rise: a step that is long while a contact closes and short while
/// it opens, or the other way round, is no longer symplectic and pumps a bouncing contact up. They
/// are taken back one by one once the tool is away, while the tissue calms.
int count_substeps(const Scene& scene, std::size_t body, double dt, World& world) noexcept {
  const SoftBody& soft = scene.bodies[body];
  SoftState& state = world.bodies[body];
  BodyInternals& work = internals(state);
  if (const ResponseKernel* kernel = find_response(state)) {
    return count_linear_substeps(scene, body, dt, *kernel, world);
  }
  follow_stretch(state.stretch, work);
  work.volume_before = state.stretch.smallest_volume;
  work.contact_stiffness = 0.0;
  bool near = false, near_jaws = true;
  double travel = 0.0;
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    if (!is_near(world, i, body)) continue;
    near = true;
    near_jaws = near_jaws && scene.instruments[i].tool.jaws;
    travel = std::max(travel, workspace(world).hands[i].travel);
  }
  const double fewest = count_free_substeps(soft, dt, work);
  const bool jaws_on_wall = near && near_jaws && is_wall(soft.tissue) &&
                            !is_rigid_near(body, world) && !is_touched(body, world);
  double wanted = std::max(fewest, double(work.wanted_substeps - 1));
  if (near) {
    wanted =
        std::max({kFewestInContact, fewest, keep_substeps(near_jaws, dt, world.tick_count, work),
                  count_stable_substeps(scene, body, dt, jaws_on_wall, world),
                  count_impact_substeps(travel, state)});
  }
  if (is_rigid_near(body, world)) {
    wanted =
        std::max({wanted, kFewestInContact, fewest, keep_substeps(true, dt, world.tick_count, work),
                  count_stable_substeps(scene, body, dt, jaws_on_wall, world)});
  }
  if (is_touched(body, world)) {
    wanted = std::max({wanted, fewest, keep_substeps(true, dt, world.tick_count, work),
                       count_stable_substeps(scene, body, dt, jaws_on_wall, world),
                       count_approach_substeps(body, world)});
  }
  double most = soft.substeps_max;
  const bool alone = (near || is_rigid_near(body, world)) && !is_touched(body, world);
  if (alone && !soft.tissue.skin.corners.empty()) {
    most =
        std::clamp(std::max(kMostOnSkin, 4.0 / 3.0 * soft.substeps), double(soft.substeps), most);
  }
  return static_cast<int>(std::clamp(wanted, double(soft.substeps), most));
}

void make_divisors(std::span<const double> cost, std::span<int> substeps) noexcept {
  const int most = *std::ranges::max_element(substeps);
  const auto sum_up = [&](int finest) noexcept {
    double sum = 0.0;
    for (std::size_t b = 0; b < substeps.size(); ++b) {
      sum += cost[b] * find_divisor(finest, substeps[b]);
    }
    return sum;
  };
  // nothing costs less than what the bodies ask for, which equal bodies get at once
  double asked = 0.0;
  for (std::size_t b = 0; b < substeps.size(); ++b) asked += cost[b] * substeps[b];
  int best = most;
  double least = sum_up(most);
  for (int finest = most + 1; finest <= most + most / 4 && least > asked; ++finest) {
    if (const double sum = sum_up(finest); sum < least) {
      least = sum;
      best = finest;
    }
  }
  for (int& n : substeps) n = find_divisor(best, n);
}

int choose_substeps(const Scene& scene, double dt, World& world) noexcept {
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    internals(world.bodies[b]).wanted_substeps = count_substeps(scene, b, dt, world);
  }
  return fit_substeps(scene, world);
}

int fit_substeps(const Scene& scene, World& world) noexcept {
  TickBuffers& work = workspace(world);
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    const SoftState& state = world.bodies[b];
    work.wanted[b] = refine(scene.bodies[b], state.safeguard, internals(state).wanted_substeps);
    work.cost[b] = static_cast<double>(scene.bodies[b].tissue.rest_position.size());
  }
  if (world.bodies.size() > 1) make_divisors(work.cost, work.wanted);
  for (std::size_t b = 0; b < world.bodies.size(); ++b) world.bodies[b].substeps = work.wanted[b];
  return refine_for_rigid(scene, *std::ranges::max_element(work.wanted), world);
}

}  // namespace palpate
