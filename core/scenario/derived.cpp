// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/derived.h"

#include <cmath>

#include "palpate/scenario/ranges.h"
#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/model/private/law_tables.h"
#include "palpate/sim/tick/private/choose_substeps.h"

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

static_assert(laws::kSprings.most_rows == kMostLinks && laws::kBonds.most_rows == kMostLinks);
static_assert(laws::kAngles.most_rows == kMostTriangles);
static_assert(laws::kPrisms.most_rows == kMostTriangles);
static_assert(laws::kVolumes.most_rows == kMostTetrahedra);
static_assert(laws::kElastic.most_rows == kMostElastic);
static_assert(laws::kSkin.most_rows == kMostParticles);

void check_list(const char* name, std::size_t count, std::size_t most) {
  if (count >= 1 && count <= most) return;
  refuse(name, write_text(count), write_text("1 to ", most));
}

/// Of a table of `rows(tissue)` rows, in all bodies together.
template <class CountRows>
void check_count(const Scene& scene, const char* table, std::size_t most, CountRows rows) {
  std::size_t sum = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    sum += rows(scene.bodies[b].tissue);
    if (sum <= most) continue;
    const std::string where = write_text("scene.bodies[", b, "].tissue.", table);
    if (b == 0) refuse(where, write_text(sum, " rows"), write_text("at most ", most));
    refuse(where, write_text(sum, " rows with those of the bodies before"),
           write_text("at most ", most));
  }
}

void check_derived(const std::string& place, const SoftBody& found, const SoftBody& built) {
  if (found.rest_areas.size() != built.rest_areas.size()) {
    refuse(place + "rest_areas", write_text(found.rest_areas.size(), " rows"),
           write_text(built.rest_areas.size(), ", one per triangle"));
  }
  for (std::size_t t = 0; t < built.rest_areas.size(); ++t) {
    compare(write_text(place, "rest_areas: row ", t), found.rest_areas[t], built.rest_areas[t],
            kAreaError);
  }
  compare(place + "spectrum_stiffness", found.spectrum_stiffness, built.spectrum_stiffness,
          kSpectrumError);
  compare(place + "spectrum_damping", found.spectrum_damping, built.spectrum_damping,
          kSpectrumError);
}

/// A file has no kernels, and every reader chooses: under the one it chooses for a linear solid,
/// nothing touches that solid but instruments.
void check_kernel(const Scene& scene, int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= scene.bodies.size()) return;
  if (scene.bodies[static_cast<std::size_t>(index)].tissue.elastic.corners.empty()) return;
  refuse(write_text("scene.bodies[", index, "].tissue.elastic"),
         "a linear solid that touches more than instruments",
         "a tissue of another law: a file's linear solids are solved by their response, which "
         "neither other bodies nor stones nor scenery can touch");
}

void check_kernels(const Scene& scene) {
  for (const BodyPair& pair : scene.body_pairs) {
    check_kernel(scene, pair.first);
    check_kernel(scene, pair.second);
  }
  for (const Scenery& part : scene.scenery) {
    for (const int index : part.bodies) check_kernel(scene, index);
  }
  if (scene.rigid.empty()) return;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) check_kernel(scene, static_cast<int>(b));
}

/// Rigid bodies get their meshes, if they have none, from build_scene.
void check_rigid_meshes(const Scene& scene) {
  for (std::size_t r = 0; r < scene.rigid.size(); ++r) {
    if (!scene.rigid[r].mesh.triangles.empty()) continue;
    refuse(write_text("scene.rigid[", r, "].mesh"), "no triangles",
           "a closed mesh, which build_scene makes of the spheres where there is none");
  }
}

/// Of rigid bodies and scenery together.
void check_hard_counts(const Scene& scene) {
  std::size_t vertices = 0, triangles = 0;
  const auto add = [&](const std::string& where, const SurfaceMesh& mesh) {
    vertices += mesh.vertices.size();
    triangles += mesh.triangles.size();
    if (vertices <= kMostHardVertices && triangles <= kMostHardTriangles) return;
    refuse(where + ".mesh",
           write_text(vertices, " vertices and ", triangles, " triangles with those before"),
           write_text("at most ", kMostHardVertices, " and ", kMostHardTriangles,
                      " of all rigid bodies and scenery"));
  };
  const auto check_most = [](const char* name, std::size_t count, std::size_t most) {
    if (count > most) refuse(name, write_text(count), write_text("0 to ", most));
  };
  check_most("scene.rigid", scene.rigid.size(), kMostRigid);
  check_most("scene.scenery", scene.scenery.size(), kMostScenery);
  for (std::size_t r = 0; r < scene.rigid.size(); ++r) {
    add(write_text("scene.rigid[", r, "]"), scene.rigid[r].mesh);
  }
  for (std::size_t s = 0; s < scene.scenery.size(); ++s) {
    add(write_text("scene.scenery[", s, "]"), scene.scenery[s].mesh);
  }
}

}  // namespace

void check_counts(const Scene& scene) {
  using Tissue = TissueModel;
  check_list("scene.bodies", scene.bodies.size(), kMostBodies);
  check_list("scene.instruments", scene.instruments.size(), kMostInstruments);
  const auto check = [&](const char* table, std::size_t most, auto rows) {
    check_count(scene, table, most, rows);
  };
  check("rest_position", kMostParticles, [](const Tissue& t) { return t.rest_position.size(); });
  check("fixed", kMostParticles, [](const Tissue& t) { return t.fixed.size(); });
  laws::for_each_table([&](const auto& table) {
    check(table.name, table.most_rows,
          [&table](const Tissue& t) { return laws::count_rows(t, table); });
  });
  check("triangles", kMostTriangles, [](const Tissue& t) { return t.triangles.size(); });
  check_hard_counts(scene);
}

Scene check_built(const Scene& scene) {
  check_counts(scene);
  check_ranges(scene);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SoftBody& body = scene.bodies[b];
    if (body.substeps >= 1 && body.substeps_max >= 1) continue;
    refuse(write_text("scene.bodies[", b, "].substeps"), "0", "the result of build_scene");
  }
  check_kernels(scene);
  check_rigid_meshes(scene);
  Scene built = build_scene(scene);
  if (built.body_pairs.size() != scene.body_pairs.size()) {
    refuse("scene.body_pairs", write_text(scene.body_pairs.size()),
           write_text(built.body_pairs.size(), ", one more for each body that may fold"));
  }
  for (std::size_t b = 0; b < built.bodies.size(); ++b) {
    const std::string place = write_text("scene.bodies[", b, "].");
    check_derived(place, scene.bodies[b], built.bodies[b]);
    require_enough_substeps(place + "substeps", built.rate, built.bodies[b]);
  }
  return built;
}

}  // namespace palpate::scenario
