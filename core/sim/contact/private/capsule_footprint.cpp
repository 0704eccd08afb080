// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "palpate/sim/contact/private/footprint.h"

namespace palpate {
namespace {

/// Gauss and Legendre on 0 to 1: three points along the axis, four across it.
constexpr std::array<double, 3> kNodes = {0.1127016653792583, 0.5, 0.8872983346207417};
constexpr std::array<double, 3> kWeights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
constexpr std::array<double, 4> kFineNodes = {0.0694318442029737, 0.3300094782075719,
                                              0.6699905217924281, 0.9305681557970263};
constexpr std::array<double, 4> kFineWeights = {0.1739274225687269, 0.3260725774312731,
                                                0.3260725774312731, 0.1739274225687269};

/// Cosine below which an axis has no direction along a plane.
constexpr double kUpright = 1e-9;

double square(double x) noexcept { return x * x; }

/// The part of a capsule's axis that lies above a plane and within a radius of it: seen from the
/// plane, where s goes along it from the foot of the axis' start, and y beside it.
struct Strip {
  const NearPressure& law;
  double flat = 1.0, rise = 0.0;   // of the unit vector along the axis: along the plane, off it
  double height = 0.0;             // [m] of its start, which is the lower end
  double first = 0.0, last = 0.0;  // [m] along the axis

  double height_at(double along) const noexcept { return height + along * rise; }

  /// What of the axis is the nearest to the plane's point (s, y) straight up, where the capsule's
  /// lower side is the lowest: `beyond` it lies along the plane.
  struct Column {
    double along = 0.0, beyond = 0.0, above = 0.0, overlap = 0.0;  // [m]
  };

  Column find(double s, double y) const noexcept {
    const double squared_half = square(law.radius) - square(y);
    const double half = std::sqrt(std::max(0.0, squared_half));
    Column column;
    column.along = flat > kUpright ? std::clamp((s - rise * half) / flat, first, last) : first;
    column.beyond = s - column.along * flat;
    column.above = std::sqrt(std::max(0.0, squared_half - square(column.beyond)));
    column.overlap = column.above - height_at(column.along);
    return column;
  }

  /// [m] How far the footprint goes to either side at s.
  double half_width(double s) const noexcept {
    const double along = std::clamp(s * flat - height * rise, first, last);
    const double squared = square(s - along * flat) + square(height_at(along));
    return std::sqrt(std::max(0.0, square(law.radius) - squared));
  }

