// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scenes/solids.h"

/// Solids of tetrahedra at finite strain, of the same shapes.
namespace palpate::scenes {

/// One of the two laws, with what tests ask of it.
struct FiniteLaw {
  const char* name;
  Hyperelastic TissueModel::*table;
  TissueModel (*build)(const SolidMesh&, const Material&, const SolidOptions&);
};

inline constexpr FiniteLaw kFiniteLaws[] = {
    {"corotated", &TissueModel::corotated, &build_corotated_solid},
    {"neo-Hookean", &TissueModel::neo_hookean, &build_neo_hookean_solid}};

/// A solid of 5 kPa and nu = 0.45, held at its base.
inline TissueModel make_finite_organ(const FiniteLaw& law, int cells, double nodal_share,
                                     const Losses& losses = {}) {
  const SolidMesh solid = make_round_block(cells);
  SolidOptions options;
  options.nodal_share = nodal_share;
  options.fixed = find_base(solid);
  options.drag = losses.drag;
  return law.build(solid, make_material(losses), options);
}

}  // namespace palpate::scenes
