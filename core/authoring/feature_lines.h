// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// [rad] A ridge turns by at least so much.
inline constexpr double kRidgeTurn = 60.0 * 3.14159265358979323846 / 180.0;

/// What of a surface becomes lines.
struct LineOptions {
  std::span<const int> regions;  ///< a number per triangle, or none at all
  std::span<const int> names;    ///< the same
  bool ridges = false;           ///< edges that turn by kRidgeTurn and more
  double least_length = 0.0;     ///< [m] ridges that hang together are this long, or are noise
};

/// A run of edges from corner to corner, or round.
struct Line {
  Vec3Array points;  ///< [m]
  bool closed = false;
};

/// Lines on a surface that a coarser one keeps: its ridges, and the borders between regions. They
/// meet and end in corners; one that reaches the border of the surface ends there.
struct FeatureLines {
  static constexpr int kNone = -1, kCorner = -2;

  std::vector<Line> lines;
  std::vector<int> line;                ///< per vertex: its line, kCorner or kNone
  std::vector<std::vector<int>> links;  ///< per vertex: neighbours along lines

  bool empty() const { return lines.empty(); }
  /// Vertices that no coarser surface with these lines can be without.
  int count_needed() const;
  /// [m] of all lines together.
  double length() const;
  /// The point of a line next to `p`.
  Vec3 find_closest(int number, const Vec3& p) const;
  /// Edges of lines, ascending.
  std::vector<std::array<int, 2>> list_edges() const;
};

/// `mesh` must pass validate(); `regions` and `names` have a number for each triangle, or are
/// empty.
FeatureLines find_feature_lines(const SurfaceMesh& mesh, const LineOptions& options);

/// The same lines on the surface whose vertex i was vertex source[i]; `links` are in the numbers
/// of the source.
FeatureLines renumber(const FeatureLines& lines, const std::vector<std::vector<int>>& links,
                      std::span<const int> source);

}  // namespace palpate::authoring
