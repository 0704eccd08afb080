// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/contact_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "palpate/sim/contact/private/axes.h"
#include "palpate/sim/tree/private/box.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {
namespace {

/// With the closest point x, the centre a, D = |a - x| and the depth d = r - D > 0:
///
///     f = k_A A d / z,   df/dd = k_A A / z²,   z = max(0.1, 1 - d/r)
///
/// A pressure times an area, so that a finer mesh feels the same; and a barrier, so that no fast
/// tool passes [contact: law]. On the floor z = 0.1 the true slope is k_A A / z; the larger
/// one is kept, which only shortens the Newton step there.
///
/// The side is (a - x)·N >= 0. A triangle seen from behind is dropped, never pushed the other
/// path: in a narrow dent the closest point of a wall lies on its edge and the centre is behind
/// its plane, though outside. Seen nearly edge-on it fades, in proportion to the cosine: dropped
/// at its full force, the wall of a dent would chatter for ever between seen and not seen.
///
/// Behind an open surface the side is the other one. At its border there is none: what lies beyond
/// a border edge, along m in the triangle's plane, is pushed off it by as much as it does so, and
/// rolls around it [contact: borders].
bool fill_contact(const Tool& tool, double rest_area, const Vec3& arm, const SurfacePoint& closest,
                  const Vec3& normal, double beyond, double side, Contact& contact) noexcept {
  const double depth = tool.radius - closest.distance;
  contact.distance = closest.distance;
  if (!(depth > 0.0)) return false;
  double share = 1.0;
  if (closest.distance > kNoArm * tool.radius) {
    const double front = side * arm.dot(normal) / (closest.distance * normal.norm());
    const double facing = std::max(front, beyond / closest.distance);
    if (!(facing > 0.0)) return false;
    share = std::min(1.0, facing / kFullFacing);
    contact.direction = arm / closest.distance;
  } else {
    // the centre lies on the surface itself: the limit of the law as it comes down from outside
    const double length = normal.norm();
    if (!(length > 0.0)) return false;
    contact.direction = side * normal / length;
  }
  // a stretched triangle stands for the area it has now: thinned out, the wall would let through
  const double k = share * tool.stiffness * std::max(rest_area, 0.5 * normal.norm());
  const double z = std::max(kBarrierFloor, 1.0 - depth / tool.radius);
  contact.weights = closest.weights;
  contact.force = k * depth / z;
  contact.stiffness = k / (z * z);
  return true;
}

/// [m] How far an arm goes beyond the border edges of a triangle, along its plane; 0 without any.
double measure_beyond(const Openness& open, const Vec3& arm, const Vec3& normal, const Vec3& a,
                      const Vec3& b, const Vec3& c) noexcept {
  if (open.border == 0) return 0.0;
  double beyond = 0.0;
  const std::array<Vec3, 3> opposite = {c - b, a - c, b - a};
  for (std::size_t k = 0; k < 3; ++k) {
    if ((open.border >> k & 1) == 0) continue;
    const Vec3 outward = opposite[k].cross(normal);
    const double length = outward.norm();
    if (length > 0.0) beyond = std::max(beyond, arm.dot(outward) / length);
  }
  return beyond;
}

/// Of a point on the axis and the triangle.
struct AxisPoint {
  double along = 0.0;  // 0 to 1
  double square = std::numeric_limits<double>::infinity();
  Vec3 weights = Vec3::Zero();
  Vec3 point = Vec3::Zero();  // of the triangle
};

void keep_nearer(double along, const Vec3& weights, const Vec3& at, const Vec3& point,
                 AxisPoint& best) noexcept {
  const double found = (at - point).squaredNorm();
  if (found < best.square) best = {along, found, weights, point};
}

double divide(double a, double b) noexcept { return b > 0.0 ? a / b : 0.0; }

/// The nearest points of an axis and an edge: that of two lines, brought into both in turn; of
/// parallel ones, that of the axis' middle [Ericson04].
void keep_nearer_on_edge(const Vec3& from, const Vec3& axis, const Vec3& start, const Vec3& edge,
                         int first, AxisPoint& best) noexcept {
  const Vec3 r = from - start;
  const double a = axis.squaredNorm(), e = edge.squaredNorm(), b = axis.dot(edge);
  const double c = axis.dot(r), f = edge.dot(r), determinant = a * e - b * b;
  const double s0 =
      determinant > kParallel * a * e ? std::clamp((b * f - c * e) / determinant, 0.0, 1.0) : 0.5;
  const double t = std::clamp(divide(b * s0 + f, e), 0.0, 1.0);
  const double s = std::clamp(divide(b * t - c, a), 0.0, 1.0);
  Vec3 weights = Vec3::Zero();
  weights[first] = 1.0 - t;
  weights[(first + 1) % 3] = t;
  keep_nearer(s, weights, from + s * axis, start + t * edge, best);
}

/// The closest points of a segment and a triangle that it does not cross: one of the two is at the
/// end of the segment or on an edge.
AxisPoint find_on_axis(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b,
                       const Vec3& c) noexcept {
  AxisPoint best;
  const SurfacePoint at_from = find_closest_on_triangle(from, a, b, c);
  keep_nearer(0.0, at_from.weights, from, at_from.point, best);
  const SurfacePoint at_to = find_closest_on_triangle(to, a, b, c);
  keep_nearer(1.0, at_to.weights, to, at_to.point, best);
  const Vec3 axis = to - from;
  keep_nearer_on_edge(from, axis, a, b - a, 0, best);
  keep_nearer_on_edge(from, axis, b, c - b, 1, best);
  keep_nearer_on_edge(from, axis, c, a - c, 2, best);
  return best;
}

bool find_ball_contact(const Tool& tool, double rest_area, const Vec3& centre, const Vec3& a,
                       const Vec3& b, const Vec3& c, const Openness& open,
                       Contact& contact) noexcept {
  const Box box = bound_triangle(a, b, c);
  const double squared_radius = tool.radius * tool.radius;
  if (!(compute_squared_distance(centre, box.low, box.high) < squared_radius)) return false;
  const SurfacePoint closest = find_closest_on_triangle(centre, a, b, c);
  const Vec3 normal = (b - a).cross(c - a), arm = centre - closest.point;
  const double beyond = measure_beyond(open, arm, normal, a, b, c);
  return fill_contact(tool, rest_area, arm, closest, normal, beyond, open.side, contact);
}

/// That of the ball about the point of the axis that is nearest to the triangle.
bool find_axis_contact(const Tool& tool, double rest_area, const Vec3& from, const Vec3& to,
                       const Vec3& a, const Vec3& b, const Vec3& c, const Openness& open,
                       Contact& contact) noexcept {
  const Box box = bound_triangle(a, b, c);
  const Box axis{from.cwiseMin(to), from.cwiseMax(to)};
  const Vec3 apart = (box.low - axis.high).cwiseMax(axis.low - box.high);
  if (apart.maxCoeff() > tool.radius) return false;
  const AxisPoint nearest = find_on_axis(from, to, a, b, c);
  SurfacePoint closest;
  closest.weights = nearest.weights;
  closest.point = nearest.point;
  closest.distance = std::sqrt(nearest.square);
  const Vec3 normal = (b - a).cross(c - a);
  const Vec3 arm = from + nearest.along * (to - from) - nearest.point;
  const double beyond = measure_beyond(open, arm, normal, a, b, c);
  return fill_contact(tool, rest_area, arm, closest, normal, beyond, open.side, contact);
}

}  // namespace

