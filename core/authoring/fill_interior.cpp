// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/fill_interior.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "palpate/authoring/cgal/fill_with_mesh_3.h"
#include "palpate/authoring/collapse_short_edges.h"
#include "palpate/authoring/self_intersections.h"
#include "palpate/authoring/source_surface.h"
#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/mesh/topology.h"

namespace palpate::authoring {
namespace {

/// Mesh_3 at a cell size L gives this many tetrahedra per volume of L³, from 5.4 on the shipped
/// spleen to 6.8 on the kidney, whose surface is large for its volume.
constexpr double kTetrahedraPerCell = 6.0;
/// The same beside what is left once cells are improved: what fill_to_count begins with.
constexpr double kFirstGuess = 4.45;
/// Sizes that are tried; the number of cells is nearly a power of the size, so two or three do.
constexpr int kMostTries = 10;
/// [-] A try is accepted this near, since improving takes some cells away again.
constexpr double kNearEnough = 0.08;
/// [-] The same where it is graded: more of the flattest tetrahedra are taken out afterwards.
constexpr double kNearEnoughGraded = 0.05;
/// [-] What is tried for there beside what is wanted.
constexpr double kLostGraded = 1.04;
/// [-] Of the most there may be: what is tried for where nearly as many are asked for.
constexpr double kNearMost = 0.96;
/// [-] The most that a size changes between two tries.
constexpr double kMostChange = 2.0;
/// [-] A cell size that was chosen for the most there may be gives as many but for rounding.
constexpr double kRounding = 1e-9;

void check_surface(const SurfaceMesh& surface) {
  validate(surface);
  if (!is_closed(surface.triangles)) {
    const std::size_t loops = find_border_loops(surface.triangles).size();
    refuse("fill: surface",
           write_text("an open one, with ", loops, loops == 1 ? " hole" : " holes"),
           "a closed one: nothing says how far the inside of an open one goes");
  }
  const double volume = compute_volume(surface);
  if (!(volume > 0.0)) {
    refuse("fill: surface", write_text("a volume of ", volume, " m³"),
           "a positive one: triangles counter-clockwise from outside");
  }
  const auto crossing = find_self_intersecting_faces(surface);
  if (!crossing || !crossing->empty()) {
    refuse("fill: surface",
           crossing ? write_text(crossing->size(), " triangles that cross others")
                    : std::string("more triangles upon each other than can be counted"),
           "a surface that does not cross itself");
  }
}

void check_count(int tetrahedron_count) {
  if (tetrahedron_count >= 1 && tetrahedron_count <= kMostTetrahedra) return;
  refuse("fill: tetrahedron_count", write_text(tetrahedron_count),
         write_text("1 to ", kMostTetrahedra));
}

void check_fine(const SurfaceMesh& surface, const FineRegion& fine) {
  if (!(fine.ratio > 0.0 && fine.ratio <= 1.0)) {
    refuse("fill: fine ratio", write_text(fine.ratio), "above 0 to 1");
  }
  const int count = static_cast<int>(surface.triangles.size());
  for (const int t : fine.triangles) {
    if (t < 0 || t >= count) {
      refuse("fill: fine triangles", write_text(t), write_text("0 to ", count - 1));
    }
  }
}

/// Smaller at the fine triangles, and growing with the distance from them.
class FineNear {
 public:
  FineNear(const SurfaceMesh& surface, const FineRegion& fine) : ratio_(fine.ratio) {
    if (fine.triangles.empty() || fine.ratio == 1.0) return;
    SurfaceMesh part;
    part.vertices = surface.vertices;
    for (const int t : fine.triangles) part.triangles.push_back(surface.triangles[t]);
    tree_ = std::make_shared<const SourceSurface>(part);
  }

  /// A size at which no more cells come than without a fine region: too few are found sooner.
  double begin(double size) const { return tree_ ? size / ratio_ : size; }

  CellSize size(double largest) const {
    if (!tree_) return {largest};
    return {largest, [tree = tree_, ratio = ratio_, largest](const Vec3& p) {
              const double away = (tree->find_closest(p).point - p).norm();
              return std::min(largest, ratio * largest + kGrowth * away);
            }};
  }

 private:
  double ratio_;
  std::shared_ptr<const SourceSurface> tree_;
};

/// The number of cells between two sizes that were tried, or beyond them: a power of the size.
class SizeSearch {
 public:
  SizeSearch(double first, double wanted) : size_(first), wanted_(std::log(wanted)) {}

  double size() const { return size_; }

