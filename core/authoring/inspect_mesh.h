// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "palpate/authoring/measure_shape.h"

namespace palpate::authoring {

/// What a surface is like, for people: millimetres, millilitres and degrees. Absent is what is
/// not defined for it; no number is ever infinite or NaN.
struct MeshReport {
  int vertices = 0;
  int triangles = 0;
  int shells = 0;                         ///< pieces that hang together
  int euler_number = 0;                   ///< V - E + F of the vertices in use
  std::vector<int> border_loops;          ///< vertices of each, longest first; empty when closed
  std::vector<double> border_lengths_mm;  ///< of those loops, in their order
  std::optional<int> genus;               ///< handles of all shells; absent unless a manifold that
                                          ///< has two sides
  bool closed = false;                    ///< every edge has two triangles or more
  std::optional<bool> outward;            ///< orient() would turn nothing; absent when open, not a
                                          ///< manifold or one-sided
  int non_manifold_edges = 0;             ///< with more than two triangles
  std::vector<int> pinched_vertices;      ///< where surfaces touch in a point alone, ascending
  int disagreeing_edges = 0;              ///< whose two triangles run along it the same way
  int coincident_vertices = 0;            ///< in the very place of one before
  std::vector<int> duplicate_faces;       ///< the same three vertices as one before, ascending
  std::vector<int> degenerate_faces;      ///< of no height, as find_flat_corner says; ascending
  std::optional<int> self_intersecting_faces;  ///< absent where counting would take too long
  std::vector<int> crossing_faces;  ///< those triangles, ascending; empty where they are absent
  bool orientable = true;           ///< neighbours can agree on a side; false for a Moebius band
  std::optional<double> smallest_angle_deg;
  Histogram angles_deg;
  std::optional<std::array<double, 3>> edges_mm;  ///< shortest, median and longest
  Histogram edge_lengths_mm;
  std::optional<double> thinnest_mm;   ///< absent where no look behind a triangle meets another
  int thickness_looks = 0;             ///< those that do, see measure_thickness()
  std::vector<int> thin_faces;         ///< of those, ascending
  std::array<double, 3> size_mm = {};  ///< along x, y and z
  std::optional<double> volume_ml;     ///< enclosed; absent where outward is
};

/// Measures a surface as it is; thickness where its triangles face outwards or nobody can tell.
/// Never refuses: a soup has a report too.
MeshReport inspect_mesh(const SurfaceMesh& mesh);

}  // namespace palpate::authoring
