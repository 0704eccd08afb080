// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

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

/// Of each of `count` particles of the whole model, among those cut out; -1 for the rest.
std::vector<int> number_particles(const CutOut& cut, std::size_t count);

}  // namespace palpate
