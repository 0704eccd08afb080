// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/task/private/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/task/private/objects.h"

namespace palpate {
namespace {

/// The mean over a triangle's corners with barycentric weights.
Vec3 weigh(std::span<const Vec3> table, const Triangle& t, const Vec3& weights) noexcept {
  return weights[0] * table[static_cast<std::size_t>(t[0])] +
         weights[1] * table[static_cast<std::size_t>(t[1])] +
         weights[2] * table[static_cast<std::size_t>(t[2])];
}

/// Pushes of a load that are no contact's: of holds, or of what sticks to jaws.
std::size_t count_holds(const ToolState& tool, std::size_t body) noexcept {
  std::size_t count = 0;
  for (const ToolState::Anchor& anchor : list_anchors(tool)) {
    count += std::size_t(anchor.body) == body;
  }
  for (const ToolState::Hold& hold : list_holds(tool)) count += std::size_t(hold.body) == body;
  return count;
}

/// Takes what one body has into a mean over all.
class Mean {
 public:
  Mean(const Task& task, Grounding& grounding) noexcept : task_(task), grounding_(grounding) {}

  void add(std::size_t body, int triangle, const Vec3& weights, double weight) noexcept {
    const TaskSurface& surface = task_.surfaces[body];
    const Triangle& t = surface.triangles[static_cast<std::size_t>(triangle)];
    grounding_.weight += weight;
    of_body_ += weight;
    grounding_.at_rest += weight * weigh(surface.vertices, t, weights);
    grounding_.normal += weight * weigh(surface.normals, t, weights);
  }
  /// A point of what is no tissue, which has no outwards of it.
  void add(const Vec3& at_rest, double weight) noexcept {
    grounding_.weight += weight;
    grounding_.at_rest += weight * at_rest;
    of_body_ += weight;
  }
  void end_body(std::size_t body) noexcept {
    if (of_body_ > most_) {
      most_ = of_body_;
      grounding_.body = static_cast<int>(body);
    }
    of_body_ = 0.0;
  }
  void end() noexcept {
    if (!(grounding_.weight > 0.0)) {
      grounding_ = {};
      return;
    }
    grounding_.at_rest /= grounding_.weight;
    const double length = grounding_.normal.norm();
    if (length > 0.0) grounding_.normal /= length;
  }

 private:
  const Task& task_;
  Grounding& grounding_;
  double of_body_ = 0.0, most_ = 0.0;
};

void find_contact(const Task& task, const World& world, std::size_t instrument,
                  Grounding& contact) noexcept {
  Mean mean(task, contact);
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    for (const Push& push : list_pushes(world, instrument, b).contacts) {
      mean.add(b, push.triangle, push.weights, push.force.norm());
    }
    mean.end_body(b);
  }
  mean.end();
}

/// `sum` [N] of stiffness times where each point that is held is now.
void end_hold(const Vec3& sum, Mean& mean, Measures& measures) noexcept {
  const double stiffness = measures.hold.weight;
  mean.end();
  if (stiffness > 0.0) measures.displacement = sum / stiffness - measures.hold.at_rest;
}

/// Where the tool holds, and how far that has been moved: a hold of stiffness k and offset o pulls
/// its point y of the tissue to the tool p with f = -k (y + o - p), so y = p - o - f / k; likewise
/// where k is a tensor.
void find_hold(const Task& task, const World& world, std::size_t instrument,
               Measures& measures) noexcept {
  const ToolState& tool = world.instruments[instrument].tool;
  Mean mean(task, measures.hold);
  Vec3 now = Vec3::Zero();
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    const std::span<const Push> pulls = list_pushes(world, instrument, b).holds;
    std::size_t next = 0;
    for (const ToolState::Hold& hold : list_holds(tool)) {
      if (std::size_t(hold.body) != b || !(hold.stiffness > 0.0)) continue;
      if (next == pulls.size()) break;
      const Vec3 force = pulls[next++].force;
      mean.add(b, hold.triangle, hold.weights, hold.stiffness);
      now += hold.stiffness * (tool.position - hold.offset - hold.stretch(force));
    }
    mean.end_body(b);
  }
  end_hold(now, mean, measures);
}

