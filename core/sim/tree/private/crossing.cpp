// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tree/private/crossing.h"

#include <algorithm>

namespace palpate {
namespace {

// weights of a triangle seen edge on are noise; a crossing whose point lies farther than this
// part of the triangle's extent beside the segment is none
constexpr double kBeside = 1e-6;

/// The crossing of a segment with a triangle [Woop13]: in sheared coordinates the segment is the z
/// axis, and it passes inside where the three edge functions u, v, w have one sign. Neighbours
/// compute the function of their common edge from the same products, so one of the two sees the
/// segment pass. Its ends count, by `tolerance` in parameters of the segment.
std::optional<Vec3> find_crossing(const Shear& shear, const Segment& segment, const Vec3& a_given,
                                  const Vec3& b_given, const Vec3& c_given, double tolerance,
                                  double& parameter) noexcept {
  const Vec3 a = shear.apply(a_given - segment.from);
  const Vec3 b = shear.apply(b_given - segment.from);
  const Vec3 c = shear.apply(c_given - segment.from);
  const double u = c.x() * b.y() - c.y() * b.x();
  const double v = a.x() * c.y() - a.y() * c.x();
  const double w = b.x() * a.y() - b.y() * a.x();
  if (std::min(std::min(u, v), w) < 0.0 && std::max(std::max(u, v), w) > 0.0) return std::nullopt;
  const double determinant = u + v + w;
  if (determinant == 0.0) return std::nullopt;

  const Vec3 weights = Vec3(u, v, w) / determinant;
  const Vec3 point = weights[0] * a + weights[1] * b + weights[2] * c;
  if (!(point.z() >= -tolerance && point.z() <= segment.end + tolerance)) return std::nullopt;
  const double extent = a.head<2>()
                            .cwiseAbs()
                            .cwiseMax(b.head<2>().cwiseAbs())
                            .cwiseMax(c.head<2>().cwiseAbs())
                            .maxCoeff();
  if (!(point.head<2>().cwiseAbs().maxCoeff() <= kBeside * extent)) return std::nullopt;
  parameter = std::clamp(point.z(), 0.0, segment.end);
  return weights;
}

}  // namespace

double compute_slack(const Vec3& low, const Vec3& high, const Vec3& from, const Vec3& to) noexcept {
  const Vec3 largest =
      low.cwiseAbs().cwiseMax(high.cwiseAbs()).cwiseMax(from.cwiseAbs()).cwiseMax(to.cwiseAbs());
  return 16.0 * std::numeric_limits<double>::epsilon() * largest.maxCoeff();
}

std::optional<SurfacePoint> find_hit(const Shear& shear, Segment segment, double length,
                                     const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const Box box = bound_triangle(a, b, c);
  segment.grow = compute_slack(box.low, box.high, segment.from, segment.from);
  const double in = enter_box(segment, box.low, box.high);
  if (in > std::numeric_limits<double>::max()) return std::nullopt;
  double parameter = 0.0;
  const auto w = find_crossing(shear, segment, a, b, c, segment.grow / length, parameter);
  if (!w) return std::nullopt;
  // no triangle is reached before its box: with this, pruning by boxes is exact
  return SurfacePoint{-1, *w, (*w)[0] * a + (*w)[1] * b + (*w)[2] * c,
                      std::max(parameter, in) * length};
}

}  // namespace palpate
