// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/model/private/check_solid.h"

#include <algorithm>
#include <cmath>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/tissue_model.h"

namespace palpate {
namespace {

std::string name_row(const char* table, std::size_t row) {
  return write_text("model: ", table, ": row ", row);
}

void check_size(const char* table, std::size_t found, std::size_t expected) {
  if (found == expected) return;
  refuse(write_text("model: ", table), write_text(found, " rows"), write_text(expected));
}

void check_tetrahedra(const std::vector<std::array<int, 4>>& tetrahedra, const char* table, int n) {
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    auto sorted = tetrahedra[t];
    std::sort(sorted.begin(), sorted.end());
    const bool different = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    if (different && sorted.front() >= 0 && sorted.back() < n) continue;
    const auto& [i, j, k, l] = tetrahedra[t];
    refuse(name_row(table, t), write_text(i, ", ", j, ", ", k, ", ", l),
           write_text("four different particles, 0 to ", n - 1));
  }
}

void check_volumes(const Volumes& volumes, const Vec3Array& x) {
  const std::size_t count = volumes.corners.size();
  check_size("volumes.rest_volume", volumes.rest_volume.size(), count);
  check_size("volumes.bulk", volumes.bulk.size(), count);
  check_tetrahedra(volumes.corners, "volumes.corners", static_cast<int>(x.size()));
  for (std::size_t t = 0; t < count; ++t) {
    if (!(std::isfinite(volumes.rest_volume[t]) && volumes.rest_volume[t] > 0.0)) {
      refuse(name_row("volumes.rest_volume", t), write_text(volumes.rest_volume[t], " m³"),
             "a positive number");
    }
    if (!(std::isfinite(volumes.bulk[t]) && volumes.bulk[t] >= 0.0)) {
      refuse(name_row("volumes.bulk", t), write_text(volumes.bulk[t], " Pa"),
             "0 or a positive number");
    }
    const auto& [a, b, c, d] = volumes.corners[t];
    const double volume = compute_volume(x[a], x[b], x[c], x[d]);
    if (!(volume > 0.0)) {
      refuse(name_row("volumes.corners", t), write_text("a volume of ", volume, " m³ at rest"),
             "a positive one");
    }
  }
  if (!(volumes.nodal_share >= 0.0 && volumes.nodal_share <= 1.0)) {
    refuse("model: volumes.nodal_share", write_text(volumes.nodal_share), "0 to 1");
  }
  const Volumes built = build_volumes(static_cast<int>(x.size()), volumes.corners,
                                      volumes.rest_volume, volumes.bulk, volumes.nodal_share);
  if (volumes.first_around != built.first_around || volumes.around != built.around) {
    refuse("model: volumes.around", "other tables than the corners give", "those of build_volumes");
  }
}

void check_moduli(const Elastic& elastic, const Vec3Array& x) {
  const auto require = [](const char* column, std::size_t row, double found, bool holds,
                          const char* expected) {
    if (!holds) refuse(name_row(column, row), write_text(found, " Pa"), expected);
  };
  for (std::size_t t = 0; t < elastic.corners.size(); ++t) {
    require("elastic.lame", t, elastic.lame[t],
            std::isfinite(elastic.lame[t]) && elastic.lame[t] >= 0.0, "0 or a positive number");
    require("elastic.shear", t, elastic.shear[t],
            std::isfinite(elastic.shear[t]) && elastic.shear[t] > 0.0, "a positive number");
    const auto& [a, b, c, d] = elastic.corners[t];
    const double volume = compute_volume(x[a], x[b], x[c], x[d]);
    if (volume > 0.0) continue;
    refuse(name_row("elastic.corners", t), write_text("a volume of ", volume, " m³ at rest"),
           "a positive one");
  }
}

void check_reach(const std::vector<int>& reach, int n) {
  for (std::size_t row = 0; row < reach.size(); ++row) {
    const bool ascending = row == 0 || reach[row] > reach[row - 1];
    if (reach[row] >= 0 && reach[row] < n && ascending) continue;
    refuse(name_row("elastic.reach", row), write_text("particle ", reach[row]),
           write_text("ascending particles, 0 to ", n - 1));
  }
}

/// A linear solid knows what it is displaced by, and nothing beside it has a part in that.
void check_alone(const TissueModel& model) {
  const auto require = [](bool holds, const char* found) {
    if (!holds) refuse("model: elastic", write_text(found, " beside it"), "no other law");
  };
  require(model.springs.ends.empty(), "springs");
  require(model.bonds.ends.empty(), "bonds");
  require(model.angles.corners.empty(), "angles");
  require(model.prisms.corners.empty(), "prisms");
  require(model.volumes.corners.empty(), "volumes");
  require(model.pressure == 0.0, "a pressure");
}

void check_elastic(const TissueModel& model) {
  const Elastic& elastic = model.elastic;
  const std::size_t count = elastic.corners.size();
  check_size("elastic.lame", elastic.lame.size(), count);
  check_size("elastic.shear", elastic.shear.size(), count);
  check_tetrahedra(elastic.corners, "elastic.corners", particle_count(model));
  check_moduli(elastic, model.rest_position);
  check_reach(elastic.reach, particle_count(model));
  if (!(elastic.nodal_share >= 0.0 && elastic.nodal_share <= 1.0)) {
    refuse("model: elastic.nodal_share", write_text(elastic.nodal_share), "0 to 1");
  }
  if (!(std::isfinite(elastic.damping_time) && elastic.damping_time >= 0.0)) {
    refuse("model: elastic.damping_time", write_text(elastic.damping_time, " s"),
           "0 or a positive number");
  }
  const Elastic built =
      build_elastic(particle_count(model), elastic.corners, elastic.lame, elastic.shear);
  if (elastic.first_around != built.first_around || elastic.around != built.around) {
    refuse("model: elastic.around", "other tables than the corners give", "those of build_elastic");
  }
  if (count > 0) check_alone(model);
}

void check_skin(const TissueModel& model) {
  // weights solved for in double, from corners well apart
  constexpr double kSumError = 1e-9;
  // a vertex so far from its tetrahedron would swing wildly as that one turns
  constexpr double kLargestWeight = 4.0;
  const Skin& skin = model.skin;
  check_size("skin.weights", skin.weights.size(), skin.corners.size());
  check_tetrahedra(skin.corners, "skin.corners", particle_count(model));
  for (std::size_t v = 0; v < skin.weights.size(); ++v) {
    double sum = 0.0, largest = 0.0;
    for (const double weight : skin.weights[v]) {
      sum += weight;
      largest = std::max(largest, std::abs(weight));
    }
    if (!(std::abs(sum - 1.0) <= kSumError)) {
      refuse(name_row("skin.weights", v), write_text("a sum of ", sum), "1");
    }
    if (!(largest <= kLargestWeight)) {
      refuse(name_row("skin.weights", v), write_text(largest),
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
  check_skin(model);
}

/// Nothing for a tissue that is all surface.
std::string describe_solid(const TissueModel& model) {
  if (list_tetrahedra(model).empty()) return "";
  std::string text = write_text(list_tetrahedra(model).size(), " tetrahedra, ");
  if (!model.elastic.corners.empty()) text = "linear, " + text;
  if (!model.skin.corners.empty()) {
    text += write_text("a skin of ", model.skin.corners.size(), " vertices, ");
  }
  return text;
}

}  // namespace palpate
