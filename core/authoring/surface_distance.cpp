// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/surface_distance.h"

#include <algorithm>
#include <limits>

#include "palpate/authoring/triangle_shape.h"

namespace palpate::authoring {
namespace {

/// [-] How much more than a distance that was found the bound may be.
constexpr double kShare = 1e-2;
/// [-] The same of the diagonal, for surfaces that are nearly the same.
constexpr double kDiagonalShare = 1e-5;
/// Pieces that are looked at before bounds are taken as they are: a few seconds.
constexpr std::size_t kMostPieces = 3'000'000;
/// Cuts of a triangle within each other; halves of halves are then a thousand times smaller.
constexpr int kMostCuts = 60;

using Polygon = std::vector<Vec3>;  // convex, in one plane

/// [m] From p to a segment.
double distance_to_side(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length = along.squaredNorm();
  const double s = length > 0.0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (a + s * along - p).norm();
}

/// A triangle and the planes upright on its sides.
struct Prism {
  explicit Prism(const Corners& corners) : x(corners) {
    const Vec3 across = normal_of(x);
    const double length = across.norm();
    is_flat = !(length > 0.0);
    if (is_flat) return;
    normal = across / length;
    for (std::size_t c = 0; c < 3; ++c) {
      outward[c] = (x[(c + 1) % 3] - x[c]).cross(normal).normalized();
    }
  }

  /// [m] How far p is beyond the side from corner c to the next.
  double beyond(std::size_t c, const Vec3& p) const { return outward[c].dot(p - x[c]); }

  double distance(const Vec3& p) const {
    bool is_over = !is_flat;
    for (std::size_t c = 0; c < 3 && is_over; ++c) is_over = beyond(c, p) <= 0.0;
    if (is_over) return std::abs(normal.dot(p - x[0]));
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < 3; ++c) {
      least = std::min(least, distance_to_side(p, x[c], x[(c + 1) % 3]));
    }
    return least;
  }

  Corners x;
  Vec3 normal = Vec3::Zero();
  std::array<Vec3, 3> outward = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  bool is_flat = false;
};

/// A polygon on both sides of a plane; `at` is the corners' distance from it.
std::array<Polygon, 2> cut(const Polygon& polygon, const std::vector<double>& at) {
  std::array<Polygon, 2> sides;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    if (at[i] <= 0.0) sides[0].push_back(polygon[i]);
    if (at[i] >= 0.0) sides[1].push_back(polygon[i]);
    if ((at[i] < 0.0 && at[j] > 0.0) || (at[i] > 0.0 && at[j] < 0.0)) {
      const Vec3 p = polygon[i] + (polygon[j] - polygon[i]) * (at[i] / (at[i] - at[j]));
      sides[0].push_back(p);
      sides[1].push_back(p);
    }
  }
  return sides;
}

Vec3 middle_of(const Polygon& polygon) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : polygon) sum += p;
  return sum / static_cast<double>(polygon.size());
}

class Measuring {
 public:
  Measuring(const SurfaceMesh& from, const SurfaceMesh& onto, const SourceSurface& tree)
      : from_(from), onto_(onto), tree_(tree) {}

  SurfaceDistance measure() {
    Vec3 low = from_.vertices.front(), high = low;
    for (const Vec3& p : from_.vertices) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
      least_ = std::max(least_, (tree_.find_closest(p).point - p).norm());
    }
    slack_ = kDiagonalShare * (high - low).norm();
    double sum = 0.0, area = 0.0;
    for (const Triangle& t : from_.triangles) {
      const Corners x = corners_of(from_, t);
      const double part = 0.5 * normal_of(x).norm();
      sum += part * look_at({x[0], x[1], x[2]}, 0);
      area += part;
    }
    return {area > 0.0 ? sum / area : 0.0, least_, std::max(least_, most_)};
  }

 private:
  double enough() const { return std::max((1.0 + kShare) * least_, least_ + slack_); }

  /// Bounds the distance over a polygon, and returns it in the middle.
  double look_at(const Polygon& polygon, int cuts) {
    ++pieces_;
    const Vec3 middle = middle_of(polygon);
    const auto [point, triangle] = tree_.find_closest(middle);
    const double here = (point - middle).norm();
    least_ = std::max(least_, here);
    const Prism prism(corners_of(onto_, onto_.triangles[triangle]));
    double bound = 0.0, reach = 0.0;
    for (const Vec3& p : polygon) {
      bound = std::max(bound, prism.distance(p));
      reach = std::max(reach, (p - middle).norm());
    }
    bound = std::min(bound, here + reach);  // a step of a metre changes a distance by at most one
    if (bound <= enough() || cuts >= kMostCuts || pieces_ >= kMostPieces) {
      most_ = std::max(most_, bound);
      return here;
    }
    for (const Polygon& side : part(polygon, prism, middle)) look_at(side, cuts + 1);
    return here;
  }

  /// Where the nearest triangle ends, else in halves.
  static std::array<Polygon, 2> part(const Polygon& polygon, const Prism& prism,
                                     const Vec3& middle) {
    std::vector<double> at(polygon.size()), found;
    double furthest = 0.0;
    for (std::size_t c = 0; c < 3 && !prism.is_flat; ++c) {
      for (std::size_t i = 0; i < polygon.size(); ++i) at[i] = prism.beyond(c, polygon[i]);
      const auto [least, most] = std::minmax_element(at.begin(), at.end());
      // what would be cut off on the smaller side: slivers lead nowhere
      const double off = std::min(-*least, *most);
      if (off > furthest && off > 0.05 * (*most - *least)) {
        furthest = off;
        found = at;
      }
    }
    if (!found.empty()) return cut(polygon, found);
    Vec3 along = Vec3::Zero();
    for (const Vec3& p : polygon) {
      if ((p - middle).squaredNorm() > along.squaredNorm()) along = p - middle;
    }
    for (std::size_t i = 0; i < polygon.size(); ++i) at[i] = along.dot(polygon[i] - middle);
    return cut(polygon, at);
  }

  const SurfaceMesh& from_;
  const SurfaceMesh& onto_;
  const SourceSurface& tree_;
  double least_ = 0.0, most_ = 0.0, slack_ = 0.0;  // [m]
  std::size_t pieces_ = 0;
};

}  // namespace

SurfaceDistance measure_distance(const SurfaceMesh& from, const SurfaceMesh& onto,
                                 const SourceSurface& tree) {
  return Measuring(from, onto, tree).measure();
}

}  // namespace palpate::authoring
