// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "palpate/sim/model/load.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {

// How a deformed tissue gives way at one place, from the particles around it alone.

/// A part of a model that moves, with all that holds it: the tangent of its free particles is that
/// of the whole model among these particles, all others held.
struct CutOut {
  TissueModel model;          ///< without skin and triangles
  Vec3Array x;                ///< [m] of its particles, where they were cut out
  std::vector<int> particle;  ///< of each, in the whole model; ascending
};

/// Cuts out the `most` free particles nearest to `centre` [m], and those in `always`.
CutOut cut_out(const TissueModel& model, std::span<const Vec3> x, const Vec3& centre, int most,
               std::span<const int> always = {});

/// [m/N] Symmetric, (k, k): how far points of the surface at positions x [m] move along their
/// directions under 1 N along each other's. A point is a push, whose force is its direction, unit.
/// The `most` particles nearest to the middle of the points move, all others are held: of a solid
/// that leaves out about a / R of the compliance of a patch of radius a, R the radius of what was
/// cut out [stability: local compliance]. None where the tissue cannot be solved for.
std::optional<Eigen::MatrixXd> compute_local_compliance(const TissueModel& model,
                                                        std::span<const Vec3> x,
                                                        std::span<const Push> along, int most);

}  // namespace palpate
