// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/model/build_solid.h"
#include "scenes/tissues.h"

/// Solids of tetrahedra for the laws of volume.
namespace palpate::scenes {

/// A box around the origin with the given sides [m], cut into cells and each of these into six
/// tetrahedra, inner vertices moved by up to a tenth of a cell.
inline SolidMesh make_block(const Vec3& sides, const std::array<int, 3>& cells) {
  const int nx = cells[0], ny = cells[1], nz = cells[2];  // clang 14 captures no structured binding
  const auto number = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  SolidMesh solid;
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        const bool inner = i > 0 && j > 0 && k > 0 && i < nx && j < ny && k < nz;
        const auto seed = static_cast<std::uint32_t>(3 * number(i, j, k));
        const Vec3 shift = inner ? 0.1 * Vec3(scatter(seed), scatter(seed + 1), scatter(seed + 2))
                                 : Vec3(Vec3::Zero());
        const Vec3 at = Vec3((i + shift.x()) / nx, (j + shift.y()) / ny, (k + shift.z()) / nz);
        solid.vertices.push_back((at - Vec3::Constant(0.5)).cwiseProduct(sides));
      }
    }
  }
  // the six paths from one corner of a cell to the one opposite, an axis at a time
  constexpr std::array<std::array<int, 3>, 6> kPaths = {
      {{{0, 1, 2}}, {{1, 2, 0}}, {{2, 0, 1}}, {{0, 2, 1}}, {{2, 1, 0}}, {{1, 0, 2}}}};
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        for (std::size_t path = 0; path < kPaths.size(); ++path) {
          std::array<int, 3> at = {i, j, k};
          std::array<int, 4> corners{};
          corners[0] = number(i, j, k);
          for (std::size_t s = 0; s < 3; ++s) {
            ++at[static_cast<std::size_t>(kPaths[path][s])];
            corners[s + 1] = number(at[0], at[1], at[2]);
          }
          if (path >= 3) std::swap(corners[2], corners[3]);
          solid.tetrahedra.push_back(corners);
        }
      }
    }
  }
  return solid;
}

/// A block with its edges rounded off, 100 x 70 x 60 mm.
inline SolidMesh make_round_block(int cells) {
  SolidMesh solid = make_block({2.0, 2.0, 2.0}, {cells, cells, cells});
  for (Vec3& x : solid.vertices) {
    const double most = x.cwiseAbs().maxCoeff();
    const double round = most > 0.0 ? most / x.norm() : 1.0;
    x = x.cwiseProduct((0.5 + 0.5 * round) * Vec3(0.05, 0.035, 0.03));
  }
  return solid;
}

inline std::vector<int> find_base(const SolidMesh& solid) {
  return find_base(SurfaceMesh{solid.vertices, {}});
}

/// A solid of 5 kPa held at its base.
inline TissueModel make_solid_organ(int cells, double nodal_share, const Losses& losses = {},
                                    double poisson_ratio = 0.45) {
  const SolidMesh solid = make_round_block(cells);
  Material material = make_material(losses);
  material.poisson_ratio = poisson_ratio;
  SolidOptions options;
  options.nodal_share = nodal_share;
  options.fixed = find_base(solid);
  options.drag = losses.drag;
  options.damping_law = losses.law;
  return build_solid(solid, material, options);
}

/// The same under an ellipsoid that rides on it.
inline TissueModel make_covered_organ(int cells, double nodal_share, const Losses& losses = {}) {
  return cover_with_skin(make_solid_organ(cells, nodal_share, losses),
                         make_ellipsoid({0.045, 0.032, 0.027}, 3));
}

}  // namespace palpate::scenes
