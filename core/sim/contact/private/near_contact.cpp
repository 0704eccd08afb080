// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/near_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "palpate/sim/contact/private/capsule_slices.h"
#include "palpate/sim/contact/private/facets.h"
#include "palpate/sim/contact/private/footprint.h"
#include "palpate/sim/contact/private/local_press.h"
#include "palpate/sim/contact/private/mesh_response.h"
#include "palpate/sim/contact/private/touched_surface.h"

namespace palpate {
namespace {

/// What a mesh may make of the pressures, either way. Under a wall that bends between its vertices
/// they may be next to nothing; those of a long capsule are half of a half space's and less.
constexpr double kLeastGain = 0.3, kLeastCapsuleGain = 0.1, kLeastWallGain = 1e-4, kMostGain = 12.0;

/// Parts of the radius: what of a ball is left in the triangles when it is lifted off them, and by
/// how much it is lifted at most.
constexpr double kLeftIn = 0.55, kMostLift = 1.2;

/// Part of the radius from which the hard law holds as well, so that nothing passes, and over which
/// it would come to hold in full: at a whole radius half of it does.
constexpr double kBarrierFrom = 0.65, kBarrierWidth = 0.7;

NearPressure make_law(const NearField& near, const Tool& tool) noexcept {
  return {near.modulus, tool.radius, tool.stiffness};
}

/// As the hard law fades for a triangle seen nearly edge-on.
double find_share(const Contact& closest, const Vec3& normal) noexcept {
  return std::clamp(closest.direction.dot(normal) / kFullFacing, 0.0, 1.0);
}

/// Sums over the footprints of one body, each weighted by its force.
struct Patch {
  double force = 0.0;          // [N]
  double whole = 0.0;          // [N²]
  double depth = 0.0;          // [N m] below each plane
  double area = 0.0;           // [m²]
  double far = 0.0;            // [m] along each plane's normal
  Symmetric far_tensor{};      // [m] where there is one, in every direction
  double curvature = 0.0;      // [N/m]
  FacetSums facets;            // where they are felt
  Vec3 normal = Vec3::Zero();  // [N]
  Vec3 centre = Vec3::Zero();  // [N m] of pressure, from the tool's position
  Vec3 axis = Vec3::Zero();    // [N m] of a capsule's axis above the pressures, likewise
  double spread = 0.0;         // [N m²] of those places, about that position
  double stiffness = 0.0;      // [N/m] of the pressures

  /// [m] Of the axis above the pressures: a line evenly pressed has the variance length²/12.
  double length() const noexcept {
    return std::sqrt(12.0 * std::max(0.0, spread / force - (axis / force).squaredNorm()));
  }

  void add(const NearField& near, const Triangle& triangle, const Vec3& at, const Vec3& on_axis,
           double share, const Footprint& part) noexcept {
    const double q = share * part.normal_force;
    force += q;
    axis += q * on_axis;
    spread += q * (on_axis.squaredNorm() + part.spread);
    stiffness += share * part.stiffness;
    whole += q * part.whole_force;
    area += share * part.area;
    depth += q * part.depth;
    normal += q * part.normal;
    centre += q * at;
    if (!near.rest_position.empty()) facets.add(q, triangle, part.weights, near.rest_position);
    for (std::size_t c = 0; c < 3; ++c) {
      const double carried = q * part.weights[static_cast<Eigen::Index>(c)];
      const auto v = static_cast<std::size_t>(triangle[c]);
      far += carried * near.far_compliance[v];
      for (std::size_t k = 0; !near.far_tensor.empty() && k < far_tensor.size(); ++k) {
        far_tensor[k] += carried * near.far_tensor[v][k];
      }
      curvature += carried * near.curvature[static_cast<std::size_t>(triangle[c])];
    }
  }
};

/// How far the normals of a patch agree, 0 to 1: below the first number each of its planes is
/// pressed by itself, as the walls of a groove are, above the second all are one dent.
constexpr double kGroove = 0.5, kDent = 0.8;

/// [1/m] of the tissue under a patch.
double find_curvature(const NearField& near, const Patch& patch) noexcept {
  return near.rest_position.empty() ? patch.curvature / patch.force
                                    : patch.facets.curvature(patch.area);
}

/// Which way a patch faces, and how much of one dent it is.
struct Dent {
  explicit Dent(const Patch& patch) noexcept
      : normal(patch.normal / std::max(patch.normal.norm(), 1e-300)),
        part(std::clamp((patch.normal.norm() / patch.force - kGroove) / (kDent - kGroove), 0.0,
                        1.0)) {}

