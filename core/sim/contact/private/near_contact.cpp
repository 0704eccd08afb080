// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/near_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "palpate/sim/contact/private/footprint.h"

namespace palpate {
namespace {

/// Of the force on a half space at large depth, fitted to neo-Hookean solutions, up to two radii;
/// beyond, the force goes on along its tangent [contact: near field].
constexpr double kFirst = -0.1327, kSecond = -0.0104, kDeepest = 2.0;

/// The part of a dent that a mesh is taken to have left. One as soft as tissue leaves a fifth; one
/// that leaves less is too soft itself, and no contact makes up for that.
constexpr double kLeastLeft = 0.15, kMostLeft = 1.6;

/// What a mesh may make of the pressures, either way.
constexpr double kLeastGain = 0.3, kMostGain = 8.0;

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
  double far = 0.0;            // [m]
  double curvature = 0.0;      // [N/m]
  Vec3 normal = Vec3::Zero();  // [N]
  Vec3 centre = Vec3::Zero();  // [N m] of pressure, from the ball's

  void add(const NearField& near, const Triangle& triangle, const Vec3& at, double share,
           const Footprint& part) noexcept {
    const double q = share * part.normal_force;
    force += q;
    whole += q * part.whole_force;
    area += share * part.area;
    depth += q * part.depth;
    normal += q * part.normal;
    centre += q * at;
    for (std::size_t c = 0; c < 3; ++c) {
      const double carried = q * part.weights[static_cast<Eigen::Index>(c)];
      far += carried * near.far_compliance[static_cast<std::size_t>(triangle[c])];
      curvature += carried * near.curvature[static_cast<std::size_t>(triangle[c])];
    }
  }
};

/// [m/N] wᵀ G w of the patch: weights of each corner are its part of the force.
double compute_mesh_compliance(const NearField& near, std::span<const Triangle> triangles,
                               NearContacts& contacts) noexcept {
  double sum = 0.0, force = 0.0;
  const auto for_each_corner = [&](auto take) noexcept {
    for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
      const Contact& contact = contacts.contact[i];
      const Triangle& triangle = triangles[static_cast<std::size_t>(contacts.triangle[i])];
      for (std::size_t c = 0; c < 3; ++c) {
        take(static_cast<std::size_t>(triangle[c]),
             contact.force * contact.weights[static_cast<Eigen::Index>(c)]);
      }
    }
  };
  for_each_corner([&](std::size_t v, double part) noexcept {
    contacts.weight[v] += part;
    force += part;
  });
  for_each_corner([&](std::size_t v, double part) noexcept {
    double moved = 0.0;
    for (auto k = static_cast<std::size_t>(near.first[v]);
         k < static_cast<std::size_t>(near.first[v + 1]); ++k) {
      moved += static_cast<double>(near.compliance[k]) *
               contacts.weight[static_cast<std::size_t>(near.neighbour[k])];
    }
    sum += part * moved;
  });
  for_each_corner([&](std::size_t v, double) noexcept { contacts.weight[v] = 0.0; });
  return force > 0.0 ? sum / (force * force) : 0.0;
}

/// How far the normals of a patch agree, 0 to 1: below the first number each of its planes is
/// pressed by itself, as the walls of a groove are, above the second all are one dent.
constexpr double kGroove = 0.5, kDent = 0.8;

/// Of one dent: the ball's lowest point, along the mean normal, below the centre of pressure, and
/// the pressures in all. Of several planes: the mean below each, and the force on a whole one. The
/// half space has F(s) at the depth s, of which the mesh has left that.
NearGain find_gain(const NearField& near, const Tool& tool, const Patch& patch,
                   double mesh_compliance) noexcept {
  const double agreement = patch.normal.norm() / patch.force;
  const double dent = std::clamp((agreement - kGroove) / (kDent - kGroove), 0.0, 1.0);
  const Vec3 normal = patch.normal / std::max(patch.normal.norm(), 1e-300);
  const double below = tool.radius + patch.centre.dot(normal) / patch.force;
  const double depth = dent * below + (1.0 - dent) * patch.depth / patch.force;
  const double pressed = dent * patch.force + (1.0 - dent) * patch.whole / patch.force;

  const LocalPress press{near.modulus, tool.radius, patch.curvature / patch.force, mesh_compliance};
  const LocalPress flat{near.modulus, tool.radius, 0.0, 0.0};
  const double least = std::max(depth, 1e-3 * patch.depth / patch.force);
  const double s = press.find_depth(least, patch.area);
  NearGain gain;
  gain.force = std::clamp(press.compute_force(s) / pressed, kLeastGain, kMostGain);
  gain.slope = std::clamp(press.compute_slope(s) * s / (least * flat.compute_slope(least)),
                          gain.force, 10.0 * kMostGain);
  return gain;
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

}  // namespace

