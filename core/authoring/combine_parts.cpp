// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/combine_parts.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "palpate/authoring/cgal/combine_solids.h"
#include "palpate/authoring/inspect_mesh.h"
#include "palpate/authoring/join_parts.h"
#include "palpate/authoring/remove_crossings.h"
#include "palpate/authoring/repair_mesh.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/authoring/weld.h"
#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

/// [-] of the diagonal: within how much cut points are welded where rounding made triangles cross.
constexpr std::array kRoundings = {kWeldTolerance, 1e-5, 1e-4};

/// [-] of a shell's triangles: where more cross others it does not cross itself in a few places.
constexpr double kFewCross = 0.05;

/// Rings of neighbours that are replaced with the triangles that cross, round by round.
constexpr std::array kRings = {0, 1, 1, 2, 2, 3};

constexpr const char* kSolid =
    "a closed part that does not cross itself: repair it, leave it out, or weld the parts of one "
    "surface without uniting them";

/// What keeps a surface from bounding a solid; empty where it does.
std::string find_solid_problem(const MeshReport& report) {
  const int crowded = report.non_manifold_edges,
            crossing = report.self_intersecting_faces.value_or(0);
  const std::size_t holes = report.border_loops.size();
  if (report.triangles == 0) return "no triangle that has an area";
  if (crowded > 0) return write_text(crowded, " edges with more than two triangles");
  if (holes > 0) return holes == 1 ? "1 hole" : write_text(holes, " holes");
  if (!report.orientable) return "a surface with one side only";
  if (crossing > 0) return write_text(crossing, " triangles that cross others");
  if (!report.self_intersecting_faces) return "more triangles upon each other than can be counted";
  return "";
}

std::vector<SurfaceMesh> split_shells(const SurfaceMesh& mesh) {
  const auto count = static_cast<int>(mesh.vertices.size());
  const std::vector<int> shell = find_shells(count, mesh.triangles);
  std::vector<SurfaceMesh> shells;
  std::vector<int> place(mesh.vertices.size(), -1);
  for (int v = 0; v < count; ++v) {
    if (shell[v] < 0) continue;
    if (shell[v] >= static_cast<int>(shells.size())) shells.resize(shell[v] + 1);
    place[v] = static_cast<int>(shells[shell[v]].vertices.size());
    shells[shell[v]].vertices.push_back(mesh.vertices[v]);
  }
  for (const Triangle& t : mesh.triangles) {
    shells[shell[t[0]]].triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
  }
  return shells;
}

void turn_over(SurfaceMesh& mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
}

/// What one part fills: its shells that face outwards, without those that face inwards.
struct Solid {
  std::vector<SurfaceMesh> filled, hollow;
  int uncrossed = 0;  ///< triangles that were replaced
};

/// Takes out where a closed manifold runs through itself in a few places, as far as that goes, and
/// says how many triangles it has replaced.
int uncross(const MeshReport& report, SurfaceMesh& shell) {
  const bool is_solid = report.non_manifold_edges == 0 && report.closed && report.orientable;
  std::size_t left = report.crossing_faces.size();
  if (!is_solid || left > kFewCross * report.triangles) return 0;
  int replaced = 0;
  for (const int rings : kRings) {
    if (left == 0) break;
    UncrossedMesh found = remove_crossings(shell, rings);
    const auto faces = find_self_intersecting_faces(found.mesh);
    if (!faces || faces->size() >= left) continue;
    left = faces->size();
    replaced += found.replaced_triangles;
    shell = std::move(found.mesh);
  }
  return replaced;
}

