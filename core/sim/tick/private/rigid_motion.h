// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/tick/world.h"

namespace palpate {

/// Four triangles of each, the new vertices in the middle of its edges.
SurfaceMesh divide_triangles(const SurfaceMesh& coarse);

/// A surface about every sphere, an icosahedron divided once: what a body without a mesh has.
SurfaceMesh build_sphere_mesh(std::span<const Vec3> centres, std::span<const double> radii);

/// [m³] that a body displaces: of its mesh, which is closed.
double compute_rigid_volume(const RigidBody& body);

/// With which mass and inertia a body is moved: its own, or more where contacts would be too stiff
/// for its steps.
struct MovedMass {
  double mass = 0.0;            ///< [kg]
  Vec3 inertia = Vec3::Zero();  ///< [kg m²] about the axes of its frame
};

/// The floor under which contacts of the stiffness k [N/m], and k l² [N m] about the origin, would
/// shake it apart in steps of dt [s]: m >= 2 dt² sum k [contact: rigid].
MovedMass raise_mass(const RigidBody& body, double stiffness, double turning_stiffness,
                     double dt) noexcept;

/// What pushes a body, about its centre of mass.
struct Wrench {
  Vec3 force = Vec3::Zero();   ///< [N]
  Vec3 torque = Vec3::Zero();  ///< [N m]

  void add(const Vec3& at, const Vec3& push, const Vec3& centre) noexcept {
    force += push;
    torque += (at - centre).cross(push);
  }
};

/// Adds weight, buoyancy, and the drag of a fluid to a body of `volume` [m³].
void add_fluid(const RigidBody& body, const Fluid& fluid, const Vec3& gravity, double volume,
               const RigidState& state, Wrench& wrench) noexcept;

/// A step of dt [s].
void advance_rigid(const MovedMass& moved, const Wrench& wrench, double dt,
                   RigidState& state) noexcept;

/// [m/s] Of the point of a body that is at `at` [m].
inline Vec3 velocity_at(const RigidState& state, const Vec3& at) noexcept {
  return state.velocity + state.angular_velocity.cross(at - state.position);
}

/// [m] Where a point of its frame is.
inline Vec3 place_of(const RigidState& state, const Vec3& in_frame) noexcept {
  return state.position + state.orientation * in_frame;
}

/// [J] Of what moves.
double compute_kinetic_energy(const MovedMass& moved, const RigidState& state) noexcept;

/// [kg m²/s] About the centre of mass.
Vec3 compute_angular_momentum(const Vec3& inertia, const RigidState& state) noexcept;

}  // namespace palpate
