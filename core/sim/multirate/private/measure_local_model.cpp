// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/multirate/private/measure_local_model.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <optional>
#include <vector>

#include "palpate/sim/contact/private/list_contacts.h"
#include "palpate/sim/response/private/local_compliance.h"
#include "palpate/sim/tick/private/world_internals.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {
namespace {

/// Part of the radius by which a tool that touches nothing is pressed in, to learn how the tissue
/// before it would resist.
constexpr double kTrialDepth = 0.1;

/// Part of the radius by which it is moved to find a slope.
constexpr double kSlopeStep = 2e-3;

/// What a tool leans on: springs, and the points of one surface that they act on.
struct Support {
  std::vector<LocalSpring> springs;
  std::vector<Push> points;    // their force is the springs' direction
  Vec3 force = Vec3::Zero();   // [N] of the contacts, in all
  std::vector<double> shares;  // [N] of each in that

  void add(int triangle, const Vec3& weights, const Vec3& direction, double stiffness,
           double share = 0.0) {
    force += share * direction;
    if (!(stiffness > 0.0)) return;
    springs.push_back({direction, stiffness});
    points.push_back({triangle, weights, direction});
    shares.push_back(share);
  }
};

/// The surface of a body under an instrument, with candidates of its own around `at` [m], a lift
/// [m] off the triangles included.
TouchedSurface look_around(const Scene& scene, std::size_t instrument, std::size_t body,
                           const Vec3& at, const Vec3& lift, World& world, Candidates& scratch) {
  TouchedSurface surface = list_surfaces(scene, instrument, world)[body];
  surface.others = {};
  scratch.near.lift = lift;
  scratch.near.side = world.pair(instrument, body).candidates.near.side;
  scratch.near.grip = world.pair(instrument, body).candidates.near.grip;
  find_candidates(world.bodies[body].tree, surface.x, scene.instruments[instrument].tool, at, at,
                  scene.bodies[body].rest_areas, scratch);
  surface.candidates = &scratch;
  return surface;
}

Support list_contact_springs(const Tool& tool, const TouchedSurface& surface, const Vec3& at) {
  Support support;
  for (const TriangleContact& its : list_contacts(tool, surface, at)) {
    support.add(its.triangle, its.contact.weights, its.contact.direction, its.contact.stiffness,
                its.contact.force);
  }
  return support;
}

/// [N/m] How the contacts' force along n grows with depth, the tissue held: by finite differences,
/// for under a near field each contact's force depends on the others.
double measure_slope(const Tool& tool, const TouchedSurface& surface, const Vec3& at,
                     const Vec3& n) {
  const double step = kSlopeStep * tool.radius;
  const Vec3 deeper = list_contact_springs(tool, surface, at - step * n).force;
  const Vec3 higher = list_contact_springs(tool, surface, at + step * n).force;
  return (deeper - higher).dot(n) / (2.0 * step);
}

void add_holds(const ToolState& tool, std::size_t body, Support& support) {
  for (int h = 0; h < tool.hold_count; ++h) {
    const ToolState::Hold& hold = tool.holds[static_cast<std::size_t>(h)];
    if (hold.body != static_cast<int>(body)) continue;
    if (hold.is_tied()) {
      const Vec3 first = hold.normal.unitOrthogonal(), second = hold.normal.cross(first);
      support.add(hold.triangle, hold.weights, hold.normal, hold.stiffness);
      support.add(hold.triangle, hold.weights, first, hold.sideways);
      support.add(hold.triangle, hold.weights, second, hold.sideways);
      continue;
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      support.add(hold.triangle, hold.weights, Vec3::Unit(axis), hold.stiffness);
    }
  }
}

/// [m/N] Along the springs of a support. A tissue that cannot be solved for counts as not giving
/// way at all.
Eigen::MatrixXd find_compliance(const Scene& scene, std::size_t body, const World& world,
                                const Support& support) {
  const auto count = static_cast<Eigen::Index>(support.springs.size());
  const std::optional<Eigen::MatrixXd> compliance =
      compute_local_compliance(scene.bodies[body].tissue, world.bodies[body].tissue.position,
                               support.points, kMostParticles);
  return compliance ? *compliance : Eigen::MatrixXd::Zero(count, count);
}

/// [N/m] Of contacts without friction: along their force F alone, K = M / (1 + C M) with C the
/// compliance under pushes in the shares that they have of F. Sideways the dent goes along with the
/// tool, which no stiffness at points of the tissue knows.
Mat3 measure_contact(const Scene& scene, std::size_t body, const World& world, const Tool& tool,
                     const TouchedSurface& surface, const Vec3& at, const Support& support) {
  if (support.springs.empty() || !(support.force.norm() > 0.0)) return Mat3::Zero();
  const Vec3 n = support.force.normalized();
  const Eigen::Map<const Eigen::VectorXd> shares(support.shares.data(),
                                                 static_cast<Eigen::Index>(support.shares.size()));
  const double give = shares.dot(find_compliance(scene, body, world, support) * shares) /
                      support.force.squaredNorm();
  const double slope = std::max(0.0, measure_slope(tool, surface, at, n));
  return slope / (1.0 + give * slope) * Mat3(n * n.transpose());
}

struct NearestBody {
  std::size_t body = 0;
  std::optional<SurfacePoint> point;
};

NearestBody find_nearest(const World& world, const Vec3& position) {
  NearestBody nearest;
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    const auto point =
        find_closest_point(world.bodies[b].tree, surface_position(world.bodies[b]), position);
    if (!point || (nearest.point && nearest.point->distance <= point->distance)) continue;
    nearest = {b, point};
  }
  return nearest;
}