  Vec3 normal;  // unit
  double part;
};

/// [m] How far the ball goes into the triangles, where it does so farthest.
double find_deepest(const Tool& tool, const NearContacts& contacts) noexcept {
  double deepest = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
    deepest = std::max(deepest, tool.radius - contacts.closest[i].distance);
  }
  return deepest;
}

/// Of one dent: the ball's lowest point, along the mean normal, below the centre of pressure, and
/// the pressures in all. Of several planes: the mean below each, and the force on a whole one. The
/// half space has F(s) at the depth s, of which the mesh has left that. Pressures are those of the
/// ball that is lifted off the triangles; the force is that of the ball where it is, less what
/// others have `sunk` [m] the tissue there. The dent in a wall is small beside the ridges between
/// its triangles, so that it is measured from where the ball touches them first; and so is that in
/// facets, whose middle lies lower the more they are curved.
NearGain find_gain(const NearField& near, const Shape& shape, const Patch& patch, double sunk,
                   const NearContacts& contacts) noexcept {
  const Tool& tool = shape.tool;
  const Dent dent(patch);
  const bool ball = shape.axes.count == 0;
  const double length = ball ? 0.0 : patch.length();
  const bool wall = near.wall_thickness > 0.0;
  const double below =
      wall ? find_deepest(tool, contacts)
           : tool.radius + (patch.centre - patch.axis).dot(dent.normal) / patch.force;
  const double left_in = dent.part * below + (1.0 - dent.part) * patch.depth / patch.force;
  const double pressed = dent.part * patch.force + (1.0 - dent.part) * patch.whole / patch.force;
  const double lifted = contacts.lift.dot(dent.normal);

  const double curvature = (contacts.side < 0.0 ? -1.0 : 1.0) * find_curvature(near, patch);
  const LocalPress press{near.modulus, tool.radius, curvature, contacts.mesh_compliance, length};
  const LocalPress flat{near.modulus, tool.radius, 0.0, 0.0};
  const double on_mesh = std::max(left_in, 1e-3 * patch.depth / patch.force);
  const double seen = on_mesh + std::max(0.0, lifted) + dent.part * patch.facets.drop();
  // as much as all of it would be a press that nothing resists
  const double depth = std::clamp(seen - sunk, kLeastLeft * seen, seen / kLeastLeft);
  const double wider =
      measure_cut(tool.radius, length, depth) / measure_cut(tool.radius, length, on_mesh);
  const bool bends = wall && contacts.mesh_compliance < 0.0;
  const double s = bends ? press.find_depth_on(depth, -contacts.mesh_compliance)
                         : press.find_depth(depth, patch.area * wider);
  const double slope =
      bends ? press.compute_slope(s) / (1.0 - contacts.mesh_compliance * press.compute_slope(s))
            : press.compute_slope(s) * s / depth;
  NearGain gain;
  const double least = wall ? kLeastWallGain : ball ? kLeastGain : kLeastCapsuleGain;
  gain.force = std::clamp(press.compute_force(s) / pressed, least, kMostGain);
  const double theirs = ball ? flat.compute_slope(on_mesh) : std::max(patch.stiffness, 1e-300);
  gain.slope = std::clamp(slope / theirs, gain.force, 10.0 * kMostGain);
  gain.local_slope = press.compute_slope(s);
  return gain;
}

/// The triangles stay where the tissue would have sunk away under the ball: beyond kLeftIn it does
/// not go on into them, so that the barrier knows only what is deeper than a dent. In the groove
/// between two walls there is nothing to sink away.
Vec3 choose_lift(const Tool& tool, const Patch& patch, const NearContacts& contacts) noexcept {
  if (!(patch.force > 0.0)) return Vec3::Zero();
  const Dent dent(patch);
  const double beyond =
      find_deepest(tool, contacts) + contacts.lift.dot(dent.normal) - kLeftIn * tool.radius;
  const Vec3 normal = (dent.normal - contacts.force * contacts.tilt).normalized();
  return dent.part * std::clamp(beyond, 0.0, kMostLift * tool.radius) * normal;
}

/// A ball that is lifted otherwise moves as one that takes a step, and goes no farther: half a
/// radius, and half the way to any plane through a contact's closest point (balance_tool.cpp). A
/// dent that closes around the ball is a groove, which has no lift, and one whose normal swings
/// turns it: at once, either put the ball behind the surface.
Vec3 limit_lift(const Tool& tool, const Vec3& wanted, const NearContacts& contacts) noexcept {
  const Vec3 change = wanted - contacts.lift;
  const double length = change.norm(), most = 0.5 * tool.radius;
  double part = length > most ? most / length : 1.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
    const Contact& closest = contacts.closest[i];
    const double approach = -change.dot(closest.direction);
    const double room = 0.5 * std::max(0.0, closest.distance - kClearance * tool.radius);
    if (part * approach > room) part = room / approach;
  }
  return part < 1.0 ? Vec3(contacts.lift + part * change) : wanted;
}