double LocalPress::compute_force(double s) const noexcept {
  const double inverse = std::max(1.0 / radius + curvature, 0.1 / radius);
  const double most = kDeepest * radius, in = std::min(s, most), x = in / radius;
  const double hertz = 4.0 / 3.0 * modulus * std::sqrt(in / inverse) * in;
  const double force = hertz * (1.0 + x * (kFirst + x * kSecond));
  return s > most ? force + (s - most) * compute_slope(most) : force;
}

double LocalPress::compute_slope(double s) const noexcept {
  const double inverse = std::max(1.0 / radius + curvature, 0.1 / radius);
  const double in = std::min(s, kDeepest * radius), x = in / radius;
  return 2.0 * modulus * std::sqrt(in / inverse) *
         (1.0 + x * (5.0 / 3.0 * kFirst + x * 7.0 / 3.0 * kSecond));
}

/// With dC a_now/a(s) in place of dC, and F = 4/3 E* a s,
///
///     s - 4/3 E* a_now dC s = depth
///
/// has one root; with dC itself it would have none where a patch is wider than elements are, for a
/// mesh that gives way as tissue does takes 4/5 of any dent. a_now is the radius of contact: where
/// the mesh has taken nothing the ball cuts a flat surface, sqrt(2) times as wide as it is touched
/// [Hertz82], and where it has taken those 4/5 the surface lies against the ball. Between the two,
/// a_now² goes with the part y = depth/s that the mesh has left: (1/2 + (1 - y) 5/8) area/pi.
double LocalPress::find_depth(double depth, double area) const noexcept {
  const double widest = std::sqrt(area * std::numbers::inv_pi);
  const double share = 4.0 / 3.0 * modulus * widest * mesh_compliance;
  double y = 1.0;
  for (int i = 0; i < 6; ++i) {
    const double root = std::sqrt(std::max(0.05, 1.125 - 0.625 * y));
    const double slope = 1.0 - 0.3125 * share / root;
    if (!(slope > 0.1)) return depth / kLeastLeft;
    y = std::clamp(y - (y + share * root - 1.0) / slope, kLeastLeft, kMostLeft);
  }
  return depth / y;
}

void find_near_contacts(const NearField& near, const Tool& tool,
                        std::span<const Triangle> triangles, std::span<const Vec3> x, const Vec3& p,
                        NearContacts& contacts) noexcept {
  const NearPressure law = make_law(near, tool);
  Patch patch;
  for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
    const Triangle& t = triangles[static_cast<std::size_t>(contacts.triangle[i])];
    const auto corner = [&](std::size_t c) noexcept -> const Vec3& {
      return x[static_cast<std::size_t>(t[c])];
    };
    const Contact& closest = contacts.closest[i];
    contacts.contact[i] = closest;
    contacts.contact[i].force = contacts.contact[i].stiffness = 0.0;
    Footprint part;
    if (!integrate_footprint(law, p, corner(0), corner(1), corner(2), part)) continue;
    const double share = find_share(closest, part.normal);
    contacts.contact[i] = press(part, closest, share);
    patch.add(near, t, compute_point(t, part.weights, x) - p, share, part);
  }
  NearGain gain;
  if (patch.force > 0.0) {
    if (!contacts.knows_compliance) {
      contacts.mesh_compliance =
          compute_mesh_compliance(near, triangles, contacts) - patch.far / patch.force;
      contacts.knows_compliance = true;
    }
    gain = find_gain(near, tool, patch, contacts.mesh_compliance);
  }
  contacts.gain = gain.force;
  contacts.stiffening = gain.slope;
  for (std::size_t i = 0; i < static_cast<std::size_t>(contacts.count); ++i) {
    contacts.contact[i] = combine(tool, contacts.closest[i], contacts.contact[i], gain);
  }
  contacts.centre = p;
  contacts.found = true;
}

bool find_near_contact(const NearField& near, const Tool& tool, const Contact& closest,
                       const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, NearGain gain,
                       Contact& contact) noexcept {
  Footprint part;
  Contact soft;
  if (integrate_footprint(make_law(near, tool), p, a, b, c, part)) {
    soft = press(part, closest, find_share(closest, part.normal));
  }
  contact = combine(tool, closest, soft, gain);
  return contact.force > 0.0;
}

double bound_slope(const Tool& tool, const Contact& closest, const Contact& contact) noexcept {
  const bool barrier = tool.radius - closest.distance > kBarrierFrom * tool.radius;
  return barrier ? std::max(contact.stiffness, closest.stiffness) : contact.stiffness;
}

}  // namespace palpate
