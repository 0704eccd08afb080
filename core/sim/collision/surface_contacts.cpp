// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/collision/private/surface_contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "palpate/sim/collision/private/held_kernels.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/tree/private/box_distance.h"
#include "palpate/sim/tree/queries.h"

namespace palpate {
namespace {

/// The triangles around each vertex, one list after the other.
struct Around {
  Around(std::span<const Triangle> triangles, std::size_t vertices) : first(vertices + 1, 0) {
    for (const Triangle& triangle : triangles) {
      for (const int v : triangle) ++first[static_cast<std::size_t>(v) + 1];
    }
    for (std::size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
    list.resize(static_cast<std::size_t>(first.back()));
    std::vector<int> at(first.begin(), first.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (const int v : triangles[t]) {
        list[static_cast<std::size_t>(at[static_cast<std::size_t>(v)]++)] = static_cast<int>(t);
      }
    }
  }
  std::span<const int> of(int vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return std::span(list).subspan(static_cast<std::size_t>(first[v]),
                                   static_cast<std::size_t>(first[v + 1] - first[v]));
  }
  std::vector<int> first, list;
};

/// What shares a corner with a triangle of the vertex is at hand at rest, and no contact.
void exclude_rings(std::span<const Triangle> triangles, std::size_t vertices,
                   SurfaceContacts& contacts) {
  const Around around(triangles, vertices);
  contacts.first_excluded.assign(1, 0);
  std::vector<int> ring;
  for (std::size_t v = 0; v < vertices; ++v) {
    ring.clear();
    for (const int t : around.of(static_cast<int>(v))) {
      for (const int corner : triangles[static_cast<std::size_t>(t)]) {
        const std::span<const int> next = around.of(corner);
        ring.insert(ring.end(), next.begin(), next.end());
      }
    }
    std::ranges::sort(ring);
    const auto repeated = std::ranges::unique(ring);
    ring.erase(repeated.begin(), repeated.end());
    contacts.excluded.insert(contacts.excluded.end(), ring.begin(), ring.end());
    contacts.first_excluded.push_back(static_cast<int>(contacts.excluded.size()));
  }
}

std::vector<unsigned char> mark_border(std::span<const Triangle> triangles, std::size_t vertices) {
  std::vector<unsigned char> on_border(vertices, 0);
  const Topology topology = build_topology(triangles);
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    if (topology.edge_triangles[e][1] >= 0) continue;
    for (const int v : topology.edges[e]) on_border[static_cast<std::size_t>(v)] = 1;
  }
  return on_border;
}

bool is_excluded(const SurfaceContacts& contacts, std::size_t v, int triangle) noexcept {
  if (!contacts.same) return false;
  const auto begin = contacts.excluded.begin() + contacts.first_excluded[v],
             end = contacts.excluded.begin() + contacts.first_excluded[v + 1];
  return std::binary_search(begin, end, triangle);
}

/// Of the triangles found for a vertex at p, the nearest as many as there is room for, ascending.
void keep_listed(std::size_t v, const Vec3& p, std::size_t count,
                 std::span<const Triangle> triangles, std::span<const Vec3> x_t,
                 SurfaceContacts& contacts) noexcept {
  std::span<int> found = std::span(contacts.found).first(count);
  if (contacts.same) {
    const auto end = std::remove_if(found.begin(), found.end(),
                                    [&](int t) noexcept { return is_excluded(contacts, v, t); });
    found = found.first(static_cast<std::size_t>(end - found.begin()));
  }
  if (found.size() > SurfaceContacts::kMostListed) {
    const auto distance = [&](int t) noexcept {
      const auto& [a, b, c] = triangles[static_cast<std::size_t>(t)];
      return find_closest_on_triangle(p, x_t[static_cast<std::size_t>(a)],
                                      x_t[static_cast<std::size_t>(b)],
                                      x_t[static_cast<std::size_t>(c)])
          .distance;
    };
    const auto most = static_cast<std::ptrdiff_t>(SurfaceContacts::kMostListed);
    std::partial_sort(found.begin(), found.begin() + most, found.end(), [&](int s, int t) noexcept {
      const double a = distance(s), b = distance(t);
      return a < b || (a == b && s < t);
    });
    found = found.first(SurfaceContacts::kMostListed);
    std::sort(found.begin(), found.end());
  }
  std::ranges::copy(found, contacts.listed[v].begin());
  contacts.listed_count[v] = static_cast<unsigned char>(found.size());
}

void list_vertex(std::size_t v, const Vec3& p, const AabbTree& tree, std::span<const Vec3> x_t,
                 double margin, double behind, SurfaceContacts& contacts) noexcept {
  const double reach = contacts.barrier.thickness + margin;
  const double far = measure_to_box(p, tree) - behind;
  contacts.near_until[v] = contacts.moved;  // the lists of the nearest are of another one
  if (far > reach) {
    contacts.listed_count[v] = 0;
    contacts.listed_until[v] = contacts.moved + (far - contacts.barrier.thickness);
    return;
  }
  const auto count =
      static_cast<std::size_t>(find_in_sphere(tree, x_t, p, reach + behind, contacts.found));
  keep_listed(v, p, count, tree.triangles(), x_t, contacts);
  contacts.listed_until[v] = contacts.moved + margin;
}

}  // namespace

SurfaceContacts::SurfaceContacts(const SurfaceMesh& vertices, const SurfaceMesh& triangles,
                                 const Barrier& barrier_in, bool same_in)
    : SurfaceContacts(compute_vertex_areas(vertices), triangles, barrier_in) {
  same = same_in;
  if (!same) return;
  exclude_rings(triangles.triangles, area.size(), *this);
  std::ranges::fill(side, 0);
}

SurfaceContacts::SurfaceContacts(std::vector<double> areas, const SurfaceMesh& triangles,
                                 const Barrier& barrier_in)
    : barrier(barrier_in),
      closed(is_closed(triangles.triangles)),
      area(std::move(areas)),
      on_border(mark_border(triangles.triangles, triangles.vertices.size())),
      found(triangles.triangles.size()) {
  const std::size_t count = area.size();
  listed_until.assign(count, 0.0);
  listed.assign(count, {});
  listed_count.assign(count, 0);
  near_until.assign(count, 0.0);
  near.assign(count, {});
  near_count.assign(count, 0);
  side.assign(count, closed ? 1 : 0);
  active.assign(count, 0);
  contact.assign(count, {});
  far_until.assign(count, 0.0);
  held_until.assign(count, 0.0);
  resistance.assign(count, kNotKnown);
  held.assign(count, 0);
  lapsed.assign(count, 0);
  held_kernels::best();  // chosen here, as choosing allocates
}

/// A vertex is looked at once in a round, and its list is found again where half of its margin is
/// spent; so no list lapses as long as a round ends before the other half is.
void renew_lists(std::span<const Vec3> x_v, const AabbTree& tree, std::span<const Vec3> x_t,
                 const Travel& travel, SurfaceContacts& contacts) noexcept {
  const std::size_t count = x_v.size();
  const double move = travel.move;
  contacts.moved += move;
  contacts.ahead = travel.ahead;
  const double margin = std::max(kListMargin, 2.0 * contacts.ahead);
  const double spare = 0.5 * margin - contacts.ahead;
  const bool all = !contacts.begun || !(move < spare);
  const double share = all ? 1.0 : move / spare;
  if (all) contacts.next = 0;
  const auto visits = static_cast<std::size_t>(std::ceil(share * static_cast<double>(count)));
  for (std::size_t n = 0; n < visits; ++n) {
    const std::size_t v = contacts.next;
    contacts.next = v + 1 < count ? v + 1 : 0;
    if (contacts.area[v] == 0.0) continue;  // a particle inside
    if (contacts.begun && contacts.listed_until[v] - contacts.moved >= 0.5 * margin) continue;
    list_vertex(v, x_v[v], tree, x_t, margin, travel.behind, contacts);
  }
  contacts.begun = true;
}

}  // namespace palpate
