// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/remove_crossings.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "palpate/authoring/fill_holes.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

/// A piece that comes off and has less than this part of its shell's triangles is dropped: what is
/// larger is no tip of a spike, and to cut it off would change the organ.
constexpr double kScrap = 0.05;

/// A wound that takes more than this part of a shell's triangles is no repair of a place.
constexpr double kLocal = 0.1;

/// Disjoint sets of numbers, the least of each standing for it.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void unite(int i, int j) {
    const int a = find(i), b = find(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

using Marks = std::vector<char>;

/// Marks what shares a vertex with a marked triangle, `rings` times.
void grow(const SurfaceMesh& mesh, int rings, Marks& taken) {
  for (int ring = 0; ring < rings; ++ring) {
    Marks touched(mesh.vertices.size(), 0);
    for (std::size_t t = 0; t < taken.size(); ++t) {
      if (!taken[t]) continue;
      for (const int v : mesh.triangles[t]) touched[v] = 1;
    }
    for (std::size_t t = 0; t < taken.size(); ++t) {
      for (const int v : mesh.triangles[t]) taken[t] = taken[t] || touched[v];
    }
  }
}

/// The wounds that taking triangles out leaves: sets of them that hang together by vertices.
class Wounds {
 public:
  Wounds(const SurfaceMesh& mesh, const Marks& taken)
      : mesh_(mesh), sets_(mesh.vertices.size()), taken_(taken) {
    for (std::size_t t = 0; t < taken.size(); ++t) {
      if (!taken[t]) continue;
      sets_.unite(mesh.triangles[t][0], mesh.triangles[t][1]);
      sets_.unite(mesh.triangles[t][0], mesh.triangles[t][2]);
    }
  }

  int find(int vertex) { return sets_.find(vertex); }

  /// They are repaired together or not at all.
  void unite(int vertex, int other) { sets_.unite(vertex, other); }

  const Marks& taken() const { return taken_; }

  /// The vertices of triangles that were taken out.
  Marks find_touched() const {
    Marks touched(mesh_.vertices.size(), 0);
    for (std::size_t t = 0; t < taken_.size(); ++t) {
      if (!taken_[t]) continue;
      for (const int v : mesh_.triangles[t]) touched[v] = 1;
    }
    return touched;
  }

 private:
  const SurfaceMesh& mesh_;
  Sets sets_;
  const Marks& taken_;
};

/// The pieces of what is left: each triangle's, -1 for one that was taken out, counted from 0.
std::vector<int> find_pieces(const SurfaceMesh& mesh, const Marks& taken, int& count) {
  Sets sets(mesh.triangles.size());
  const Topology topology = build_topology(mesh.triangles);
  for (const auto& [i, j] : topology.edge_triangles) {
    if (j >= 0 && !taken[i] && !taken[j]) sets.unite(i, j);
  }
  std::vector<int> piece(mesh.triangles.size(), -1);
  count = 0;
  for (int t = 0; t < static_cast<int>(piece.size()); ++t) {
    if (taken[t]) continue;
    const int root = sets.find(t);
    piece[t] = root == t ? count++ : piece[root];
  }
  return piece;
}

struct Cut {
  std::vector<int> piece;  ///< of each triangle
  Marks scrap;             ///< of each piece: it is dropped
};

/// Which pieces are scrap, and which wounds would part a shell into pieces that are none: those
/// are added to `kept_out`, by the vertex that stands for them.
Cut cut_apart(const SurfaceMesh& mesh, Wounds& wounds, std::set<int>& kept_out) {
  const std::vector<int> shell =
      find_shells(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  int count = 0;
  Cut cut;
  cut.piece = find_pieces(mesh, wounds.taken(), count);
  std::vector<int> size(count, 0), shell_of(count, -1);
  std::vector<int> shell_size(mesh.vertices.size(), 0), largest(mesh.vertices.size(), -1);
  for (std::size_t t = 0; t < cut.piece.size(); ++t) {
    const int of = shell[mesh.triangles[t][0]];
    ++shell_size[of];
    if (cut.piece[t] < 0) continue;
    ++size[cut.piece[t]];
    shell_of[cut.piece[t]] = of;
  }
  for (int p = 0; p < count; ++p) {
    int& best = largest[shell_of[p]];
    if (best < 0 || size[p] > size[best]) best = p;
  }
  cut.scrap.assign(count, 0);
  for (int p = 0; p < count; ++p) {
    cut.scrap[p] = p != largest[shell_of[p]] && size[p] < kScrap * shell_size[shell_of[p]];
  }
  const Marks touched = wounds.find_touched();
  std::vector<int> wound_of(count, -1);
  for (std::size_t t = 0; t < cut.piece.size(); ++t) {
    const int p = cut.piece[t];
    if (p < 0 || p == largest[shell_of[p]]) continue;
    for (const int v : mesh.triangles[t]) {
      if (!touched[v]) continue;
      if (wound_of[p] >= 0) wounds.unite(wound_of[p], v);
      wound_of[p] = v;
    }
  }
  for (int p = 0; p < count; ++p) {
    if (!cut.scrap[p] && wound_of[p] >= 0) kept_out.insert(wounds.find(wound_of[p]));
  }
  return cut;
}

/// Wounds that take too much of their shell.
void keep_large_out(const SurfaceMesh& mesh, Wounds& wounds, std::set<int>& kept_out) {
  const std::vector<int> shell =
      find_shells(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  std::vector<int> shell_size(mesh.vertices.size(), 0), size(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    ++shell_size[shell[mesh.triangles[t][0]]];
    if (wounds.taken()[t]) ++size[wounds.find(mesh.triangles[t][0])];
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!wounds.taken()[t]) continue;
    const int v = mesh.triangles[t][0], wound = wounds.find(v);
    if (size[wound] > kLocal * shell_size[shell[v]]) kept_out.insert(wound);
  }
}

/// Wounds of which a border of the surface itself is part.
void keep_borders_out(const SurfaceMesh& mesh, Wounds& wounds, std::set<int>& kept_out) {
  const Marks touched = wounds.find_touched();
  for (const auto& loop : find_border_loops(mesh.triangles)) {
    for (const int v : loop) {
      if (touched[v]) kept_out.insert(wounds.find(v));
    }
  }
}

/// The surface without the wounds that are not kept out, and their scrap. Vertices stay.
SurfaceMesh take_out(const SurfaceMesh& mesh, const Cut& cut, Wounds& wounds,
                     const std::set<int>& kept_out, UncrossedMesh& told) {
  SurfaceMesh opened;
  opened.vertices = mesh.vertices;
  std::set<int> dropped;
  const Marks touched = wounds.find_touched();
  std::vector<char> stays(cut.scrap.size(), 1);
  for (std::size_t t = 0; t < cut.piece.size(); ++t) {
    const int p = cut.piece[t];
    if (p < 0 || !cut.scrap[p]) continue;
    for (const int v : mesh.triangles[t]) {
      if (touched[v]) stays[p] = kept_out.contains(wounds.find(v));
    }
  }
  told.replaced_triangles = 0;
  for (std::size_t t = 0; t < cut.piece.size(); ++t) {
    const int p = cut.piece[t];
    const bool wound = p < 0 && !kept_out.contains(wounds.find(mesh.triangles[t][0]));
    const bool scrap = p >= 0 && cut.scrap[p] && !stays[p];
    if (scrap) dropped.insert(p);
    told.replaced_triangles += wound || scrap;
    if (!wound && !scrap) opened.triangles.push_back(mesh.triangles[t]);
  }
  told.dropped_pieces = static_cast<int>(dropped.size());
  return opened;
}

/// Drops vertices that no triangle uses; `number` says where each went, -1 for nowhere.
SurfaceMesh compact(const SurfaceMesh& mesh, std::vector<int>& origin) {
  std::vector<int> place(mesh.vertices.size(), -1);
  for (const Triangle& t : mesh.triangles) {
    for (const int v : t) place[v] = 0;
  }
  SurfaceMesh kept;
  origin.clear();
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] < 0) continue;
    place[v] = static_cast<int>(kept.vertices.size());
    kept.vertices.push_back(mesh.vertices[v]);
    origin.push_back(static_cast<int>(v));
  }
  for (const Triangle& t : mesh.triangles) {
    kept.triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
  }
  return kept;
}

