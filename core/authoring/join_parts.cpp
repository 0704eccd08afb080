// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/join_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "palpate/authoring/combine_parts.h"
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

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether a name is the part's own or, where no part has it, that of a group it stands under.
bool is_named(const ImportedScene& scene, const ImportedPart& part, const std::string& name) {
  const auto has_name = [&](const ImportedPart& p) { return p.name == name; };
  const bool of_part = std::any_of(scene.parts.begin(), scene.parts.end(), has_name);
  return of_part ? part.name == name : has(part.groups, name);
}

std::vector<const ImportedPart*> choose_parts(const ImportedScene& scene,
                                              const std::vector<std::string>& names) {
  std::vector<const ImportedPart*> chosen;
  for (const std::string& name : names) {
    const auto is_it = [&](const ImportedPart& p) { return is_named(scene, p, name); };
    if (std::none_of(scene.parts.begin(), scene.parts.end(), is_it)) {
      throw FileError(scene.file, "part '" + name + "'", "no such part",
                      "one of " + list_names(scene.parts));
    }
  }
  for (const ImportedPart& part : scene.parts) {
    const auto names_it = [&](const std::string& name) { return is_named(scene, part, name); };
    if (std::any_of(names.begin(), names.end(), names_it)) chosen.push_back(&part);
  }
  return chosen;
}

/// Those that are kept, and those that are taken away from them.
struct Chosen {
  std::vector<const ImportedPart*> kept, taken;
};

Chosen choose_both(const ImportedScene& scene, const JoinOptions& options) {
  Chosen chosen;
  chosen.taken = choose_parts(scene, options.subtract);
  chosen.kept = choose_parts(scene, options.parts);
  if (options.parts.empty()) {
    for (const ImportedPart& part : scene.parts) chosen.kept.push_back(&part);
  }
  std::erase_if(chosen.kept, [&](const ImportedPart* part) {
    return std::find(chosen.taken.begin(), chosen.taken.end(), part) != chosen.taken.end();
  });
  if (chosen.kept.empty()) {
    throw FileError(scene.file, "", "parts that are all taken away",
                    "at least one that they are taken from");
  }
  return chosen;
}

/// Parts beside each other, and which of them each vertex is of.
struct Concatenated {
  SurfaceMesh mesh;
  std::vector<int> part;
};

Concatenated concatenate(const std::vector<const ImportedPart*>& parts) {
  Concatenated all;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const SurfaceMesh& mesh = parts[p]->mesh;
    const int first = static_cast<int>(all.mesh.vertices.size());
    all.mesh.vertices.insert(all.mesh.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    all.part.resize(all.mesh.vertices.size(), static_cast<int>(p));
    for (const Triangle& t : mesh.triangles) {
      all.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  return all;
}

/// [m] without what no triangle uses, so that a stray vertex cannot stretch the box.
double measure(const ImportedScene& scene, const SurfaceMesh& all) {
  const SurfaceMesh used = weld(all, 0.0).mesh;
  const double diagonal = used.vertices.empty() ? 0.0 : compute_diagonal(used.vertices);
  if (!std::isfinite(diagonal)) {
    throw FileError(scene.file, "", "coordinates too large to measure", "an organ's size");
  }
  return diagonal;
}

/// For each vertex of a welded surface the part of the first vertex that lies there.
std::vector<int> find_parts(const SurfaceMesh& welded, const Concatenated& all) {
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::map<Vec3, int, decltype(less)> part(less);
  for (std::size_t v = 0; v < all.part.size(); ++v) {
    part.try_emplace(all.mesh.vertices[v], all.part[v]);
  }
  std::vector<int> parts;
  for (const Vec3& x : welded.vertices) parts.push_back(part.at(x));
  return parts;
}

/// Welds what is the same point and, where a tolerance is stated, across parts; in file units.
void weld_parts(const Concatenated& all, double diagonal, std::optional<double> tolerance,
                JoinedSurface& joined) {
  joined.mesh = weld(all.mesh, kWeldTolerance * diagonal).mesh;
  if (tolerance) {
    const std::vector<int> part = find_parts(joined.mesh, all);
    Welded across = weld_across(joined.mesh, *tolerance, part);
    joined.welded_across = across.merged_vertices;
    joined.largest_move = across.largest_move;
    joined.mesh = std::move(across.mesh);
  }
  joined.welded_vertices = static_cast<int>(all.part.size() - joined.mesh.vertices.size());
}

void check_tolerance(const JoinOptions& options) {
  if (!options.weld) return;
  if (!(*options.weld >= 0.0 && std::isfinite(*options.weld))) {
    throw std::invalid_argument("weld must be a length that is not negative, got " +
                                std::to_string(*options.weld) + " m");
  }
  if (options.unite || !options.subtract.empty()) {
    throw std::invalid_argument(
        "weld has no effect on parts that are united or subtracted: give one of them");
  }
}

void take_choices(const Choice& unit, const Choice& up, JoinedSurface& joined) {
  joined.unit = unit.value;
  joined.unit_guessed = unit.guessed;
  joined.unit_reason = unit.reason;
  joined.up = up.value;
  joined.up_guessed = up.guessed;
  joined.up_reason = up.reason;
}

}  // namespace

JoinedSurface join_parts(const ImportedScene& scene, const JoinOptions& options) {
  check_tolerance(options);
  const Chosen chosen = choose_both(scene, options);
  const Concatenated all = concatenate(chosen.kept);
  const double diagonal = measure(scene, all.mesh);
  const Choice unit = choose_unit(options.unit, scene.unit, diagonal);
  const Choice up = choose_up(options.up, scene.up);
  const double scale = *find_metres_per_unit(unit.value);
  const Mat3 turn = *find_turn_to_z_up(up.value);

  JoinedSurface joined{};
  take_choices(unit, up, joined);
  if (options.unite || !chosen.taken.empty()) {
    CombinedParts combined = combine_parts(scene.file, chosen.kept, chosen.taken);
    joined.mesh = std::move(combined.mesh);
    joined.notes = std::move(combined.notes);
  } else {
    const auto tolerance =
        options.weld ? std::optional<double>(*options.weld / scale) : std::nullopt;
    weld_parts(all, diagonal, tolerance, joined);
    joined.largest_move *= scale;
  }
  if (joined.mesh.triangles.empty()) {
    throw FileError(scene.file, "", "no triangle with three different corners", "a surface");
  }
  for (const ImportedPart* part : chosen.kept) joined.parts.push_back(part->name);
  for (const ImportedPart* part : chosen.taken) joined.subtracted.push_back(part->name);
  for (Vec3& x : joined.mesh.vertices) x = turn * (scale * x);
  return joined;
}

}  // namespace palpate::authoring
