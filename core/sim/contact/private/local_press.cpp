// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/contact/private/local_press.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace palpate {
namespace {

/// Of the force on a half space at large depth, fitted to neo-Hookean solutions, up to two radii;
/// beyond, the force goes on along its tangent [contact: near field].
constexpr double kFirst = -0.1327, kSecond = -0.0104, kDeepest = 2.0;

/// Of the part of a capsule between its ends [contact: capsules]: where it is shorter than the
/// second number of radii its end takes the place of a length that the fit does not know.
constexpr double kLine = 2.027, kLineDepth = -0.166, kLineLength = 0.381, kShortest = 0.1;

/// Least part of its radius at which a capsule is pressed: the logarithm of none has no value.
constexpr double kShallowest = 1e-4;

/// To which a capsule's part that the mesh has left is found [-].
constexpr double kClose = 1e-9;

}  // namespace

double measure_cut(double radius, double length, double depth) noexcept {
  const double squared = measure_cut(radius, depth);
  if (length == 0.0) return squared;
  return squared + 2.0 * std::numbers::inv_pi * length * std::sqrt(squared);
}

/// [N] E* L s / (2.027 - 0.166 ln(s/R) + 0.381 ln(L/R)).
double LocalPress::compute_line(double s) const noexcept {
  if (length == 0.0) return 0.0;
  const double x = std::max(s / radius, kShallowest), l = std::max(length / radius, kShortest);
  return modulus * length * s / (kLine + kLineDepth * std::log(x) + kLineLength * std::log(l));
}

double LocalPress::compute_line_slope(double s) const noexcept {
  if (length == 0.0) return 0.0;
  const double x = std::max(s / radius, kShallowest), l = std::max(length / radius, kShortest);
  const double all = kLine + kLineDepth * std::log(x) + kLineLength * std::log(l);
  const double turns = x > kShallowest ? kLineDepth / all : 0.0;
  return modulus * length / all * (1.0 - turns);
}

double LocalPress::compute_force(double s) const noexcept {
  const double inverse = std::max(1.0 / radius + curvature, 0.1 / radius);
  const double most = kDeepest * radius, in = std::min(s, most), x = in / radius;
  const double hertz = 4.0 / 3.0 * modulus * std::sqrt(in / inverse) * in + compute_line(in);
  const double force = hertz * (1.0 + x * (kFirst + x * kSecond));
  return s > most ? force + (s - most) * compute_slope(most) : force;
}

double LocalPress::compute_slope(double s) const noexcept {
  const double inverse = std::max(1.0 / radius + curvature, 0.1 / radius);
  const double in = std::min(s, kDeepest * radius), x = in / radius;
  const double ends = 2.0 * modulus * std::sqrt(in / inverse) *
                      (1.0 + x * (5.0 / 3.0 * kFirst + x * 7.0 / 3.0 * kSecond));
  if (length == 0.0) return ends;
  return ends + compute_line_slope(in) * (1.0 + x * (kFirst + x * kSecond)) +
         compute_line(in) * (kFirst + x * 2.0 * kSecond) / radius;
}

/// With dC a_now/a(s) in place of dC, and F of a flat surface,
///
///     s - dC F(s) a_now/a(s) = depth
///
/// has one root; with dC itself it would have none where a patch is wider than elements are, for a
/// mesh that gives way as tissue does takes 4/5 of any dent. a is the radius of contact: where the
/// mesh has taken nothing the ball cuts a flat surface, sqrt(2) times as wide as it is touched
/// [Hertz82], a(s)² = s (2R - s)/2, and where it has taken those 4/5 the surface lies against the
/// ball. Between the two, a_now² goes with the part y = depth/s that the mesh has left: (1/2 +
/// (1 - y) 5/8) area/pi. F(s)/a(s) is 4/3 E* s at small depth, and a third more at 3R/2 where the
/// mesh has taken nothing; where it lies against the ball that is in a_now already. So the more
/// counts in proportion to y, and is taken along from step to step. Under a capsule a is that of a
/// circle as large as what is touched, and F(s)/a(s) at small depth that of both terms.
double LocalPress::find_depth(double depth, double area) const noexcept {
  const LocalPress flat{modulus, radius, 0.0, 0.0, length};
  const double widest = std::sqrt(area * std::numbers::inv_pi);
  double y = 1.0;
  for (int i = 0; i < 8; ++i) {
    const double s = depth / y, half = std::sqrt(0.5 * measure_cut(radius, s));
    const double touched =
        length == 0.0 ? half : std::sqrt(half * (half + 2.0 * std::numbers::inv_pi * length));
    const double first = length == 0.0
                             ? 4.0 / 3.0 * modulus
                             : (4.0 / 3.0 * modulus * half + compute_line(s) / s) / touched;
    const double deeper = flat.compute_force(s) / (first * touched * s) - 1.0;
    const double share = first * (1.0 + y * deeper) * widest * mesh_compliance;
    const double root = std::sqrt(std::max(0.05, 1.125 - 0.625 * y));
    const double slope = 1.0 - 0.3125 * share / root;
    if (!(slope > 0.1)) return depth / kLeastLeft;
    const double last =
        std::exchange(y, std::clamp(y - (y + share * root - 1.0) / slope, kLeastLeft, kMostLeft));
    if (std::abs(y - last) <= (length == 0.0 ? 0.0 : kClose)) break;
  }
  return depth / y;
}

/// F rises with s, so there is one root; both bounds that begin are above it, and from above Newton
/// comes down to it.
double LocalPress::find_depth_on(double depth, double more) const noexcept {
  if (!(depth > 0.0)) return 0.0;
  const double whole = more * compute_force(depth);
  double s = whole > depth ? depth * std::cbrt(depth / whole * (depth / whole)) : depth;
  for (int i = 0; i < 12; ++i) {
    const double step = (s + more * compute_force(s) - depth) / (1.0 + more * compute_slope(s));
    s = std::clamp(s - step, 1e-3 * s, depth);
    if (std::abs(step) < 1e-12 * depth) break;
  }
  return s;
}

}  // namespace palpate