/// The loops that are wounds: those that touch one.
std::vector<int> find_wound_loops(const std::vector<std::vector<int>>& loops,
                                  const std::vector<int>& origin, const Marks& touched) {
  std::vector<int> found;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto is_touched = [&](int v) { return touched[origin[v]] != 0; };
    if (std::any_of(loops[i].begin(), loops[i].end(), is_touched)) {
      found.push_back(static_cast<int>(i));
    }
  }
  return found;
}

/// Loops that cannot be closed, because two of them pass through one vertex, or no patch fits:
/// their wounds are kept out. Whether there are any.
bool keep_open_out(const std::vector<std::vector<int>>& loops, const std::vector<int>& left_open,
                   const std::vector<int>& origin, Wounds& wounds, std::set<int>& kept_out) {
  for (const int i : left_open) kept_out.insert(wounds.find(origin[loops[i].front()]));
  return !left_open.empty();
}

/// Wounds that were united after one of them was kept out are kept out together.
void settle(Wounds& wounds, std::set<int>& kept_out) {
  std::set<int> settled;
  for (const int v : kept_out) settled.insert(wounds.find(v));
  kept_out = std::move(settled);
}

}  // namespace

UncrossedMesh remove_crossings(const SurfaceMesh& mesh, int rings) {
  validate(mesh);
  UncrossedMesh result;
  result.mesh = mesh;
  const auto faces = find_self_intersecting_faces(mesh);
  if (!faces || faces->empty()) return result;
  Marks taken(mesh.triangles.size(), 0);
  for (const int t : *faces) taken[t] = 1;
  grow(mesh, rings, taken);

  Wounds wounds(mesh, taken);
  std::set<int> kept_out;
  const Cut cut = cut_apart(mesh, wounds, kept_out);
  keep_borders_out(mesh, wounds, kept_out);
  keep_large_out(mesh, wounds, kept_out);
  settle(wounds, kept_out);
  const Marks touched = wounds.find_touched();
  // each time round at least one wound more is kept out
  for (;;) {
    UncrossedMesh next;
    std::vector<int> origin;
    const SurfaceMesh opened = compact(take_out(mesh, cut, wounds, kept_out, next), origin);
    if (next.replaced_triangles == 0 || opened.triangles.empty()) return result;
    const auto loops = find_border_loops(opened.triangles);
    FilledHoles filled = fill_holes(opened, find_wound_loops(loops, origin, touched));
    if (keep_open_out(loops, filled.left_open, origin, wounds, kept_out)) continue;
    next.mesh = std::move(filled.mesh);
    return next;
  }
}

}  // namespace palpate::authoring
