// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {

/// What a surface is like, for people: millimetres, millilitres and degrees. Absent is what is
/// not defined for it; no number is ever infinite or NaN.
struct MeshReport {
  int vertices = 0;
  int triangles = 0;
  int shells = 0;                 ///< pieces that hang together
  std::vector<int> border_loops;  ///< vertices of each, longest first; empty when closed
  std::optional<int> genus;       ///< handles of all shells; absent unless a manifold that
                                  ///< has two sides
  bool closed = false;            ///< every edge has two triangles or more
  std::optional<bool> outward;    ///< orient() would turn nothing; absent when open, not a
                                  ///< manifold or one-sided
  int non_manifold_edges = 0;     ///< with more than two triangles
  std::optional<int> self_intersecting_faces;  ///< absent where counting would take too long
  std::vector<int> crossing_faces;  ///< those triangles, ascending; empty where they are absent
  bool orientable = true;           ///< neighbours can agree on a side; false for a Moebius band
  std::optional<double> smallest_angle_deg;
  std::array<double, 3> size_mm = {};  ///< along x, y and z
  std::optional<double> volume_ml;     ///< enclosed; absent where outward is
};

/// Measures a surface as it is. Never refuses: a soup has a report too.
MeshReport inspect_mesh(const SurfaceMesh& mesh);

}  // namespace palpate::authoring