/// Where the tool would touch, and how that would be resisted.
void model_approach(const Scene& scene, std::size_t instrument, World& world,
                    std::span<Candidates> scratch, LocalModel& model) {
  const Tool& tool = scene.instruments[instrument].tool;
  const Vec3 at = world.instruments[instrument].tool.position;
  const auto [body, point] = find_nearest(world, at);
  if (!point || !(point->distance > 0.0)) return;
  model.normal = (at - point->point) / point->distance;
  model.position = point->point + tool.radius * model.normal;
  const Vec3 trial = point->point + (1.0 - kTrialDepth) * tool.radius * model.normal;
  const TouchedSurface surface =
      look_around(scene, instrument, body, trial, Vec3::Zero(), world, scratch[body]);
  const Support support = list_contact_springs(tool, surface, trial);
  model.stiffness = measure_contact(scene, body, world, tool, surface, trial, support);
}

}  // namespace

/// Tool and tissue move by dp and by u_i at spring i, whose force changes by g_i:
///
///     u = C g',   g' = k (D dp - u),   dF = -D^T g'   =>   K = D^T (1/k + C)^-1 D
///
/// with D the directions, one a row, C the tissue's compliance along them. One spring of stiffness
/// k along n: M = k n n^T and K = M (I + C M)^-1.
Mat3 condense(std::span<const LocalSpring> springs, const Eigen::MatrixXd& compliance) {
  const auto count = static_cast<Eigen::Index>(springs.size());
  if (count == 0) return Mat3::Zero();
  Eigen::MatrixXd both = compliance;
  Eigen::Matrix<double, Eigen::Dynamic, 3> directions(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const LocalSpring& spring = springs[static_cast<std::size_t>(i)];
    both(i, i) += 1.0 / spring.stiffness;
    directions.row(i) = spring.direction.transpose();
  }
  const Mat3 stiffness = directions.transpose() * both.ldlt().solve(directions);
  return 0.5 * (stiffness + stiffness.transpose());
}

LocalModel measure_local_model(const Scene& scene, std::size_t instrument, const Vec3& hand,
                               const Vec3& felt, World& world, std::span<Candidates> scratch) {
  const Instrument& its = scene.instruments[instrument];
  const ToolState& tool = world.instruments[instrument].tool;
  LocalModel model;
  if (!tool.placed) return model;
  model.held = tool.hold_count > 0;
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    const Vec3 lift = world.pair(instrument, b).candidates.near.lift;
    const TouchedSurface surface =
        look_around(scene, instrument, b, tool.position, lift, world, scratch[b]);
    Support support = list_contact_springs(its.tool, surface, tool.position);
    if (!model.held) {
      model.stiffness +=
          measure_contact(scene, b, world, its.tool, surface, tool.position, support);
      continue;
    }
    add_holds(tool, b, support);
    if (support.springs.empty()) continue;
    model.stiffness += condense(support.springs, find_compliance(scene, b, world, support));
  }
  if (model.stiffness.isZero(0.0) || felt.isZero(0.0)) {
    model.stiffness.setZero();
    if (!model.held) {
      model_approach(scene, instrument, world, scratch, model);
      return model;
    }
  }
  model.force = felt;
  model.normal = felt.norm() > 0.0 ? Vec3(felt.normalized()) : Vec3(Vec3::Zero());
  // where the hand's spring pulls no harder, the tool is not where that says
  const bool limited = felt.norm() > 0.999 * its.coupling.force_max;
  model.position = limited ? tool.position : Vec3(hand + felt / its.coupling.stiffness);
  return model;
}

}  // namespace palpate
