// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/footprint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace palpate {
namespace {

/// Gauss and Legendre, three points on 0 to 1.
constexpr std::array<double, 3> kNodes = {0.1127016653792583, 0.5, 0.8872983346207417};
constexpr std::array<double, 3> kWeights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

/// Sums along a ray from the circle's centre to the distance rho, over r dr / rho²; the moment over
/// r² dr / rho³, what goes sideways with the tangent of the ball's slope.
struct Ray {
  double force = 0.0;      // [Pa]
  double stiffness = 0.0;  // [N/m³]
  double moment = 0.0;     // [Pa]
  double sideways = 0.0;   // [Pa/m]
};

/// The circle that the ball cuts out of a plane.
struct Circle {
  const NearPressure& law;
  double height = 0.0;  // [m] of the ball's centre above the plane
  double squared_radius = 0.0;

  /// With r = rho sqrt(1 - t²) the pressure, which goes as the root of the distance to the rim, is
  /// smooth in t.
  Ray integrate_to(double squared_rho) const noexcept {
    Ray ray;
    const double squared_ball = law.radius * law.radius;
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      const double t = kNodes[i], part = kWeights[i] * t, left = 1.0 - t * t;
      const double above = std::sqrt(squared_ball - squared_rho * left);
      const double overlap = above - height;
      const double p = law.pressure(overlap), lever = part * std::sqrt(left) * p;
      ray.force += part * p;
      ray.stiffness += part * law.slope(overlap);
      ray.moment += lever;
      ray.sideways += lever / above;
    }
    return ray;
  }
};

/// Sums over the footprint, in the plane: about the circle's centre.
struct Sums {
  double force = 0.0, stiffness = 0.0, area = 0.0;
  Vec3 moment = Vec3::Zero(), sideways = Vec3::Zero();
};

/// The triangle between the circle's centre and the part from t0 to t1 of the edge from `from`
/// along `edge`, which lies inside the circle. `twice_area` of the triangle with the whole edge.
void add_inside(const Circle& circle, const Vec3& from, const Vec3& edge, double t0, double t1,
                double twice_area, Sums& sums) noexcept {
  sums.area += 0.5 * (t1 - t0) * twice_area;
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    const Vec3 y = from + (t0 + kNodes[i] * (t1 - t0)) * edge;
    const double part = kWeights[i] * (t1 - t0) * twice_area;
    const Ray ray = circle.integrate_to(std::min(y.squaredNorm(), circle.squared_radius));
    sums.force += part * ray.force;
    sums.stiffness += part * ray.stiffness;
    sums.moment += part * ray.moment * y;
    sums.sideways += part * ray.sideways * y;
  }
}

/// The sector of the circle between two directions, both from its centre.
void add_sector(const Circle& circle, const Ray& to_rim, const Vec3& normal, const Vec3& from,
                const Vec3& to, Sums& sums) noexcept {
  // a corner in the centre itself has no direction, and what lies towards it no angle
  if (!(from.squaredNorm() > 0.0 && to.squaredNorm() > 0.0)) return;
  const double angle = std::atan2(normal.dot(from.cross(to)), from.dot(to));
  const double radius = std::sqrt(circle.squared_radius);
  // the integral of unit vectors over the angle is the difference of the ends, turned back
  const Vec3 turned = (to / to.norm() - from / from.norm()).cross(normal);
  sums.area += 0.5 * circle.squared_radius * angle;
  sums.force += circle.squared_radius * angle * to_rim.force;
  sums.stiffness += circle.squared_radius * angle * to_rim.stiffness;
  sums.moment += circle.squared_radius * radius * to_rim.moment * turned;
  sums.sideways += circle.squared_radius * radius * to_rim.sideways * turned;
}

