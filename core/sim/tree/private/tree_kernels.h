// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>

#include "palpate/sim/tree/private/collector.h"
#include "palpate/sim/tree/private/crossing.h"

namespace palpate::tree_kernels {

/// [-] A triangle is no sliver whose sine has a square above this.
inline constexpr double kHealthySquare = 1e-6;

/// [-] Two triangles of a common edge have the same nearest point, but for rounding.
inline constexpr double kTie = 1e-9;

/// Four points, and for each some triangles of one surface, one at least.
struct FourLists {
  std::array<const Vec3*, 4> points;  ///< [m]
  std::array<std::span<const int>, 4> triangles;
};

/// Of each list the triangle that is nearest to its point; of those that share the nearest point,
/// the one that the point is highest over or deepest under. As NearPoint, lane by lane.
struct FourNearest {
  alignas(32) double weights[3][4], offset[3][4], normal[3][4];
  alignas(32) double square[4], height[4], triangle[4];
};

/// The refit and the walks through a tree, compiled for one kind of vector. All of them do the
/// operations of box.h and find_closest_on_triangle in the same order, four at a time: the answers
/// are the same bits on every machine.
struct Kernels {
  const char* target = nullptr;

  /// Steps `begin` to `end` of bringing the boxes of `nodes` up to positions x.
  void (*refit)(std::span<const Vec3> x, std::size_t begin, std::size_t end, TreeRefit& refit,
                std::span<AabbTree::Node> nodes) noexcept = nullptr;
  /// The same for what TreeRefit lists as moving.
  void (*refit_moving)(std::span<const Vec3> x, TreeRefit& refit,
                       std::span<AabbTree::Node> nodes) noexcept = nullptr;
  /// The first triangle along `segment`; `length` [m] per parameter.
  std::optional<SurfacePoint> (*find_first_hit)(const AabbTree& tree, std::span<const Vec3> x,
                                                const Segment& segment,
                                                double length) noexcept = nullptr;
  /// The triangle closest to p within max_distance [m], the lowest of those as close; -1 for none.
  int (*find_closest)(const AabbTree& tree, std::span<const Vec3> x, const Vec3& p,
                      double max_distance) noexcept = nullptr;
  /// Triangles with a point within `radius` [m] of the centre.
  void (*collect_in_sphere)(const AabbTree& tree, std::span<const Vec3> x, const Vec3& centre,
                            double radius, Collector& collector) noexcept = nullptr;
  /// Triangles whose grown boxes `segment` enters.
  void (*collect_near_segment)(const AabbTree& tree, std::span<const Vec3> x,
                               const Segment& segment, Collector& collector) noexcept = nullptr;
  /// All triangles of the leaves whose grown boxes `segment` enters; how many.
  int (*list_near_segment)(const AabbTree& tree, const Segment& segment,
                           std::span<int> out) noexcept = nullptr;
  /// The nearest of lists; bits of those that have no sliver, for which alone it is right.
  unsigned (*find_nearest_listed)(std::span<const Triangle> triangles, std::span<const Vec3> x,
                                  const FourLists& lists, FourNearest& found) noexcept = nullptr;
};

/// Those this machine can run, the best first; plain code is always the last.
std::span<const Kernels* const> available() noexcept;

const Kernels& best() noexcept;
const Kernels& plain() noexcept;

}  // namespace palpate::tree_kernels