bool find_contact(const Tool& tool, double rest_area, const Vec3& centre, const Vec3& a,
                  const Vec3& b, const Vec3& c, Contact& contact) noexcept {
  return find_ball_contact(tool, rest_area, centre, a, b, c, {}, contact);
}

bool find_capsule_contact(const Tool& tool, double rest_area, const Vec3& from, const Vec3& to,
                          const Vec3& a, const Vec3& b, const Vec3& c, Contact& contact) noexcept {
  return find_axis_contact(tool, rest_area, from, to, a, b, c, {}, contact);
}

Capsule open_jaw(const Tool& tool, std::size_t capsule, double angle) noexcept {
  const Capsule& closed = tool.capsules[capsule];
  if (!tool.jaws || angle == 0.0) return closed;
  const Jaws& jaws = *tool.jaws;
  const Eigen::AngleAxisd turn(capsule == 0 ? angle : -angle, jaws.axis);
  return {jaws.hinge + turn * (closed.from - jaws.hinge),
          jaws.hinge + turn * (closed.to - jaws.hinge)};
}

Axes::Axes(const Tool& tool, const Quaternion& orientation, double jaw_angle) noexcept {
  for (std::size_t c = 0; c < tool.capsules.size() && count < kMostCapsules; ++c) {
    const Capsule capsule = open_jaw(tool, c, jaw_angle);
    capsules[static_cast<std::size_t>(count++)] = {orientation * capsule.from,
                                                   orientation * capsule.to};
  }
}