/// A triangle is the sum of three with a corner in the circle's centre, one for each edge and with
/// the sign of its area; what of these lies beyond the circle is a sector of it.
void add_edge(const Circle& circle, const Ray& to_rim, const Vec3& normal, const Vec3& from,
              const Vec3& to, Sums& sums) noexcept {
  const Vec3 edge = to - from;
  const double squared_length = edge.squaredNorm();
  if (!(squared_length > 0.0)) return;
  const double along = from.dot(edge);
  const double root = along * along - squared_length * (from.squaredNorm() - circle.squared_radius);
  double t0 = 1.0, t1 = 1.0;
  if (root > 0.0) {
    const double half = std::sqrt(root);
    t0 = std::clamp((-along - half) / squared_length, 0.0, 1.0);
    t1 = std::clamp((-along + half) / squared_length, 0.0, 1.0);
  }
  if (!(t1 > t0)) return add_sector(circle, to_rim, normal, from, to, sums);
  const Vec3 enters = from + t0 * edge, leaves = from + t1 * edge;
  if (t0 > 0.0) add_sector(circle, to_rim, normal, from, enters, sums);
  add_inside(circle, from, edge, t0, t1, normal.dot(from.cross(to)), sums);
  if (t1 < 1.0) add_sector(circle, to_rim, normal, leaves, to, sums);
}

/// Of the point y, given from corner a.
Vec3 find_weights(const Vec3& ab, const Vec3& ac, const Vec3& normal, double twice_area,
                  const Vec3& y) noexcept {
  const double v = normal.dot(y.cross(ac)) / twice_area;
  const double w = normal.dot(ab.cross(y)) / twice_area;
  return {1.0 - v - w, v, w};
}

}  // namespace

double NearPressure::pressure(double overlap) const noexcept {
  if (!(overlap > 0.0)) return 0.0;
  const double x = overlap / radius;
  return std::min(stiffness * overlap, modulus * std::numbers::inv_pi * std::sqrt(x) *
                                           (1.0 + x * (kFirstOfPressure + x * kSecondOfPressure)));
}

double NearPressure::slope(double overlap) const noexcept {
  if (!(overlap > 0.0)) return 0.0;
  const double x = overlap / radius;
  return std::min(stiffness,
                  modulus * std::numbers::inv_pi / (radius * std::sqrt(x)) *
                      (0.5 + x * (1.5 * kFirstOfPressure + x * 2.5 * kSecondOfPressure)));
}

bool integrate_footprint(const NearPressure& law, const Vec3& centre, const Vec3& a, const Vec3& b,
                         const Vec3& c, Footprint& footprint) noexcept {
  const Vec3 ab = b - a, ac = c - a;
  const Vec3 across = ab.cross(ac);
  const double twice_area = across.norm();
  if (!(twice_area > 0.0)) return false;
  const Vec3 normal = across / twice_area;
  const double height = (centre - a).dot(normal);
  if (!(height > 0.0 && height < law.radius)) return false;

  const Circle circle{law, height, law.radius * law.radius - height * height};
  const Ray to_rim = circle.integrate_to(circle.squared_radius);
  const Vec3 foot = centre - height * normal;
  const std::array<Vec3, 3> corners = {a - foot, b - foot, c - foot};
  Sums sums;
  for (std::size_t k = 0; k < 3; ++k) {
    add_edge(circle, to_rim, normal, corners[k], corners[(k + 1) % 3], sums);
  }
  // outside of the circle sectors cancel but for rounding
  const double whole = 2.0 * std::numbers::pi * circle.squared_radius * to_rim.force;
  if (!(sums.force > 1e-9 * whole)) return false;

  const Vec3 middle = find_weights(ab, ac, normal, twice_area, foot + sums.moment / sums.force - a);
  footprint.normal_force = sums.force;
  footprint.whole_force = whole;
  footprint.area = std::max(0.0, sums.area);
  footprint.normal = normal;
  footprint.force = sums.force * normal - sums.sideways;
  footprint.weights = middle.cwiseMax(0.0) / middle.cwiseMax(0.0).sum();
  footprint.stiffness = std::max(0.0, sums.stiffness);
  footprint.depth = law.radius - height;
  footprint.axis = centre;
  footprint.spread = 0.0;
  return true;
}

}  // namespace palpate
