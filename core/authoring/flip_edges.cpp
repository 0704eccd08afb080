// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/flip_edges.h"

#include <cmath>
#include <numbers>

#include "palpate/authoring/edge_groups.h"
#include "palpate/authoring/triangle_shape.h"

namespace palpate::authoring {
namespace {

/// Opposite angles this little over pi are rounding: flipping would go to and fro.
constexpr double kLeastExcess = 1e-3;

/// The triangles u v a and v u b over the edge u v.
struct Diamond {
  int first, second;  // triangles
  int u, v, a, b;
  double excess;
};

class Flipping {
 public:
  Flipping(SurfaceMesh& mesh, const std::vector<char>& held,
           std::span<const std::array<int, 2>> kept)
      : mesh_(mesh),
        held_(held),
        kept_(kept),
        sides_(sort_half_edges(mesh.triangles)),
        valence_(mesh.vertices.size(), 0),
        on_border_(mesh.vertices.size(), 0),
        changed_(mesh.vertices.size(), 0) {
    for (const Triangle& t : mesh.triangles) {
      for (const int v : t) ++valence_[v];
    }
  }

  std::vector<Diamond> find_candidates() {
    std::vector<Diamond> found;
    for_each_edge(sides_, [&](std::span<const HalfEdge> edge) {
      if (edge.size() != 2) {
        on_border_[edge[0].low] = on_border_[edge[0].high] = 1;
        return;
      }
      if (std::binary_search(kept_.begin(), kept_.end(), std::array{edge[0].low, edge[0].high})) {
        return;
      }
      const Diamond d = find_diamond(edge[0], edge[1]);
      if (d.excess > kLeastExcess) found.push_back(d);
    });
    std::stable_sort(found.begin(), found.end(),
                     [](const Diamond& l, const Diamond& r) { return l.excess > r.excess; });
    return found;
  }

  bool flip(const Diamond& d) {
    const int around[] = {d.u, d.v, d.a, d.b};
    for (const int x : around) {
      if (changed_[x]) return false;
    }
    const auto is_held = [&](int x) { return held_[x] != 0; };
    if (!held_.empty() && std::all_of(std::begin(around), std::end(around), is_held)) return false;
    if (!keeps_valence(d.u) || !keeps_valence(d.v) || has_edge(d.a, d.b) || !stays_flat(d)) {
      return false;
    }
    mesh_.triangles[d.first] = {d.a, d.u, d.b};
    mesh_.triangles[d.second] = {d.b, d.v, d.a};
    for (const int x : around) changed_[x] = 1;
    return true;
  }

 private:
  const Vec3& at(int v) const { return mesh_.vertices[v]; }

  Diamond find_diamond(const HalfEdge& one, const HalfEdge& other) const {
    const Triangle &s = mesh_.triangles[one.triangle], &t = mesh_.triangles[other.triangle];
    Diamond d{one.triangle,
              other.triangle,
              s[one.corner],
              s[(one.corner + 1) % 3],
              s[(one.corner + 2) % 3],
              t[(other.corner + 2) % 3],
              0.0};
    d.excess = angle_at(at(d.a), at(d.u), at(d.v)) + angle_at(at(d.b), at(d.u), at(d.v)) -
               std::numbers::pi;
    return d;
  }

  bool keeps_valence(int v) const { return on_border_[v] || valence_[v] > 3; }

  bool has_edge(int i, int j) const {
    const HalfEdge wanted{std::min(i, j), std::max(i, j), 0, 0, true};
    return std::binary_search(sides_.begin(), sides_.end(), wanted,
                              [](const HalfEdge& l, const HalfEdge& r) {
                                return std::tie(l.low, l.high) < std::tie(r.low, r.high);
                              });
  }

  Vec3 normal(int i, int j, int k) const { return normal_of({at(i), at(j), at(k)}); }

  bool stays_flat(const Diamond& d) const {
    const Vec3 before = normal(d.u, d.v, d.a), across = normal(d.v, d.u, d.b);
    if (is_turned(before, across)) return false;  // a ridge of the organ
    const Vec3 mean = before + across;
    return !is_turned(normal(d.a, d.u, d.b), mean) && !is_turned(normal(d.b, d.v, d.a), mean);
  }

  SurfaceMesh& mesh_;
  const std::vector<char>& held_;
  std::span<const std::array<int, 2>> kept_;
  std::vector<HalfEdge> sides_;
  std::vector<int> valence_;
  std::vector<char> on_border_, changed_;  // the table of sides is stale around what changed
};

}  // namespace

int flip_edges(SurfaceMesh& mesh, const std::vector<char>& held,
               std::span<const std::array<int, 2>> kept) {
  Flipping flipping(mesh, held, kept);
  int flips = 0;
  for (const Diamond& d : flipping.find_candidates()) flips += flipping.flip(d);
  return flips;
}

}  // namespace palpate::authoring