/// Pressures times the gain, and the barrier: a part of the hard law that rises in proportion to
/// what is deeper than kBarrierFrom. Its slope is that of the product: with the hard law's alone
/// Newton's steps would come out of it too slowly, and leave a push of many newtons.
Contact combine(const Tool& tool, const Contact& closest, const Contact& soft,
                const NearGain& gain) noexcept {
  Contact contact = closest;
  const double depth = tool.radius - closest.distance;
  const double width = kBarrierWidth * tool.radius;
  const double part = std::max(0.0, depth - kBarrierFrom * tool.radius) / width;
  const double hard = closest.force * part;
  const Vec3 sum = gain.force * soft.force * soft.direction + hard * closest.direction;
  const double force = sum.norm(), shares = gain.force * soft.force + hard;
  contact.force = force;
  contact.stiffness = gain.slope * soft.stiffness;
  if (part > 0.0) contact.stiffness += closest.stiffness * part + closest.force / width;
  if (!(force > 0.0)) return contact;
  contact.direction = sum / force;
  contact.weights = (gain.force * soft.force * soft.weights + hard * closest.weights) / shares;
  return contact;
}

/// Below the ball or the capsule, which with a near field is one. From behind, `side` -1, the
/// triangle is the same one turned over.
bool integrate(const NearPressure& law, const Axes& axes, const Vec3& p, double side, const Vec3& a,
               const Vec3& b, const Vec3& c, Footprint& part, SumSlices sum = nullptr) noexcept {
  if (side < 0.0) {
    const bool pressed = integrate(law, axes, p, 1.0, a, c, b, part, sum);
    std::swap(part.weights[1], part.weights[2]);
    return pressed;
  }
  if (axes.count == 0) return integrate_footprint(law, p, a, b, c, part);
  const Capsule& axis = axes.capsules[0];
  return integrate_capsule_footprint(law, p + axis.from, p + axis.to, a, b, c, part, false, sum);
}

/// The pressures on one triangle as they are.
Contact press(const Footprint& part, const Contact& closest, double share) noexcept {
  const double length = part.force.norm();
  Contact soft;
  soft.force = share * length;
  soft.direction = length > 0.0 ? Vec3(part.force / length) : closest.direction;
  soft.weights = part.weights;
  soft.stiffness = share * part.stiffness;
  soft.distance = closest.distance;
  return soft;
}

/// [N/m] How the pressures grow with depth.
double sum_slopes(const NearContacts& contacts, const NearGain& gain) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
    sum += gain.slope * contacts.contact[i].stiffness;
  }
  return sum;
}

/// Where holds have taken over the pressures, these are only what is more than the holds push with,
/// and than there was when the tool took hold: so what is pressed deeper is felt as without a hold,
/// and what is pulled by the holds alone [contact: hold]. The slope that is left is no less than
/// that of the difference.
void leave_to_holds(const Vec3& position, const NearContacts& contacts, NearGain& gain) noexcept {
  const Grip& grip = contacts.grip;
  if (!(grip.force > 0.0 && contacts.force > 0.0)) return;
  const double held = grip.find_push(position);
  const double left = std::max(0.0, contacts.force - std::max(grip.force, held)) / contacts.force;
  const double slope = sum_slopes(contacts, gain);
  gain.force *= left;
  gain.slope *= left > 0.0 ? std::max(left, 1.0 - grip.stiffness / std::max(slope, 1e-300)) : 0.0;
}

SumSlices choose_sum(const Shape& shape, const TouchedSurface& surface) noexcept {
  return shape.axes.count > 0 ? find_slice_sums(surface.candidates->lanes) : nullptr;
}

/// Pressures as they are on all triangles; of a capsule without those on whole planes.
Patch press_triangles(const Shape& shape, const TouchedSurface& surface, const Vec3& p) noexcept {
  const NearPressure law = make_law(*surface.near, shape.tool);
  NearContacts& contacts = surface.candidates->near;
  const SumSlices sum = choose_sum(shape, surface);
  Patch patch;
  for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
    const Triangle& t = surface.triangles[static_cast<std::size_t>(contacts.triangle[i])];
    const auto corner = [&](std::size_t c) noexcept -> const Vec3& {
      return surface.x[static_cast<std::size_t>(t[c])];
    };
    const Contact& closest = contacts.closest[i];
    contacts.contact[i] = closest;
    contacts.contact[i].force = contacts.contact[i].stiffness = 0.0;
    Footprint part;
    const double side = find_openness(*surface.candidates, contacts.triangle[i]).side;
    if (!integrate(law, shape.axes, p, side, corner(0), corner(1), corner(2), part, sum)) continue;
    const double share = find_share(closest, part.normal);
    contacts.contact[i] = press(part, closest, share);
    patch.add(*surface.near, t, compute_point(t, part.weights, surface.x) - p, part.axis - p, share,
              part);
  }
  return patch;
}

