// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/around.h"

#include <utility>

namespace palpate::scenario {

void find_around(TissueModel& tissue) {
  const int count = particle_count(tissue);
  for (Hyperelastic* table : {&tissue.corotated, &tissue.neo_hookean}) {
    *table = build_hyperelastic(count, std::move(table->corners), std::move(table->lame),
                                std::move(table->shear), std::move(table->viscosity),
                                table->nodal_share);
  }
  Elastic& elastic = tissue.elastic;
  std::vector<int> reach = std::move(elastic.reach);
  elastic = build_elastic(count, std::move(elastic.corners), std::move(elastic.lame),
                          std::move(elastic.shear), elastic.nodal_share, elastic.damping_time);
  elastic.reach = std::move(reach);
  Volumes& volumes = tissue.volumes;
  volumes = build_volumes(count, std::move(volumes.corners), std::move(volumes.rest_volume),
                          std::move(volumes.bulk), volumes.nodal_share);
}

}  // namespace palpate::scenario