Vec3 find_nearest_on_axes(const Axes& axes, const Vec3& p, const Vec3& point) noexcept {
  Vec3 nearest = p;
  double least = std::numeric_limits<double>::infinity();
  for (const Capsule& axis : axes.list()) {
    const Vec3 along = axis.to - axis.from, start = p + axis.from;
    const double square = along.squaredNorm();
    const double t = square > 0.0 ? std::clamp((point - start).dot(along) / square, 0.0, 1.0) : 0.0;
    const Vec3 at = start + t * along;
    if (!((at - point).squaredNorm() < least)) continue;
    least = (at - point).squaredNorm();
    nearest = at;
  }
  return nearest;
}

bool find_shape_contact(const Shape& shape, double rest_area, const Vec3& p, const Vec3& a,
                        const Vec3& b, const Vec3& c, Contact& contact,
                        const Openness& open) noexcept {
  const Tool& tool = shape.tool;
  if (shape.axes.count == 0) {
    return find_ball_contact(tool, rest_area, p, a, b, c, open, contact);
  }
  double nearest = std::numeric_limits<double>::infinity();
  bool touches = false;
  for (const Capsule& axis : shape.axes.list()) {
    Contact its;
    its.distance = std::numeric_limits<double>::infinity();
    const bool its_touches =
        find_axis_contact(tool, rest_area, p + axis.from, p + axis.to, a, b, c, open, its);
    if (!(its.distance < nearest)) continue;
    nearest = its.distance;
    touches = its_touches;
    contact = its;
  }
  return touches;
}

/// The mean of those points of ends and edges, by the squares r² - D² of how wide the capsule is
/// where it cuts them. Of the squared distance of axis and edge plus kJawSpread of the squared one
/// from the edge's middle the least is at
///
///     t = (a f - b c + kJawSpread a e/2)/(a e (1 + kJawSpread) - b²)
///
/// with the products of keep_nearer_on_edge(): where axis and edge turn past parallel it goes from
/// end to end, and does not jump.
void spread_contact(const Shape& shape, const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c,
                    Contact& contact) noexcept {
  const Capsule& capsule = shape.axes.capsules[0];
  const Vec3 from = p + capsule.from, axis = capsule.to - capsule.from;
  Vec3 sum = Vec3::Zero();
  double all = 0.0;
  const auto add = [&](const Vec3& weights, double square) noexcept {
    const double part = std::max(0.0, shape.tool.radius * shape.tool.radius - square);
    sum += part * weights;
    all += part;
  };
  const SurfacePoint at_from = find_closest_on_triangle(from, a, b, c);
  add(at_from.weights, at_from.distance * at_from.distance);
  const SurfacePoint at_to = find_closest_on_triangle(p + capsule.to, a, b, c);
  add(at_to.weights, at_to.distance * at_to.distance);
  const std::array<Vec3, 3> corners = {a, b, c};
  const double aa = axis.squaredNorm();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 edge = corners[(k + 1) % 3] - corners[k], r = from - corners[k];
    const double ee = edge.squaredNorm(), ab = axis.dot(edge), ar = axis.dot(r), er = edge.dot(r);
    const double most = kJawSpread * aa * ee;
    const double t =
        std::clamp(divide(aa * er - ab * ar + 0.5 * most, aa * ee - ab * ab + most), 0.0, 1.0);
    const double s = std::clamp(divide(ab * t - ar, aa), 0.0, 1.0);
    Vec3 weights = Vec3::Zero();
    weights[static_cast<Eigen::Index>(k)] = 1.0 - t;
    weights[static_cast<Eigen::Index>((k + 1) % 3)] = t;
    add(weights, (r + s * axis - t * edge).squaredNorm());
  }
  if (all > 0.0) contact.weights = sum / all;
}

ClosestArm find_closest_arm(const Shape& shape, const Vec3& p, const Vec3& a, const Vec3& b,
                            const Vec3& c) noexcept {
  if (shape.axes.count == 0) {
    const SurfacePoint closest = find_closest_on_triangle(p, a, b, c);
    return {closest.weights, p - closest.point};
  }
  AxisPoint best;
  ClosestArm nearest;
  for (const Capsule& axis : shape.axes.list()) {
    const Vec3 from = p + axis.from, to = p + axis.to;
    const AxisPoint at = find_on_axis(from, to, a, b, c);
    if (!(at.square < best.square)) continue;
    best = at;
    nearest = {at.weights, from + at.along * (to - from) - at.point};
  }
  return nearest;
}

}  // namespace palpate
