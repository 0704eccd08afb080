// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/join_parts.h"

#include <algorithm>
#include <cmath>

#include "palpate/authoring/units.h"
#include "palpate/authoring/weld.h"
#include "palpate/sim/mesh/mesh.h"

namespace palpate::authoring {
namespace {

/// "'a', 'b', 'c'", cut short where there are many.
std::string list_names(const std::vector<ImportedPart>& parts) {
  constexpr std::size_t kMostNames = 40;
  std::string names;
  for (std::size_t i = 0; i < std::min(parts.size(), kMostNames); ++i) {
    names += (i > 0 ? ", '" : "'") + parts[i].name + "'";
  }
  return parts.size() > kMostNames ? names + ", ..." : names;
}

std::vector<const ImportedPart*> choose_parts(const ImportedScene& scene,
                                              const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto has_name = [&](const ImportedPart& p) { return p.name == name; };
    if (std::none_of(scene.parts.begin(), scene.parts.end(), has_name)) {
      throw FileError(scene.file, "part '" + name + "'", "no such part",
                      "one of " + list_names(scene.parts));
    }
  }
  std::vector<const ImportedPart*> chosen;
  for (const ImportedPart& part : scene.parts) {
    if (names.empty() || std::find(names.begin(), names.end(), part.name) != names.end()) {
      chosen.push_back(&part);
    }
  }
  return chosen;
}

SurfaceMesh concatenate(const std::vector<const ImportedPart*>& parts) {
  SurfaceMesh all;
  for (const ImportedPart* part : parts) {
    const int first = static_cast<int>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), part->mesh.vertices.begin(), part->mesh.vertices.end());
    for (const Triangle& t : part->mesh.triangles) {
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  return all;
}

}  // namespace

JoinedSurface join_parts(const ImportedScene& scene, const JoinOptions& options) {
  const auto parts = choose_parts(scene, options.parts);
  // tolerance zero drops what no triangle uses, so a stray vertex cannot stretch the box
  SurfaceMesh all = weld(concatenate(parts), 0.0).mesh;
  const double diagonal = all.vertices.empty() ? 0.0 : compute_diagonal(all.vertices);
  if (!std::isfinite(diagonal)) {
    throw FileError(scene.file, "", "coordinates too large to measure", "an organ's size");
  }
  const Choice unit = choose_unit(options.unit, scene.unit, diagonal);
  const Choice up = choose_up(options.up, scene.up);

  JoinedSurface joined{};
  joined.mesh = weld(all, kWeldTolerance * diagonal).mesh;
  if (joined.mesh.triangles.empty()) {
    throw FileError(scene.file, "", "no triangle with three different corners", "a surface");
  }
  std::size_t before = 0;
  for (const ImportedPart* part : parts) {
    joined.parts.push_back(part->name);
    before += part->mesh.vertices.size();
  }
  joined.welded_vertices = static_cast<int>(before - joined.mesh.vertices.size());
  joined.unit = unit.value;
  joined.unit_guessed = unit.guessed;
  joined.unit_reason = unit.reason;
  joined.up = up.value;
  joined.up_guessed = up.guessed;
  joined.up_reason = up.reason;

  const double scale = *find_metres_per_unit(unit.value);
  const Mat3 turn = *find_turn_to_z_up(up.value);
  for (Vec3& x : joined.mesh.vertices) x = turn * (scale * x);
  return joined;
}

}  // namespace palpate::authoring
