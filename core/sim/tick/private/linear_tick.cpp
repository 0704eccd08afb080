// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/linear_tick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/dynamics/private/alarms.h"
#include "palpate/sim/grasp/private/jaws.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/response/private/relax.h"
#include "palpate/sim/tick/private/choose_substeps.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {
namespace {

/// [m] by which a ray through the tissue begins below the surface.
constexpr double kBelow = 1e-5;

/// Substeps in contact: what three Newton steps of the tool leave over shall not lag
/// (choose_substeps).
constexpr double kFewestInContact = 3.0;

/// Substeps in which the hand comes as far as the tool's radius.
constexpr double kSubstepsPerRadius = 8.0;

/// Ticks in a row in which a press must be too deep: as many as for any strain (guard.cpp).
constexpr int kDeepChecks = 10;

Vec3Array compute_normals(const TissueModel& tissue, const Vec3Array& x) {
  Vec3Array normals(x.size(), Vec3::Zero());
  for (const auto& [a, b, c] : tissue.triangles) {
    const Vec3 normal = (x[b] - x[a]).cross(x[c] - x[a]);
    normals[a] += normal;
    normals[b] += normal;
    normals[c] += normal;
  }
  for (Vec3& normal : normals) normal.normalize();
  return normals;
}

/// [-] How many times as stiff as the tissue the contacts are, from above: with K_c = sum of
/// k_t w_t w_tᵀ over contacts and holds, the largest eigenvalue of G K_c is at most its trace, and
/// that at most the sum of k_t w_tv c_v over vertices, c_v their own compliance, for w_t sums to 1.
double bound_contact_share(const Scene& scene, std::size_t body, const ResponseKernel& kernel,
                           World& world) noexcept {
  BodyInternals& work = internals(world.bodies[body]);
  double sum = 0.0;
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    const std::size_t parts = scene.instruments[i].tool.jaws ? 2 : 1;
    for (std::size_t part = 0; part < parts; ++part) {
      ContactRows rows{work.surface_mass, work.vertex_scratch};
      add_rows(scene, i, part, body, rows, world);
      for_each_row(part == 0, find_touchable_part(scene, i, part, body, world),
                   world.instruments[i].tool, [&](int vertex) noexcept {
                     double& row = rows.sums[static_cast<std::size_t>(vertex)];
                     sum +=
                         row * kernel.response->self_compliance[static_cast<std::size_t>(vertex)];
                     row = 0.0;
                   });
    }
  }
  return sum;
}

/// The tissue goes the share s of the path to where the pushes hold it, while these take back up to
/// k of what it goes: stable below s = 2/(1 + k), and without overshoot up to 1/(1 + k). Where
/// that is less than damping asks for, there is more damping.
double choose_share(double dt, double contact, double damping_time) noexcept {
  const double damped = damping_time > 0.0 ? 1.0 - std::exp(-dt / damping_time) : 1.0;
  return std::min(damped, 1.0 / (1.0 + contact));
}

/// [m] of a vertex of the surface from where it was at rest.
double measure_displacement(const TissueModel& tissue, const SoftState& state,
                            int vertex) noexcept {
  const auto v = static_cast<std::size_t>(vertex);
  const Vec3Array& rest = tissue.rest_position;
  if (tissue.skin.corners.empty()) return (state.tissue.position[v] - rest[v]).norm();
  const auto& [a, b, c, d] = tissue.skin.corners[v];
  const auto& w = tissue.skin.weights[v];
  return (state.skin[v] - (w[0] * rest[a] + w[1] * rest[b] + w[2] * rest[c] + w[3] * rest[d]))
      .norm();
}

/// What is pushed farthest of where it may be, farther than `worst` [-] of that.
Alarm find_deepest(const SoftBody& body, const ResponseKernel& kernel, const SoftState& state,
                   double worst) noexcept {
  Alarm alarm;
  for (const Push& push : state.load.pushes()) {
    for (const int v : body.tissue.triangles[static_cast<std::size_t>(push.triangle)]) {
      const double displacement = measure_displacement(body.tissue, state, v);
      const double limit = kernel.deepest[static_cast<std::size_t>(v)];
      if (!(displacement > worst * limit)) continue;
      worst = displacement / limit;
      alarm = {AlarmKind::pressed_deep, v, displacement, limit};
    }
  }
  return alarm;
}

