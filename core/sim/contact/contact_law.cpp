// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/contact_law.h"

#include <algorithm>

#include "palpate/sim/tree/private/box.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {

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
bool find_contact(const Tool& tool, double rest_area, const Vec3& centre, const Vec3& a,
                  const Vec3& b, const Vec3& c, Contact& contact) noexcept {
  const Box box = bound_triangle(a, b, c);
  const double squared_radius = tool.radius * tool.radius;
  if (!(compute_squared_distance(centre, box.low, box.high) < squared_radius)) return false;
  const SurfacePoint closest = find_closest_on_triangle(centre, a, b, c);
  const double depth = tool.radius - closest.distance;
  if (!(depth > 0.0)) return false;

  const Vec3 normal = (b - a).cross(c - a);
  const Vec3 arm = centre - closest.point;
  double share = 1.0;
  if (closest.distance > kNoArm * tool.radius) {
    const double facing = arm.dot(normal) / (closest.distance * normal.norm());
    if (!(facing > 0.0)) return false;
    share = std::min(1.0, facing / kFullFacing);
    contact.direction = arm / closest.distance;
  } else {
    // the centre lies on the surface itself: the limit of the law as it comes down from outside
    const double length = normal.norm();
    if (!(length > 0.0)) return false;
    contact.direction = normal / length;
  }
  // a stretched triangle stands for the area it has now: thinned out, the wall would let through
  const double k = share * tool.stiffness * std::max(rest_area, 0.5 * normal.norm());
  const double z = std::max(kBarrierFloor, 1.0 - depth / tool.radius);
  contact.weights = closest.weights;
  contact.distance = closest.distance;
  contact.force = k * depth / z;
  contact.stiffness = k / (z * z);
  return true;
}

}  // namespace palpate
