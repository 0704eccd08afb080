// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/seen_distance.h"

namespace palpate::authoring {

/// The surface is wrapped so far away, as a part of alpha; then it is drawn back as far.
inline constexpr double kWrapOffset = 1.0 / 30.0;

/// What of a surface hung together and is gone.
struct DroppedPiece {
  int triangles;
  double size;                   ///< [m] from corner to corner
  std::array<double, 3> middle;  ///< [m] of its box
};

/// A surface around another one, and what it cost.
struct WrappedMesh {
  SurfaceMesh mesh;
  SurfaceDistance to_source;          ///< from the new surface to the source
  SurfaceDistance from_source;        ///< from what is seen of the source, see find_seen_points()
  double volume;                      ///< [m³] inside the new surface
  std::vector<DroppedPiece> dropped;  ///< of the source, that lie inside: all but a twentieth of
                                      ///< their triangles; the largest first
};

/// Wraps any triangles, crossing, open or doubled, in a closed surface that crosses nothing: what
/// is narrower than `alpha` [m] is bridged, and what lies inside is gone. The last resort: the way
/// of it is told. Throws std::invalid_argument for corners that are not finite or an alpha that is
/// not positive, or so small that the wrap would take minutes.
WrappedMesh wrap_surface(const SurfaceMesh& mesh, double alpha);

}  // namespace palpate::authoring