/// An instrument lets go of the body.
bool is_released(const World& world, std::size_t body) noexcept {
  for (const InstrumentState& instrument : world.instruments) {
    if (instrument.release_ticks == 0) continue;
    for (int h = 0; h < instrument.tool.hold_count; ++h) {
      const ToolState::Hold& hold = instrument.tool.holds[static_cast<std::size_t>(h)];
      if (hold.body == static_cast<int>(body)) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<double> compute_shallow_depths(const TissueModel& tissue, const AabbTree& tree) {
  const Vec3Array x = compute_surface(tissue, tissue.rest_position);
  const Vec3Array normals = compute_normals(tissue, x);
  std::vector<double> depths(x.size(), std::numeric_limits<double>::infinity());
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (!normals[v].allFinite()) continue;
    const auto hit = find_ray_hit(tree, x, x[v] - kBelow * normals[v], -normals[v]);
    if (hit) depths[v] = kShallow * (hit->distance + kBelow);
  }
  return depths;
}

int count_linear_substeps(const Scene& scene, std::size_t body, double dt,
                          const ResponseKernel& kernel, World& world) noexcept {
  bool near = false;
  double radii = 0.0;
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    if (!is_near(world, i, body)) continue;
    near = true;
    radii = std::max(radii, kSubstepsPerRadius * workspace(world).hands[i].travel /
                                scene.instruments[i].tool.radius);
  }
  if (!near) return 1;
  const double tau = kernel.response->damping_time;
  const double contact = bound_contact_share(scene, body, kernel, world);
  const double most = scene.bodies[body].substeps_max;
  const double damped = tau > 0.0 ? std::ceil(dt / tau * (1.0 + contact)) : most;
  const double impact = std::ceil(radii);
  const double wanted = std::max({kFewestInContact, damped, impact});
  return static_cast<int>(std::min(wanted, most));
}

double choose_linear_share(const Scene& scene, std::size_t body, double dt,
                           const ResponseKernel& kernel, World& world) noexcept {
  return choose_share(dt, bound_contact_share(scene, body, kernel, world),
                      kernel.response->damping_time);
}

void move_linear(const Scene& scene, std::size_t body, double dt, ResponseKernel& kernel,
                 World& world) noexcept {
  const Response& response = *kernel.response;
  const TissueModel& tissue = scene.bodies[body].tissue;
  SoftState& state = world.bodies[body];
  relax(response, tissue, state.load, choose_linear_share(scene, body, dt, kernel, world),
        kernel.state);
  place_near(response, tissue, kernel.state, kernel.near.particles_in_use(), state.tissue.position);
  state.tissue.time += dt;
}

double measure_deepest_share(const SoftBody& body, const ResponseKernel& kernel,
                             const SoftState& state) noexcept {
  const Alarm deepest = find_deepest(body, kernel, state, 0.0);
  return deepest ? deepest.value / deepest.limit : 0.0;
}

Alarm end_linear(const Scene& scene, std::size_t body, ResponseKernel& kernel,
                 World& world) noexcept {
  const SoftBody& soft = scene.bodies[body];
  SoftState& state = world.bodies[body];
  settle(*kernel.response, soft.tissue, kernel.state, state.tissue.position);
  move_skin(soft.tissue.skin, state.tissue.position, state.skin);
  Alarm alarm = check_particles(state.tissue, state.guard, 1);
  // a grip that is let go has gone as far as it may, and fades
  if (!alarm && !is_released(world, body)) {
    const Alarm deep = find_deepest(soft, kernel, state, 1.0);
    state.guard.strained_checks = deep ? state.guard.strained_checks + 1 : 0;
    if (state.guard.strained_checks >= kDeepChecks) alarm = deep;
  }
  if (alarm) {
    alarm.time = state.tissue.time;
  } else {
    std::copy(state.tissue.position.begin(), state.tissue.position.end(),
              state.guard.last_position.begin());
  }
  return alarm;
}

}  // namespace palpate
