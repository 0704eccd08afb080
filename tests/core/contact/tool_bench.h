// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/sim/contact/contact_law.h"
#include "scenes/scenes.h"

namespace palpate {

inline double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}

/// A surface that holds still, and a tool on the spring of a hand.
struct Bench {
  explicit Bench(SurfaceMesh surface, Tool t = {})
      : mesh(std::move(surface)),
        tree(mesh.vertices, mesh.triangles),
        tool(t),
        candidates(static_cast<int>(mesh.triangles.size())),
        state(static_cast<int>(mesh.triangles.size()), static_cast<int>(mesh.triangles.size())),
        load(2 * static_cast<int>(mesh.triangles.size())) {
    for (const Triangle& t3 : mesh.triangles) {
      areas.push_back(triangle_area(corner(t3, 0), corner(t3, 1), corner(t3, 2)));
    }
  }
  const Vec3& corner(const Triangle& t, std::size_t c) const {
    return mesh.vertices[static_cast<std::size_t>(t[c])];
  }

  /// Ticks with the hand at h, of one substep each.
  Vec3 move_hand(const Vec3& h, int ticks = 1) {
    Vec3 felt = Vec3::Zero();
    for (int i = 0; i < ticks; ++i) {
      find_candidates(tree, mesh.vertices, tool, state.placed ? state.position : h, h, areas,
                      candidates);
      felt = balance(h);
    }
    return felt;
  }
  Vec3 balance(const Vec3& h) {
    return balance_tool(tool, coupling, h, candidates, mesh.triangles, mesh.vertices, state, load);
  }
  /// [N] on the particles, and its moment about the origin [N·m].
  Vec3 force_on_particles(Vec3* torque = nullptr) const {
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (const Push& push : load.pushes()) {
      const Triangle& t = mesh.triangles[static_cast<std::size_t>(push.triangle)];
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec3 share = push.weights[static_cast<Eigen::Index>(c)] * push.force;
        force += share;
        moment += corner(t, c).cross(share);
      }
    }
    if (torque) *torque = moment;
    return force;
  }

  SurfaceMesh mesh;
  AabbTree tree;
  std::vector<double> areas;
  Tool tool;
  Coupling coupling;
  Candidates candidates;
  ToolState state;
  Load load;
};

inline SurfaceMesh make_ball(int subdivisions = 3) {
  return scenes::make_ellipsoid(Vec3::Constant(0.025), subdivisions);
}

}  // namespace palpate
