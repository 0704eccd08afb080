// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/collapse_short_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace palpate::authoring {
namespace {

/// [-] Of the middle one of all edges, where none is meant to be finer. Fillings of smooth surfaces
/// have none below a fifth.
constexpr double kShort = 0.12;
constexpr int kMostRounds = 10;
/// [-] How much of the worst shape around an edge may be lost by merging its ends.
constexpr double kKept = 0.5;

using Face = std::array<int, 3>;
using Tetrahedron = std::array<int, 4>;

Face sort_face(int a, int b, int c) {
  Face face{a, b, c};
  std::sort(face.begin(), face.end());
  return face;
}

class Merger {
 public:
  explicit Merger(SolidMesh& solid) : solid_(solid), at_(solid.vertices.size()) {
    for (std::size_t t = 0; t < solid.tetrahedra.size(); ++t) {
      for (const int v : solid.tetrahedra[t]) at_[v].push_back(static_cast<int>(t));
    }
    alive_.assign(solid.tetrahedra.size(), true);
    find_outside();
  }

  /// Merges what it can of edges below a share of the middle one, the shortest first. False where
  /// there was none.
  bool run(double share) {
    bool done = false;
    const auto edges = list_edges();
    const double least = share * edges[edges.size() / 2].first;
    for (const auto& [length, ends] : edges) {
      if (!(length < least)) break;
      const auto [a, b] = ends;
      if (at_[a].empty() || at_[b].empty() || !is_edge(a, b)) continue;
      done = merge(b, a) || merge(a, b) || done;  // the first there was stays
    }
    return done;
  }

  /// What is left, in the order it had.
  void tidy() {
    std::vector<int> number(solid_.vertices.size(), -1);
    Vec3Array vertices;
    for (std::size_t v = 0; v < at_.size(); ++v) {
      if (at_[v].empty()) continue;
      number[v] = static_cast<int>(vertices.size());
      vertices.push_back(solid_.vertices[v]);
    }
    auto& tetrahedra = solid_.tetrahedra;
    std::size_t kept = 0;
    for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
      if (!alive_[t]) continue;
      tetrahedra[kept] = tetrahedra[t];
      for (int& v : tetrahedra[kept]) v = number[v];
      ++kept;
    }
    tetrahedra.resize(kept);
    solid_.vertices = std::move(vertices);
  }

 private:
  void find_outside() {
    std::map<Face, int> count;
    for (const auto& t : solid_.tetrahedra) {
      for (int i = 0; i < 4; ++i)
        ++count[sort_face(t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4])];
    }
    outside_.assign(solid_.vertices.size(), false);
    for (const auto& [face, times] : count) {
      for (const int v : face) outside_[v] = outside_[v] || times == 1;
    }
  }

  double measure(int a, int b) const { return (solid_.vertices[a] - solid_.vertices[b]).norm(); }

  bool is_edge(int a, int b) const {
    return std::any_of(at_[a].begin(), at_[a].end(), [&](int t) { return has(t, b); });
  }

  bool has(int t, int v) const {
    const auto& corners = solid_.tetrahedra[t];
    return std::find(corners.begin(), corners.end(), v) != corners.end();
  }

  /// Every edge once, with its length [m].
  std::vector<std::pair<double, std::array<int, 2>>> list_edges() const {
    std::vector<std::pair<double, std::array<int, 2>>> edges;
    for (std::size_t t = 0; t < solid_.tetrahedra.size(); ++t) {
      if (!alive_[t]) continue;
      const auto& corners = solid_.tetrahedra[t];
      for (int i = 0; i < 4; ++i) {
        for (int j = i + 1; j < 4; ++j) {
          const auto [a, b] = std::minmax(corners[i], corners[j]);
          edges.push_back({measure(a, b), {a, b}});
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  /// [-] Of a tetrahedron: 1 of a regular one, 0 of a flat one, negative of one turned over.
  double find_shape(const Tetrahedron& t) const {
    const auto& x = solid_.vertices;
    double squares = 0.0;
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) squares += (x[t[i]] - x[t[j]]).squaredNorm();
    }
    const double volume = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).dot(x[t[3]] - x[t[0]]) / 6.0;
    return 6.0 * std::sqrt(2.0) * volume / std::pow(squares / 6.0, 1.5);
  }

  /// Moves `from` to `to`, where that leaves a solid. False, with nothing changed, where not.
  bool merge(int from, int to) {
    if (outside_[from] && !outside_[to]) return false;
    double worst = 1.0;
    std::vector<int> gone, moved;
    for (const int t : at_[from]) {
      worst = std::min(worst, find_shape(solid_.tetrahedra[t]));
      (has(t, to) ? gone : moved).push_back(t);
    }
    std::vector<Tetrahedron> after;
    for (const int t : moved) {
      Tetrahedron corners = solid_.tetrahedra[t];
      std::replace(corners.begin(), corners.end(), from, to);
      if (!(find_shape(corners) > kKept * std::max(worst, 0.0))) return false;
      after.push_back(corners);
    }
    if (!is_sound(to, gone, after)) return false;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      solid_.tetrahedra[moved[i]] = after[i];
      at_[to].push_back(moved[i]);
    }
    for (const int t : gone) {
      alive_[t] = false;
      for (const int v : solid_.tetrahedra[t]) std::erase(at_[v], t);
    }
    at_[from].clear();
    return true;
  }

  /// Whether no face at `to` would have three tetrahedra, and its outside would be one fan.
  bool is_sound(int to, const std::vector<int>& gone, const std::vector<Tetrahedron>& after) const {
    std::map<Face, int> faces;
    const auto note = [&](const Tetrahedron& t) {
      for (int i = 0; i < 4; ++i) {
        if (t[i] != to) {
          ++faces[sort_face(t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4])];
        }
      }
    };
    for (const int t : at_[to]) {
      if (std::find(gone.begin(), gone.end(), t) == gone.end()) note(solid_.tetrahedra[t]);
    }
    for (const Tetrahedron& t : after) note(t);
    std::map<int, std::vector<int>> rim;  // neighbours on the outside
    for (const auto& [face, times] : faces) {
      if (times > 2) return false;
      if (times == 2) continue;
      std::array<int, 2> ends{};
      std::size_t k = 0;
      for (const int v : face) {
        if (v != to) ends[k++ % 2] = v;
      }
      rim[ends[0]].push_back(ends[1]);
      rim[ends[1]].push_back(ends[0]);
    }
    return is_one_loop(rim);
  }

  static bool is_one_loop(const std::map<int, std::vector<int>>& rim) {
    if (rim.empty()) return true;
    for (const auto& [v, next] : rim) {
      if (next.size() != 2) return false;
    }
    const int first = rim.begin()->first;
    int before = first, at = rim.begin()->second[0];
    std::size_t count = 1;
    while (at != first && count <= rim.size()) {
      const auto& next = rim.at(at);
      const int step = next[0] == before ? next[1] : next[0];
      before = at;
      at = step;
      ++count;
    }
    return count == rim.size();
  }

  SolidMesh& solid_;
  std::vector<std::vector<int>> at_;  ///< tetrahedra of each vertex
  std::vector<bool> alive_, outside_;
};

}  // namespace

void collapse_short_edges(double finest, SolidMesh& solid) {
  if (solid.tetrahedra.empty()) return;
  Merger merger(solid);
  int rounds = 0;
  while (rounds < kMostRounds && merger.run(kShort * finest)) ++rounds;
  if (rounds > 0) merger.tidy();
}

}  // namespace palpate::authoring
