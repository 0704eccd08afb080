// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/model/tissue_model.h"

namespace palpate {

/// Volumes with the tables of what lies around each particle filled in. The corners must be
/// particles, 0 to particle_count - 1, which is not checked here but by validate().
Volumes build_volumes(int particle_count, std::vector<std::array<int, 4>> corners,
                      std::vector<double> rest_volume, std::vector<double> bulk,
                      double nodal_share = 0.0);

/// A linear solid's table likewise; pushes reach all of its surface.
Elastic build_elastic(int particle_count, std::vector<std::array<int, 4>> corners,
                      std::vector<double> lame, std::vector<double> shear, double nodal_share = 0.0,
                      double damping_time = 0.0);

/// Tetrahedra of a solid of either law: those of its volumes, or of its elastic table.
inline const std::vector<std::array<int, 4>>& list_tetrahedra(const TissueModel& model) noexcept {
  return model.elastic.corners.empty() ? model.volumes.corners : model.elastic.corners;
}

/// Sets `surface` [m] to where the vertices of a surface are that rides on particles at x [m].
void move_skin(const Skin& skin, std::span<const Vec3> x, std::span<Vec3> surface) noexcept;

/// [m] Where the vertices of the model's surface are with its particles at x [m]: the skin's, or
/// the particles themselves.
Vec3Array compute_surface(const TissueModel& model, std::span<const Vec3> x);

/// [kg] With what mass a vertex of the surface withstands a push when all of the surface is pushed
/// alike: that of its particle, or under a skin 1 / sum of |w_v w_u| / m over all vertices u and
/// the particles that carry both. K_s A, with A the compliance of the vertices, then has no larger
/// an eigenvalue than K_s over these masses, whatever the stiffness K_s of contacts.
std::vector<double> compute_surface_mass(const TissueModel& model);

}  // namespace palpate