/// Where tissue or an object sticks to both jaws, and how far that has been moved.
void find_pinched(const Task& task, const World& world, std::size_t instrument,
                  Measures& measures) noexcept {
  const ToolState& tool = world.instruments[instrument].tool;
  Mean mean(task, measures.hold);
  Vec3 now = Vec3::Zero();
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    const std::span<const Vec3> x = surface_position(world.bodies[b]);
    for (const ToolState::Anchor& anchor : list_anchors(tool)) {
      if (std::size_t(anchor.body) != b) continue;
      const Triangle& t = task.surfaces[b].triangles[static_cast<std::size_t>(anchor.triangle)];
      mean.add(b, anchor.triangle, anchor.weights, anchor.stiffness);
      now += anchor.stiffness * compute_point(t, anchor.weights, x);
    }
    mean.end_body(b);
  }
  for (std::size_t o = 0; o < task.objects.size(); ++o) {
    const TaskObject& object = task.objects[o];
    for (const ToolState::Anchor& anchor : list_anchors(tool)) {
      if (std::size_t(anchor.body) != world.bodies.size() + o) continue;
      const Triangle& t = object.tree.triangles()[static_cast<std::size_t>(anchor.triangle)];
      const Vec3 point = compute_point(t, anchor.weights, object.vertices);
      mean.add(find_start(object, point), anchor.stiffness);
      now += anchor.stiffness * find_now(object, world, point);
    }
    mean.end_body(world.bodies.size() + o);
  }
  end_hold(now, mean, measures);
}

/// Force rate and speed over the history, which this tick is taken into.
void follow_history(double force, const Vec3& position, std::int64_t tick, double dt,
                    JudgeSignals& signals, Measures& measures) noexcept {
  constexpr std::int64_t kLength = JudgeSignals::kHistory;
  const auto at = static_cast<std::size_t>(tick % kLength);
  signals.forces[at] = force;
  signals.positions[at] = position;
  if (tick + 1 < kLength) return;
  const auto oldest = static_cast<std::size_t>((tick + 1) % kLength);
  const double span = static_cast<double>(kLength - 1) * dt;
  measures.force_rate = (force - signals.forces[oldest]) / span;
  measures.speed = (position - signals.positions[oldest]).norm() / span;
}

/// [-] of the corners of a triangle, by barycentric weights.
double find_member_share(const TaskPlace& place, const Triangle& t, const Vec3& weights) noexcept {
  double share = 0.0;
  for (Eigen::Index c = 0; c < 3; ++c) {
    const auto vertex = static_cast<std::size_t>(t[static_cast<std::size_t>(c)]);
    if (place.members[vertex]) share += weights[c];
  }
  return share;
}

/// Of a path or a ball: all or nothing, by the middle of what is touched or held.
double find_share_near(const TaskPlace& place, const Grounding& grounding) noexcept {
  if (grounding.body != place.body) return 0.0;
  const double reach = place.kind == PlaceKind::path ? place.radius : 0.0;
  return find_distance(place, grounding.at_rest) <= reach ? 1.0 : 0.0;
}

/// [-] How far along from a to b the point nearest to p is.
double find_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) noexcept {
  const Vec3 side = b - a;
  return std::clamp((p - a).dot(side) / side.squaredNorm(), 0.0, 1.0);
}

}  // namespace

Pushes list_pushes(const World& world, std::size_t instrument, std::size_t body) noexcept {
  const std::span<const Push> all = world.pair(instrument, body).load.pushes();
  const InstrumentState& state = world.instruments[instrument];
  const std::size_t holds = std::min(count_holds(state.tool, body), all.size());
  const std::size_t contacts = all.size() - holds;
  return {state.tool.touching ? all.first(contacts) : all.first(0), all.subspan(contacts)};
}

Measures measure_instrument(const Task& task, const World& world, std::size_t instrument,
                            const HapticSample& sample, const HapticCommand& command, double radius,
                            double dt, JudgeSignals& signals) noexcept {
  const ToolState& tool = world.instruments[instrument].tool;
  Measures measures;
  measures.force = command.force.norm();
  measures.clicked = (sample.buttons & ~signals.buttons) != 0;
  signals.buttons = sample.buttons;
  if (tool.touching) find_contact(task, world, instrument, measures.contact);
  if (tool.hold_count > 0) find_hold(task, world, instrument, measures);
  if (tool.pinches) find_pinched(task, world, instrument, measures);
  if (measures.contact.weight > 0.0) {
    const Vec3 from_rest = tool.position - measures.contact.at_rest;
    measures.depth = radius - from_rest.dot(measures.contact.normal);
  }
  follow_history(measures.force, tool.position, world.tick_count - 1, dt, signals, measures);
  return measures;
}

