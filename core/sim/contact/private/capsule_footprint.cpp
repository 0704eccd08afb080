// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "palpate/sim/contact/private/capsule_slices.h"
#include "palpate/sim/contact/private/footprint.h"

namespace palpate {
namespace {

/// A footprint with less than that part of E* R² is none.
constexpr double kLeastPart = 1e-12;

double square(double x) noexcept { return x * x; }

/// What of the axis is the nearest to the plane's point (s, y) straight up, where the capsule's
/// lower side is the lowest: `beyond` it lies along the plane.
struct Column {
  double along = 0.0, beyond = 0.0, above = 0.0, overlap = 0.0;  // [m]
};

Column find_column(const Strip& strip, double s, double y) noexcept {
  const double squared_half = square(strip.law.radius) - square(y);
  const double half = std::sqrt(std::max(0.0, squared_half));
  Column column;
  column.along = strip.flat > kUpright
                     ? std::clamp((s - strip.rise * half) / strip.flat, strip.first, strip.last)
                     : strip.first;
  column.beyond = s - column.along * strip.flat;
  column.above = std::sqrt(std::max(0.0, squared_half - square(column.beyond)));
  column.overlap = column.above - strip.height_at(column.along);
  return column;
}

/// [m] How far the footprint goes to either side at s.
double find_half_width(const Strip& strip, double s) noexcept {
  const double along =
      std::clamp(s * strip.flat - strip.height * strip.rise, strip.first, strip.last);
  const double squared = square(s - along * strip.flat) + square(strip.height_at(along));
  return std::sqrt(std::max(0.0, square(strip.law.radius) - squared));
}

/// [m] Where the footprint begins and ends.
double find_begin(const Strip& strip) noexcept {
  const double squared = square(strip.law.radius) - square(strip.height_at(strip.first));
  return strip.first * strip.flat - std::sqrt(std::max(0.0, squared));
}

double find_end(const Strip& strip) noexcept {
  const double at = strip.rise > 0.0
                        ? std::clamp((strip.law.radius * strip.flat - strip.height) / strip.rise,
                                     strip.first, strip.last)
                        : strip.last;
  const double squared = square(strip.law.radius) - square(strip.height_at(at));
  return at * strip.flat + std::sqrt(std::max(0.0, squared));
}

/// A slice across the axis at s, from y0 to y1. With y = half sin(angle) the pressure, which goes
/// as the root of the distance to the rim, is smooth in the angle.
void add_slice(const Strip& strip, double s, double width, double y0, double y1,
               SliceSums& sums) noexcept {
  const double half = find_half_width(strip, s);
  if (!(half > 0.0)) return;
  const double from = std::asin(std::clamp(y0 / half, -1.0, 1.0));
  const double to = std::asin(std::clamp(y1 / half, -1.0, 1.0));
  if (!(to > from)) return;
  for (std::size_t i = 0; i < kAcrossNodes.size(); ++i) {
    const double angle = from + kAcrossNodes[i] * (to - from), y = half * std::sin(angle);
    const double part = width * kAcrossWeights[i] * (to - from) * half * std::cos(angle);
    const Column column = find_column(strip, s, y);
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
Slices list_slices(std::array<double, 5> kinks, double begin, double end) noexcept {
  std::sort(kinks.begin(), kinks.end());
  Slices slices;
  double from = begin;
  for (std::size_t k = 0; k <= kinks.size(); ++k) {
    const double to = k < kinks.size() ? std::clamp(kinks[k], from, end) : end;
    for (std::size_t i = 0; to > from && i < kSliceNodes.size(); ++i) {
      slices.at[slices.count] = from + kSliceNodes[i] * (to - from);
      slices.width[slices.count++] = kSliceWeights[i] * (to - from);
    }
    from = to;
  }
  return slices;
}

void sum_slices(const Strip& strip, const Corners& corners, Slices& slices,
                SliceSums& sums) noexcept {
  for (std::size_t k = 0; k < slices.count; ++k) {
    const auto [low, high] = find_chord(corners, slices.at[k]);
    if (high > low) add_slice(strip, slices.at[k], slices.width[k], low, high, sums);
  }
}

/// [N] What the pressures on the plane would be without an end of the triangle: of one that is far
/// wider than the footprint.
double integrate_whole(const Strip& strip, SumSlices sum) noexcept {
  const double start = strip.first * strip.flat, stop = strip.last * strip.flat;
  const double far = 100.0 * (strip.law.radius + strip.last);
  Slices slices =
      list_slices({start, start, start, stop, stop}, find_begin(strip), find_end(strip));
  SliceSums sums;
  sum(strip, {{{-far, -far}, {far, -far}, {0.0, far}}}, slices, sums);
  return sums.force;
}

/// A capsule over a triangle's plane.
struct Section {
  explicit Section(const NearPressure& law) noexcept : strip{law} {}
  Strip strip;
  Vec3 low, direction;               // the axis' lower end [m], and unit from there
  Vec3 normal, along, beside, foot;  // of the plane: unit, along the axis, beside it; [m] below low
  double twice_area = 0.0;           // [m²]
};

/// False where the triangle has no plane, or the capsule does not reach it from its front.
bool find_section(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b, const Vec3& c,
                  Section& section) noexcept {
  Strip& strip = section.strip;
  const Vec3 across = (b - a).cross(c - a);
  section.twice_area = across.norm();
  if (!(section.twice_area > 0.0)) return false;
  const Vec3 normal = across / section.twice_area;
  const bool turned = (to - from).dot(normal) < 0.0;
  const Vec3 &low = turned ? to : from, &high = turned ? from : to;
  const double length = (high - low).norm();
  const Vec3 direction = length > 0.0 ? Vec3((high - low) / length) : Vec3(Vec3::Zero());
  strip.rise = std::clamp(direction.dot(normal), 0.0, 1.0);
  strip.height = (low - a).dot(normal);
  const Vec3 flat = direction - strip.rise * normal;
  strip.flat = flat.norm();
  section.along = strip.flat > kUpright ? Vec3(flat / strip.flat) : Vec3((b - a).normalized());
  section.beside = normal.cross(section.along);
  section.foot = low - strip.height * normal;
  section.low = low;
  section.direction = direction;
  section.normal = normal;
  strip.last = length;
  if (strip.height < 0.0) {
    if (!(strip.height_at(length) > 0.0)) return false;
    strip.first = -strip.height / strip.rise;
  }
  if (!(strip.height_at(strip.first) < strip.law.radius)) return false;
  if (strip.height_at(length) > strip.law.radius) {
    strip.last = std::max(strip.first, (strip.law.radius - strip.height) / strip.rise);
  }
  return true;
}

}  // namespace

/// The footprint is cut into slices across the axis. Under a slice the capsule's lower side is that
/// of the ball about the point of the axis where it is lowest, and presses along the plane's normal
/// and, with its slope, aside, as a ball does [contact: capsules].
bool integrate_capsule_footprint(const NearPressure& law, const Vec3& from, const Vec3& to,
                                 const Vec3& a, const Vec3& b, const Vec3& c, Footprint& footprint,
                                 bool whole, SumSlices sum) noexcept {
  if (sum == nullptr) sum = sum_slices;
  Section section(law);
  if (!find_section(from, to, a, b, c, section)) return false;
  const Strip& strip = section.strip;
  const Vec3 &along = section.along, &beside = section.beside, &normal = section.normal;
  const Vec3& foot = section.foot;

  Corners corners;
  double begin = std::numeric_limits<double>::infinity(), end = -begin;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 corner = (k == 0 ? a : k == 1 ? b : c) - foot;
    corners[k] = {corner.dot(along), corner.dot(beside)};
    begin = std::min(begin, corners[k][0]);
    end = std::max(end, corners[k][0]);
  }
  begin = std::max(begin, find_begin(strip));
  end = std::min(end, find_end(strip));
  if (!(end > begin)) return false;
  Slices slices = list_slices({corners[0][0], corners[1][0], corners[2][0],
                               strip.first * strip.flat, strip.last * strip.flat},
                              begin, end);
  SliceSums sums;
  sum(strip, corners, slices, sums);
  // less is rounding, and its middle would be anywhere
  if (!(sums.force > kLeastPart * law.modulus * square(law.radius))) return false;
  const double on_plane = whole ? integrate_whole(strip, sum) : 0.0;

  const double one = 1.0 / sums.force;
  const Vec3 y = foot + one * (sums.along_plane * along + sums.beside * beside) - a;
  const double v = normal.dot(y.cross(c - a)) / section.twice_area;
  const double w = normal.dot((b - a).cross(y)) / section.twice_area;
  const Vec3 middle = Vec3(1.0 - v - w, v, w).cwiseMax(0.0);
  const double at = sums.along_axis * one;
  footprint.normal_force = sums.force;
  footprint.whole_force = std::max(on_plane, sums.force);
  footprint.area = sums.area;
  footprint.normal = normal;
  footprint.force = sums.force * normal - sums.aside_along * along - sums.aside * beside;
  footprint.weights = middle / middle.sum();
  footprint.stiffness = sums.stiffness;
  footprint.depth = law.radius - strip.height_at(at);
  footprint.axis = section.low + at * section.direction;
  footprint.spread = std::max(0.0, sums.squared * one - at * at);
  return true;
}

double integrate_capsule_plane(const NearPressure& law, const Vec3& from, const Vec3& to,
                               const Vec3& a, const Vec3& b, const Vec3& c,
                               SumSlices sum) noexcept {
  Section section(law);
  if (!find_section(from, to, a, b, c, section)) return 0.0;
  return integrate_whole(section.strip, sum == nullptr ? sum_slices : sum);
}

}  // namespace palpate
