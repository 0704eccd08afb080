// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/private/check_solid.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/private/check_law.h"

namespace palpate {
namespace {

/// Tetrahedra are counter-clockwise at rest.
void check_volumes_at_rest(const char* table, const std::vector<std::array<int, 4>>& corners,
                           const Vec3Array& x) {
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const auto& [a, b, c, d] = corners[t];
    const double volume = compute_volume(x[a], x[b], x[c], x[d]);
    if (volume > 0.0) continue;
    refuse(laws::name_row(table, "corners", t), write_text("a volume of ", volume, " m³ at rest"),
           "a positive one");
  }
}

void check_volumes(const Volumes& volumes, const Vec3Array& x) {
  check_volumes_at_rest("volumes", volumes.corners, x);
  const Volumes built = build_volumes(static_cast<int>(x.size()), volumes.corners,
                                      volumes.rest_volume, volumes.bulk, volumes.nodal_share);
  if (volumes.first_around != built.first_around || volumes.around != built.around) {
    refuse("model: volumes.around", "other tables than the corners give", "those of build_volumes");
  }
}

/// A linear solid knows what it is displaced by, and nothing beside it has a part in that.
void check_alone(const TissueModel& model) {
  const auto refuse_beside = [](const std::string& got) {
    refuse("model: elastic", got + " beside it", "no other law");
  };
  laws::for_each_law([&]<class Law>(const Law& law) {
    if constexpr (std::is_same_v<typename Law::Rows, Elastic>) return;
    if (laws::is_present(model, law)) refuse_beside(law.name);
  });
  if (model.pressure != 0.0) refuse_beside("a pressure");
}

void check_elastic(const TissueModel& model) {
  const Elastic& elastic = model.elastic;
  check_volumes_at_rest("elastic", elastic.corners, model.rest_position);
  const Elastic built =
      build_elastic(particle_count(model), elastic.corners, elastic.lame, elastic.shear);
  if (elastic.first_around != built.first_around || elastic.around != built.around) {
    refuse("model: elastic.around", "other tables than the corners give", "those of build_elastic");
  }
  if (!elastic.corners.empty()) check_alone(model);
}

void check_hyperelastic(const char* name, const TissueModel& model, const Hyperelastic& table) {
  check_volumes_at_rest(name, table.corners, model.rest_position);
  if (!table.corners.empty() && laws::is_present(model, laws::kMaxwell)) {
    refuse(std::string("model: ") + name, "maxwell beside it",
           "a ratio of 0: tetrahedra at finite strain do not relax");
  }
  const Hyperelastic built = build_hyperelastic(particle_count(model), table.corners, table.lame,
                                                table.shear, table.viscosity);
  if (table.first_around == built.first_around && table.around == built.around) return;
  refuse(laws::name_column(name, "around"), "other tables than the corners give",
         "those of build_hyperelastic");
}

void check_skin(const TissueModel& model) {
  // weights solved for in double, from corners well apart
  constexpr double kSumError = 1e-9;
  // a vertex so far from its tetrahedron would swing wildly as that one turns
  constexpr double kLargestWeight = 4.0;
  const Skin& skin = model.skin;
  for (std::size_t v = 0; v < skin.weights.size(); ++v) {
    double sum = 0.0, largest = 0.0;
    for (const double weight : skin.weights[v]) {
      sum += weight;
      largest = std::max(largest, std::abs(weight));
    }
    if (!(std::abs(sum - 1.0) <= kSumError)) {
      refuse(laws::name_row("skin", "weights", v), write_text("a sum of ", sum), "1");
    }
    if (!(largest <= kLargestWeight)) {
      refuse(laws::name_row("skin", "weights", v), write_text(largest),
             write_text("between -", kLargestWeight, " and ", kLargestWeight));
    }
  }
  if (!skin.corners.empty() && model.pressure != 0.0) {
    refuse("model: pressure", write_text(model.pressure, " Pa on a skin"),
           "0: a solid has no inside for a pressure");
  }
}

}  // namespace

void check_solid(const TissueModel& model) {
  check_volumes(model.volumes, model.rest_position);
  check_elastic(model);
  check_hyperelastic("corotated", model, model.corotated);
  check_hyperelastic("neo_hookean", model, model.neo_hookean);
  check_skin(model);
}

}  // namespace palpate