double find_contact_share(const Task& task, const World& world, std::size_t instrument,
                          const TaskPlace& place, const Measures& measures) noexcept {
  if (!(measures.contact.weight > 0.0)) return 0.0;
  if (place.kind != PlaceKind::region) return find_share_near(place, measures.contact);
  const auto body = static_cast<std::size_t>(place.body);
  double force = 0.0;
  for (const Push& push : list_pushes(world, instrument, body).contacts) {
    const Triangle& t = task.surfaces[body].triangles[static_cast<std::size_t>(push.triangle)];
    force += push.force.norm() * find_member_share(place, t, push.weights);
  }
  return force / measures.contact.weight;
}

double find_hold_share(const Task& task, const World& world, std::size_t instrument,
                       const TaskPlace& place, const Measures& measures) noexcept {
  if (!(measures.hold.weight > 0.0)) return 0.0;
  if (place.kind == PlaceKind::object) {
    return is_object_held(task, world, instrument, place.body) ? 1.0 : 0.0;
  }
  if (place.kind != PlaceKind::region) return find_share_near(place, measures.hold);
  const auto body = static_cast<std::size_t>(place.body);
  double stiffness = 0.0;
  for (const ToolState::Hold& hold : list_holds(world.instruments[instrument].tool)) {
    if (hold.body != place.body) continue;
    const Triangle& t = task.surfaces[body].triangles[static_cast<std::size_t>(hold.triangle)];
    stiffness += hold.stiffness * find_member_share(place, t, hold.weights);
  }
  for (const ToolState::Anchor& anchor : list_anchors(world.instruments[instrument].tool)) {
    if (anchor.body != place.body) continue;
    const Triangle& t = task.surfaces[body].triangles[static_cast<std::size_t>(anchor.triangle)];
    stiffness += anchor.stiffness * find_member_share(place, t, anchor.weights);
  }
  return stiffness / measures.hold.weight;
}

double find_distance(const TaskPlace& place, const Vec3& at_rest) noexcept {
  if (place.kind == PlaceKind::region) return std::numeric_limits<double>::infinity();
  if (place.kind == PlaceKind::object) return std::numeric_limits<double>::infinity();
  if (place.kind == PlaceKind::ball || place.kind == PlaceKind::space) {
    return std::max(0.0, (at_rest - place.points[0]).norm() - place.radius);
  }
  return find_on_path(place, at_rest, 0.0, place.arc_length.back()).distance;
}

OnPath find_on_path(const TaskPlace& path, const Vec3& at_rest, double from, double to) noexcept {
  OnPath best{from, std::numeric_limits<double>::infinity()};
  const auto begin = std::ranges::upper_bound(path.arc_length, from);
  std::size_t i = static_cast<std::size_t>(begin - path.arc_length.begin());
  for (i = std::max<std::size_t>(i, 1); i < path.points.size(); ++i) {
    if (path.arc_length[i - 1] > to) break;
    const Vec3 &a = path.points[i - 1], &b = path.points[i];
    const double first = path.arc_length[i - 1], length = path.arc_length[i] - first;
    // a point that lies by s farther along is nearer by s at most: on to where one may be nearer
    const double ahead = (at_rest - a).norm() - best.distance;
    if (ahead > length) {
      while (i + 1 < path.points.size() && path.arc_length[i] <= first + ahead) ++i;
      if (path.arc_length[i] <= first + ahead) break;
      --i;
      continue;
    }
    // no farther along than is asked for
    const double arc = std::clamp(first + find_on_segment(a, b, at_rest) * length, from, to);
    const Vec3 point = a + (arc - first) / length * (b - a);
    const double distance = (point - at_rest).norm();
    if (distance < best.distance) best = {arc, distance};
  }
  return best;
}

}  // namespace palpate