/// Each shell is checked by itself: shells of one part may cross each other.
Solid take_solid(const std::string& where, const SurfaceMesh& mesh) {
  const double diagonal = mesh.vertices.empty() ? 0.0 : compute_diagonal(mesh.vertices);
  const SurfaceMesh clean = repair_mesh(weld(mesh, kWeldTolerance * diagonal).mesh).mesh;
  Solid solid;
  for (SurfaceMesh& shell : split_shells(clean)) {
    const MeshReport report = inspect_mesh(shell);
    const int replaced = uncross(report, shell);
    solid.uncrossed += replaced;
    const std::string fault = find_solid_problem(replaced > 0 ? inspect_mesh(shell) : report);
    if (!fault.empty()) throw FileError("", where, fault, kSolid);
    const bool outward = compute_volume(shell) > 0.0;
    if (!outward) turn_over(shell);
    (outward ? solid.filled : solid.hollow).push_back(std::move(shell));
  }
  if (solid.filled.empty()) throw FileError("", where, "no triangle that has an area", kSolid);
  return solid;
}

/// The solid without its cavities, in pieces that do not cross each other; only united where it
/// must be.
SurfaceMesh fill(const std::string& where, const Solid& solid) {
  auto made = combine_solids(solid.filled, solid.hollow);
  if (!made) {
    throw FileError("", where, "shells that touch along an edge or in a vertex",
                    "shells that are apart, or cross");
  }
  return *std::move(made);
}

/// Welds what rounding left within a hair, until no triangle crosses another.
SurfaceMesh tidy(const SurfaceMesh& cut) {
  if (cut.triangles.empty()) {
    throw FileError("", "", "nothing that is left of the parts", "a solid");
  }
  const double diagonal = compute_diagonal(cut.vertices);
  std::string fault;
  for (const double rounding : kRoundings) {
    const SurfaceMesh mesh = repair_mesh(weld(cut, rounding * diagonal).mesh).mesh;
    const std::string found = find_solid_problem(inspect_mesh(mesh));
    if (found.empty()) return mesh;
    if (fault.empty()) fault = found;
  }
  throw FileError("", "", "united parts with " + fault,
                  "a closed surface without crossings: parts that nearly touch are welded instead");
}

CombinedParts combine(const std::vector<std::pair<std::string, const SurfaceMesh*>>& kept,
                      const std::vector<std::pair<std::string, const SurfaceMesh*>>& taken) {
  CombinedParts combined;
  std::vector<SurfaceMesh> more, less;
  const auto add = [&](const auto& parts, std::vector<SurfaceMesh>& to) {
    for (const auto& [where, mesh] : parts) {
      Solid solid = take_solid(where, *mesh);
      if (solid.uncrossed > 0) {
        combined.notes.push_back(write_text(where, " crossed itself: ", solid.uncrossed,
                                            " of its triangles were replaced"));
      }
      if (solid.hollow.empty()) {
        std::move(solid.filled.begin(), solid.filled.end(), std::back_inserter(to));
      } else {
        to.push_back(fill(where, solid));
      }
    }
  };
  add(kept, more);
  add(taken, less);
  const auto cut = combine_solids(more, less);
  if (!cut) {
    throw FileError("", "", "parts that touch along an edge or in a vertex without crossing there",
                    "parts that cross or are apart: weld those that only touch");
  }
  combined.mesh = tidy(*cut);
  return combined;
}

}  // namespace

CombinedParts combine_parts(const std::string& file, const std::vector<const ImportedPart*>& kept,
                            const std::vector<const ImportedPart*>& taken) {
  const auto list = [](const std::vector<const ImportedPart*>& parts) {
    std::vector<std::pair<std::string, const SurfaceMesh*>> named;
    for (const ImportedPart* part : parts) {
      named.emplace_back("part '" + part->name + "'", &part->mesh);
    }
    return named;
  };
  try {
    return combine(list(kept), list(taken));
  } catch (const FileError& fault) {
    throw FileError(file, fault.where, fault.got, fault.expected);
  }
}

CombinedParts unite_shells(const SurfaceMesh& mesh) {
  try {
    return combine({{"surface", &mesh}}, {});
  } catch (const FileError& fault) {
    refuse(fault.where.empty() ? "surface" : fault.where, fault.got, fault.expected);
  }
}

}  // namespace palpate::authoring