/// [N²] Patch::whole of a capsule, on whole planes. What press() has kept of a triangle is F share
/// along the pressures; along the plane's normal that is its force again.
double press_planes(const Shape& shape, const TouchedSurface& surface, const Vec3& p) noexcept {
  const NearPressure law = make_law(*surface.near, shape.tool);
  const NearContacts& contacts = surface.candidates->near;
  const SumSlices sum = choose_sum(shape, surface);
  const Vec3 from = p + shape.axes.capsules[0].from, to = p + shape.axes.capsules[0].to;
  double whole = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
    const Contact& contact = contacts.contact[i];
    if (!(contact.force > 0.0)) continue;
    const Triangle& t = surface.triangles[static_cast<std::size_t>(contacts.triangle[i])];
    const bool behind = find_openness(*surface.candidates, contacts.triangle[i]).side < 0.0;
    const Vec3& a = surface.x[static_cast<std::size_t>(t[0])];
    const Vec3& b = surface.x[static_cast<std::size_t>(t[behind ? 2 : 1])];
    const Vec3& c = surface.x[static_cast<std::size_t>(t[behind ? 1 : 2])];
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const double share = find_share(contacts.closest[i], normal);
    const double q = contact.force * contact.direction.dot(normal);
    if (!(share > 0.0 && q > 0.0)) continue;
    whole += q * std::max(integrate_capsule_plane(law, from, to, a, b, c, sum), q / share);
  }
  return whole;
}

/// What whole planes would bear counts in a groove alone, and of a capsule is costly to know.
Patch press_patch(const Shape& shape, const TouchedSurface& surface, const Vec3& p) noexcept {
  Patch patch = press_triangles(shape, surface, p);
  if (shape.axes.count == 0 || !(patch.force > 0.0) || Dent(patch).part == 1.0) return patch;
  patch.whole = press_planes(shape, surface, p);
  return patch;
}

}  // namespace

void find_near_contacts(const Shape& shape, const TouchedSurface& surface, const Vec3& p) noexcept {
  const Tool& tool = shape.tool;
  const NearField& near = *surface.near;
  NearContacts& contacts = surface.candidates->near;
  const Patch patch = press_patch(shape, surface, p);
  contacts.force = 0.0;
  NearGain gain;
  if (patch.force > 0.0) {
    contacts.middle = p + patch.centre / patch.force;
    contacts.normal = Dent(patch).normal;
    const bool given = !near.far_tensor.empty();
    contacts.far_compliance =
        (given ? compute_along(patch.far_tensor, contacts.normal) : patch.far) / patch.force;
    if (!contacts.knows_compliance) {
      const MeshResponse mesh = compute_response(surface, contacts, contacts);
      contacts.mesh_compliance = mesh.compliance - contacts.far_compliance;
      contacts.tilt = mesh.tilt;
      find_crossings(tool, surface, contacts);
      contacts.knows_compliance = true;
    }
    gain = find_gain(near, shape, patch, sum_crossings(surface, contacts), contacts);
    contacts.force = gain.force * patch.force;
    leave_to_holds(p - contacts.lift, contacts, gain);
    contacts.force = gain.force * patch.force;
  }
  contacts.gain = gain.force;
  contacts.stiffening = gain.slope;
  contacts.local_slope = gain.local_slope;
  contacts.push.setZero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
    const Contact soft = level(surface, contacts.force * contacts.tilt, shape.axes, p,
                               contacts.triangle[i], contacts.contact[i]);
    contacts.push += gain.force * soft.force * soft.direction;
    contacts.contact[i] = combine(tool, contacts.closest[i], soft, gain);
  }
  contacts.next_lift = limit_lift(tool, choose_lift(tool, patch, contacts), contacts);
  contacts.centre = p;
  contacts.found = true;
}

bool find_near_contact(const NearField& near, const Shape& shape, const Contact& closest,
                       const Vec3& p, double side, const Vec3& a, const Vec3& b, const Vec3& c,
                       NearGain gain, Contact& contact) noexcept {
  Footprint part;
  Contact soft;
  if (integrate(make_law(near, shape.tool), shape.axes, p, side, a, b, c, part)) {
    soft = press(part, closest, find_share(closest, part.normal));
  }
  contact = combine(shape.tool, closest, soft, gain);
  return contact.force > 0.0;
}

double bound_slope(const Tool& tool, const Contact& closest, const Contact& contact) noexcept {
  const bool barrier = tool.radius - closest.distance > kBarrierFrom * tool.radius;
  return barrier ? std::max(contact.stiffness, closest.stiffness) : contact.stiffness;
}

}  // namespace palpate
