// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/near_contact.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/contact/private/footprint.h"

namespace palpate {
namespace {

/// Of the force on a half space at large depth, fitted to neo-Hookean solutions, up to two radii;
/// beyond, the force goes on along its tangent [contact: near field].
constexpr double kFirst = -0.1327, kSecond = -0.0104, kDeepest = 2.0;

/// The mesh is taken to have left at least this part of the dent: beyond, its law folds back.
constexpr double kMostDepth = 2.0;

/// What a mesh may make of the pressures, either way.
constexpr double kLeastGain = 0.3, kMostGain = 8.0;

/// Part of the radius from which the hard law holds as well, so that nothing passes.
constexpr double kBarrierFrom = 0.5;

NearPressure make_law(const NearField& near, const Tool& tool) noexcept {
  return {near.modulus, tool.radius, tool.stiffness};
}

/// As the hard law fades for a triangle seen nearly edge-on.
double find_share(const Contact& closest, const Vec3& normal) noexcept {
  return std::clamp(closest.direction.dot(normal) / kFullFacing, 0.0, 1.0);
}

/// Sums over the footprints of one body, each weighted by its force.
struct Patch {
  double force = 0.0;      // [N]
  double whole = 0.0;      // [N²]
  double depth = 0.0;      // [N m]
  double far = 0.0;        // [m]
  double curvature = 0.0;  // [N/m]

  void add(const NearField& near, const Triangle& triangle, double share,
           const Footprint& part) noexcept {
    const double q = share * part.normal_force;
    force += q;
    whole += q * part.whole_force;
    depth += q * part.depth;
    for (std::size_t c = 0; c < 3; ++c) {
      const double at = q * part.weights[static_cast<Eigen::Index>(c)];
      far += at * near.far_compliance[static_cast<std::size_t>(triangle[c])];
      curvature += at * near.curvature[static_cast<std::size_t>(triangle[c])];
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

NearGain find_gain(const NearField& near, const Tool& tool, const Patch& patch,
                   double mesh_compliance) noexcept {
  LocalPress press{near.modulus, tool.radius, patch.curvature / patch.force, mesh_compliance};
  const double depth = patch.depth / patch.force, s = press.find_depth(depth);
  const double steep = press.compute_slope(s);
  const double left = 1.0 - mesh_compliance * steep;
  const LocalPress flat{near.modulus, tool.radius, 0.0, 0.0};
  NearGain gain;
  gain.force =
      std::clamp(press.compute_force(s) * patch.force / patch.whole, kLeastGain, kMostGain);
  gain.slope = std::clamp(steep / (std::max(left, 0.1) * flat.compute_slope(depth)), gain.force,
                          10.0 * kMostGain);
  return gain;
}

/// Pressures times the gain, and the barrier: what the hard law has beyond half a radius.
Contact combine(const Tool& tool, const Contact& closest, const Contact& soft,
                const NearGain& gain) noexcept {
  Contact contact = closest;
  const double depth = tool.radius - closest.distance;
  const double beyond = std::max(0.0, depth - kBarrierFrom * tool.radius);
  const double hard = closest.force * beyond / depth;
  const Vec3 sum = gain.force * soft.force * soft.direction + hard * closest.direction;
  const double force = sum.norm(), shares = gain.force * soft.force + hard;
  contact.force = force;
  contact.stiffness = gain.slope * soft.stiffness + (beyond > 0.0 ? closest.stiffness : 0.0);
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

/// Newton's steps from s = depth come from one side only, for F is convex; where dC > 0 the law
/// folds back at dC F' = 1, and there is no root beyond.
double LocalPress::find_depth(double depth) const noexcept {
  constexpr int kSteps = 8;
  double s = depth;
  for (int i = 0; i < kSteps; ++i) {
    const double left = 1.0 - mesh_compliance * compute_slope(s);
    if (!(left > 0.0)) return kMostDepth * depth;
    s -= (s - mesh_compliance * compute_force(s) - depth) / left;
    if (!(s < kMostDepth * depth)) return kMostDepth * depth;
  }
  return s;
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
    patch.add(near, t, share, part);
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

}  // namespace palpate