  /// Notes how many came of size(), and takes the next size.
  void note(std::size_t count) {
    const double found = std::log(static_cast<double>(std::max<std::size_t>(count, 1)));
    const double at = std::log(size_);
    auto& bound = found > wanted_ ? low_ : high_;
    bound = {at, found};
    double next = at + (found - wanted_) / 3.0;
    if (low_ && high_) {
      const double slope = (high_->second - low_->second) / (high_->first - low_->first);
      const double share = slope < 0.0 ? (wanted_ - low_->second) / slope : 0.0;
      const double width = high_->first - low_->first;
      // well inside, so that it ends also where numbers jump
      next = low_->first + std::clamp(share, 0.1 * width, 0.9 * width);
    }
    const double most = std::log(kMostChange);
    size_ = std::exp(std::clamp(next, at - most, at + most));
  }

 private:
  double size_, wanted_;
  std::optional<std::pair<double, double>> low_, high_;  // too many cells, too few
};

/// Without vertices that only flat tetrahedra had, and without those.
SolidMesh tidy(const SolidMesh& solid) {
  SolidMesh tidied;
  std::vector<int> number(solid.vertices.size(), -1);
  for (auto corners : solid.tetrahedra) {
    auto& [a, b, c, d] = corners;
    const double volume =
        compute_volume(solid.vertices[a], solid.vertices[b], solid.vertices[c], solid.vertices[d]);
    if (volume == 0.0) continue;
    if (volume < 0.0) std::swap(c, d);
    for (int& i : corners) {
      if (number[i] < 0) {
        number[i] = static_cast<int>(tidied.vertices.size());
        tidied.vertices.push_back(solid.vertices[i]);
      }
      i = number[i];
    }
    tidied.tetrahedra.push_back(corners);
  }
  return tidied;
}

}  // namespace

void check_cell_size(const SurfaceMesh& surface, double cell_size) {
  if (!(std::isfinite(cell_size) && cell_size > 0.0)) {
    refuse("fill: cell_size", write_text(cell_size, " m"), "a positive number");
  }
  const double volume = compute_volume(surface);
  const double expected = kTetrahedraPerCell * volume / std::pow(cell_size, 3);
  if (expected > kMostTetrahedra * (1.0 + kRounding)) {
    refuse(
        "fill: cell_size",
        write_text(1e3 * cell_size, " mm, which gives about ", std::round(expected), " tetrahedra"),
        write_text("at least ", 1e3 * std::cbrt(kTetrahedraPerCell * volume / kMostTetrahedra),
                   " mm for at most ", kMostTetrahedra));
  }
}

double choose_cell_size(const SurfaceMesh& surface, int tetrahedron_count) {
  check_surface(surface);
  check_count(tetrahedron_count);
  return std::cbrt(kTetrahedraPerCell * compute_volume(surface) / tetrahedron_count);
}

SolidMesh fill_interior(const SurfaceMesh& surface, double cell_size) {
  check_surface(surface);
  check_cell_size(surface, cell_size);
  SolidMesh solid = tidy(fill_with_mesh_3(surface, {cell_size}));
  if (solid.tetrahedra.empty()) {
    refuse("fill: cell_size", write_text(1e3 * cell_size, " mm, at which nothing is filled"),
           "a smaller one");
  }
  collapse_short_edges(1.0, solid);
  validate(solid);
  return solid;
}

SolidMesh fill_to_count(const SurfaceMesh& surface, int tetrahedron_count, const FineRegion& fine) {
  check_surface(surface);
  check_count(tetrahedron_count);
  check_fine(surface, fine);
  const bool is_graded = !fine.triangles.empty();
  const double enough = is_graded ? kNearEnoughGraded : kNearEnough;
  const double wanted =
      std::min(tetrahedron_count * (is_graded ? kLostGraded : 1.0), kNearMost * kMostTetrahedra);
  const FineNear near(surface, fine);
  const double volume = compute_volume(surface);
  SizeSearch search(near.begin(std::cbrt(kFirstGuess * volume / wanted)), wanted);
  SolidMesh best;
  double best_size = search.size(), least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostTries && best.tetrahedra.empty(); ++i) {
    const double size = search.size();
    std::size_t count = 0;
    best = tidy(fill_with_mesh_3(surface, near.size(size), [&](std::size_t cells) {
      count = cells;
      const auto found = static_cast<double>(cells);
      return found <= kMostTetrahedra && std::abs(found / wanted - 1.0) < enough;
    }));
    const double error = std::abs(std::log(std::max<double>(1.0, count) / wanted));
    if (error < least) std::tie(best_size, least) = std::pair(size, error);
    search.note(count);
  }
  if (best.tetrahedra.empty()) best = tidy(fill_with_mesh_3(surface, near.size(best_size)));
  if (best.tetrahedra.empty()) {
    refuse("fill: surface", "one that no cell fits into", "a body with an inside");
  }
  collapse_short_edges(is_graded ? fine.ratio : 1.0, best);
  validate(best);
  return best;
}

}  // namespace palpate::authoring