  /// [m] Where the footprint ends.
  double begin() const noexcept {
    return first * flat - std::sqrt(std::max(0.0, square(law.radius) - square(height_at(first))));
  }
  double end() const noexcept {
    const double at =
        rise > 0.0 ? std::clamp((law.radius * flat - height) / rise, first, last) : last;
    return at * flat + std::sqrt(std::max(0.0, square(law.radius) - square(height_at(at))));
  }
};

/// Sums over the footprint, in the plane.
struct Sums {
  double force = 0.0, stiffness = 0.0, area = 0.0;
  double along_plane = 0.0, beside = 0.0;  // moments of the pressure
  double aside_along = 0.0, aside = 0.0;   // what goes sideways with the slope of the capsule
  double along_axis = 0.0, squared = 0.0;  // moments of the places on the axis
};

/// A slice across the axis at s, from y0 to y1. With y = half sin(angle) the pressure, which goes
/// as the root of the distance to the rim, is smooth in the angle.
void add_slice(const Strip& strip, double s, double width, double y0, double y1,
               Sums& sums) noexcept {
  const double half = strip.half_width(s);
  if (!(half > 0.0)) return;
  const double from = std::asin(std::clamp(y0 / half, -1.0, 1.0));
  const double to = std::asin(std::clamp(y1 / half, -1.0, 1.0));
  if (!(to > from)) return;
  for (std::size_t i = 0; i < kFineNodes.size(); ++i) {
    const double angle = from + kFineNodes[i] * (to - from), y = half * std::sin(angle);
    const double part = width * kFineWeights[i] * (to - from) * half * std::cos(angle);
    const Strip::Column column = strip.find(s, y);
    const double p = part * strip.law.pressure(column.overlap);
    sums.area += part;
    sums.force += p;
    sums.stiffness += part * strip.law.slope(column.overlap);
    sums.along_plane += p * s;
    sums.beside += p * y;
    if (column.above > 0.0) {
      sums.aside_along += p * column.beyond / column.above;
      sums.aside += p * y / column.above;
    }
    sums.along_axis += p * column.along;
    sums.squared += p * square(column.along);
  }
}

/// A triangle in the plane: s and y of its corners.
using Corners = std::array<std::array<double, 2>, 3>;

/// The part of a line across the axis at s that lies inside the triangle; empty where none does.
std::pair<double, double> find_chord(const Corners& corners, double s) noexcept {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &a = corners[k], &b = corners[(k + 1) % 3];
    if ((a[0] < s) == (b[0] < s)) continue;
    const double y = a[1] + (s - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
    low = std::min(low, y);
    high = std::max(high, y);
  }
  return {low, high};
}

/// Slices between the places where the integral over one has a kink: corners, and the ends of the
/// axis.
template <class Chord>
void add_slices(const Strip& strip, std::array<double, 5> kinks, double begin, double end,
                Chord chord, Sums& sums) noexcept {
  std::sort(kinks.begin(), kinks.end());
  double from = begin;
  for (std::size_t k = 0; k <= kinks.size(); ++k) {
    const double to = k < kinks.size() ? std::clamp(kinks[k], from, end) : end;
    for (std::size_t i = 0; to > from && i < kNodes.size(); ++i) {
      const double s = from + kNodes[i] * (to - from);
      const auto [low, high] = chord(s);
      if (high > low) add_slice(strip, s, kWeights[i] * (to - from), low, high, sums);
    }
    from = to;
  }
}

/// [N] What the pressures on the plane would be without an end of the triangle.
double integrate_whole(const Strip& strip) noexcept {
  Sums sums;
  const double start = strip.first * strip.flat, stop = strip.last * strip.flat;
  const double beyond = 2.0 * strip.law.radius;
  add_slices(
      strip, {start, start, start, stop, stop}, strip.begin(), strip.end(),
      [&](double) noexcept { return std::pair(-beyond, beyond); }, sums);
  return sums.force;
}

}  // namespace

/// The footprint is cut into slices across the axis. Under a slice the capsule's lower side is that
/// of the ball about the point of the axis where it is lowest, and presses along the plane's normal
/// and, with its slope, aside, as a ball does [contact: capsules].
bool integrate_capsule_footprint(const NearPressure& law, const Vec3& from, const Vec3& to,
                                 const Vec3& a, const Vec3& b, const Vec3& c,
                                 Footprint& footprint) noexcept {
  const Vec3 across = (b - a).cross(c - a);
  const double twice_area = across.norm();
  if (!(twice_area > 0.0)) return false;
  const Vec3 normal = across / twice_area;
  const bool turned = (to - from).dot(normal) < 0.0;
  const Vec3 &low = turned ? to : from, &high = turned ? from : to;
  const double length = (high - low).norm();
  const Vec3 direction = length > 0.0 ? Vec3((high - low) / length) : Vec3(Vec3::Zero());
  Strip strip{law};
  strip.rise = std::clamp(direction.dot(normal), 0.0, 1.0);
  strip.height = (low - a).dot(normal);
  const Vec3 flat = direction - strip.rise * normal;
  strip.flat = flat.norm();
  const Vec3 along = strip.flat > kUpright ? Vec3(flat / strip.flat) : Vec3((b - a).normalized());
  const Vec3 beside = normal.cross(along), foot = low - strip.height * normal;
  strip.last = length;
  if (strip.height < 0.0) {
    if (!(strip.height_at(length) > 0.0)) return false;
    strip.first = -strip.height / strip.rise;
  }
  if (!(strip.height_at(strip.first) < law.radius)) return false;
  if (strip.height_at(length) > law.radius) {
    strip.last = std::max(strip.first, (law.radius - strip.height) / strip.rise);
  }

  Corners corners;
  double begin = std::numeric_limits<double>::infinity(), end = -begin;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 corner = (k == 0 ? a : k == 1 ? b : c) - foot;
    corners[k] = {corner.dot(along), corner.dot(beside)};
    begin = std::min(begin, corners[k][0]);
    end = std::max(end, corners[k][0]);
  }
  begin = std::max(begin, strip.begin());
  end = std::min(end, strip.end());
  if (!(end > begin)) return false;
  Sums sums;
  add_slices(
      strip,
      {corners[0][0], corners[1][0], corners[2][0], strip.first * strip.flat,
       strip.last * strip.flat},
      begin, end, [&](double s) noexcept { return find_chord(corners, s); }, sums);
  if (!(sums.force > 0.0)) return false;
  const double whole = integrate_whole(strip);
  if (!(sums.force > 1e-9 * whole)) return false;

  const double one = 1.0 / sums.force;
  const Vec3 y = foot + one * (sums.along_plane * along + sums.beside * beside) - a;
  const double v = normal.dot(y.cross(c - a)) / twice_area;
  const double w = normal.dot((b - a).cross(y)) / twice_area;
  const Vec3 middle = Vec3(1.0 - v - w, v, w).cwiseMax(0.0);
  const double at = sums.along_axis * one;
  footprint.normal_force = sums.force;
  footprint.whole_force = std::max(whole, sums.force);
  footprint.area = sums.area;
  footprint.normal = normal;
  footprint.force = sums.force * normal - sums.aside_along * along - sums.aside * beside;
  footprint.weights = middle / middle.sum();
  footprint.stiffness = sums.stiffness;
  footprint.depth = law.radius - strip.height_at(at);
  footprint.axis = low + at * direction;
  footprint.spread = std::max(0.0, sums.squared * one - at * at);
  return true;
}

}  // namespace palpate
