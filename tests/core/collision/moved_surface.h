// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <doctest/doctest.h>

#include "palpate/sim/collision/private/touching_surface.h"
#include "palpate/sim/model/build_surface.h"
#include "palpate/sim/tree/aabb_tree.h"
#include "scenes/scenes.h"

// Surfaces that a test of contacts moves, and what any contacts of two of them keep.

namespace palpate {

inline TissueModel make_ball(int subdivisions) {
  return build_mass_spring(scenes::make_ellipsoid({0.030, 0.025, 0.020}, subdivisions),
                           {.wall_thickness = 0.003}, 100.0);
}

/// At rest, of a model without a skin.
inline SurfaceMesh surface_of(const TissueModel& model) {
  return {model.rest_position, model.triangles};
}

struct Moved {
  explicit Moved(const TissueModel& model)
      : tissue(model),
        x(model.rest_position),
        velocity(x.size(), Vec3::Zero()),
        tree(x, model.triangles),
        touch(model) {}

  void move_to(const Vec3& offset, const Quaternion& turn = Quaternion::Identity()) {
    for (std::size_t v = 0; v < x.size(); ++v) x[v] = offset + turn * tissue.rest_position[v];
    tree.refit(x);
  }
  TouchingSurface view() { return {tissue, x, velocity, touch}; }

  TissueModel tissue;
  Vec3Array x, velocity;
  AabbTree tree;
  SurfaceTouch touch;
};

/// What contacts have done to both surfaces together.
struct Done {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero(), momentum = Vec3::Zero();
  double whole = 0.0;  ///< [N] of all forces
};
inline Done sum_done(const Moved& first, const Moved& second) {
  Done done;
  for (const Moved* surface : {&first, &second}) {
    for (std::size_t v = 0; v < surface->x.size(); ++v) {
      const Vec3& f = surface->touch.force[v];
      done.force += f;
      done.moment += surface->x[v].cross(f);
      done.momentum += surface->touch.impulse[v] / surface->touch.inverse_mass[v];
      done.whole += f.norm();
    }
  }
  return done;
}

/// Checks what contacts pushed with against sum_energy() [J] of where the surfaces are; how many
/// components.
template <class SumEnergy>
int check_gradient(Moved& first, Moved& second, SumEnergy sum_energy) {
  constexpr double kStep = 1e-9;  // [m]
  int checked = 0;
  for (Moved* surface : {&first, &second}) {
    for (const int vertex : surface->touch.pushed_in_use()) {
      const auto v = static_cast<std::size_t>(vertex);
      for (int axis = 0; axis < 3; ++axis) {
        const double at = surface->x[v][axis];
        surface->x[v][axis] = at + kStep;
        const double more = sum_energy();
        surface->x[v][axis] = at - kStep;
        const double less = sum_energy();
        surface->x[v][axis] = at;
        CHECK((less - more) / (2.0 * kStep) ==
              doctest::Approx(surface->touch.force[v][axis]).epsilon(1e-4).scale(1e-2));
        ++checked;
      }
    }
  }
  return checked;
}

}  // namespace palpate
