// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/fill_holes.h"

#include <algorithm>

#include "palpate/authoring/cgal/patch_holes.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

using Loops = std::vector<std::vector<int>>;

std::vector<int> check_holes(const Loops& loops, std::span<const int> holes) {
  const int count = static_cast<int>(loops.size());
  std::vector<int> wanted(holes.begin(), holes.end());
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  if (!wanted.empty() && (wanted.front() < 0 || wanted.back() >= count)) {
    refuse("fill: holes", write_text(wanted.front() < 0 ? wanted.front() : wanted.back()),
           count ? write_text("0 to ", count - 1) : "none: the surface is closed");
  }
  return wanted;
}

/// How many border loops pass through each vertex.
std::vector<int> count_passes(const SurfaceMesh& mesh, const Loops& loops) {
  std::vector<int> passes(mesh.vertices.size(), 0);
  for (const auto& loop : loops) {
    for (const int v : loop) ++passes[v];
  }
  return passes;
}

bool can_be_patched(const std::vector<int>& loop, const std::vector<int>& passes) {
  const auto length = static_cast<int>(loop.size());
  if (length < 3 || length > kMostHoleEdges) return false;
  return std::all_of(loop.begin(), loop.end(), [&](int v) { return passes[v] == 1; });
}

/// The surface with the patches that are there.
SurfaceMesh join(const SurfaceMesh& mesh, const std::vector<Patch>& patches) {
  SurfaceMesh joined = mesh;
  const int old_count = static_cast<int>(mesh.vertices.size());
  for (const Patch& patch : patches) {
    const int shift = static_cast<int>(joined.vertices.size()) - old_count;
    joined.vertices.insert(joined.vertices.end(), patch.vertices.begin(), patch.vertices.end());
    for (Triangle t : patch.triangles) {
      for (int& v : t) v += v >= old_count ? shift : 0;
      joined.triangles.push_back(t);
    }
  }
  return joined;
}

/// For each patch whether one of its triangles crosses anything. The triangles of patches follow
/// those of the surface; counting that would take too long counts as crossing.
std::vector<bool> find_crossing(const SurfaceMesh& mesh, const std::vector<Patch>& patches) {
  std::vector<bool> crossing(patches.size(), false);
  const auto faces = find_self_intersecting_faces(join(mesh, patches));
  auto first = static_cast<int>(mesh.triangles.size());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const int end = first + static_cast<int>(patches[i].triangles.size());
    crossing[i] = !faces;
    if (faces) {
      const auto hit = std::lower_bound(faces->begin(), faces->end(), first);
      crossing[i] = hit != faces->end() && *hit < end;
    }
    first = end;
  }
  return crossing;
}

/// Puts something simpler in the place of the patches that cross: flat ones, then none.
void replace_crossing(const SurfaceMesh& mesh, const Loops& loops, std::vector<Patch>& patches) {
  for (const bool flat : {true, false}) {
    const std::vector<bool> crossing = find_crossing(mesh, patches);
    for (std::size_t i = 0; i < patches.size(); ++i) {
      if (crossing[i]) patches[i] = Patch{};
    }
    if (!flat) return;
    Loops again;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < patches.size(); ++i) {
      if (!crossing[i]) continue;
      again.push_back(loops[i]);
      places.push_back(i);
    }
    if (again.empty()) return;
    std::vector<Patch> flats = patch_holes(mesh, again, PatchShape::flat);
    for (std::size_t i = 0; i < places.size(); ++i) patches[places[i]] = std::move(flats[i]);
  }
}

}  // namespace

FilledHoles fill_holes(const SurfaceMesh& mesh, std::span<const int> holes) {
  validate(mesh);
  const Loops all = find_border_loops(mesh.triangles);
  const std::vector<int> passes = count_passes(mesh, all);
  FilledHoles result;
  Loops loops;
  std::vector<int> numbers;
  for (const int hole : check_holes(all, holes)) {
    if (can_be_patched(all[hole], passes)) {
      loops.push_back(all[hole]);
      numbers.push_back(hole);
    } else {
      result.left_open.push_back(hole);
    }
  }
  std::vector<Patch> patches = patch_holes(mesh, loops, PatchShape::smooth);
  replace_crossing(mesh, loops, patches);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (patches[i].triangles.empty()) {
      result.left_open.push_back(numbers[i]);
    } else {
      ++result.filled;
    }
  }
  std::sort(result.left_open.begin(), result.left_open.end());
  result.mesh = join(mesh, patches);
  validate(result.mesh);
  return result;
}

}  // namespace palpate::authoring
