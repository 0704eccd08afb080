// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/derived.h"

#include <cmath>

#include "palpate/scenario/ranges.h"
#include "palpate/sim/base/private/refuse.h"

namespace palpate::scenario {
namespace {

/// [-] Another compiler or processor may round otherwise, and then the estimate of an eigenvalue,
/// which is good to a thousandth, may end elsewhere within that.
constexpr double kAreaError = 1e-9, kSpectrumError = 1e-2;

void compare(const std::string& where, double found, double expected, double error) {
  if (!std::isfinite(expected)) {
    refuse(where, write_text("a tissue that gives ", expected), "one that gives a finite number");
  }
  if (std::abs(found - expected) <= error * std::abs(expected)) return;  // false for NaN too
  refuse(where, write_text(found), write_text(expected, ", which the tissue gives"));
}

void check_count(const char* table, std::size_t count, std::size_t most) {
  if (count <= most) return;
  refuse(write_text("scene.tissue.", table), write_text(count, " rows"),
         write_text("at most ", most));
}

}  // namespace

void check_counts(const TissueModel& tissue) {
  check_count("rest_position", tissue.rest_position.size(), kMostParticles);
  check_count("fixed", tissue.fixed.size(), kMostParticles);
  check_count("springs", tissue.springs.ends.size(), kMostLinks);
  check_count("bonds", tissue.bonds.ends.size(), kMostLinks);
  check_count("angles", tissue.angles.corners.size(), kMostTriangles);
  check_count("prisms", tissue.prisms.corners.size(), kMostTriangles);
  check_count("volumes", tissue.volumes.corners.size(), kMostTetrahedra);
  check_count("elastic", tissue.elastic.corners.size(), kMostElastic);
  check_count("skin", tissue.skin.corners.size(), kMostParticles);
  check_count("triangles", tissue.triangles.size(), kMostTriangles);
}

Scene check_built(const Scene& scene) {
  check_counts(scene.bodies[0].tissue);
  check_ranges(scene);
  if (scene.bodies[0].substeps < 1 || scene.bodies[0].substeps_max < 1) {
    refuse("scene.substeps", "0", "the result of build_scene");
  }
  Scene built = build_scene(scene);
  if (scene.bodies[0].rest_areas.size() != built.bodies[0].rest_areas.size()) {
    refuse("scene.rest_areas", write_text(scene.bodies[0].rest_areas.size(), " rows"),
           write_text(built.bodies[0].rest_areas.size(), ", one per triangle"));
  }
  for (std::size_t t = 0; t < built.bodies[0].rest_areas.size(); ++t) {
    compare(write_text("scene.rest_areas: row ", t), scene.bodies[0].rest_areas[t],
            built.bodies[0].rest_areas[t], kAreaError);
  }
  compare("scene.spectrum_stiffness", scene.bodies[0].spectrum_stiffness,
          built.bodies[0].spectrum_stiffness, kSpectrumError);
  compare("scene.spectrum_damping", scene.bodies[0].spectrum_damping,
          built.bodies[0].spectrum_damping, kSpectrumError);
  return built;
}

}  // namespace palpate::scenario
