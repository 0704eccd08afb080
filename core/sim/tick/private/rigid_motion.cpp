// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/private/rigid_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace palpate {
namespace {

/// [-] Of a sphere in turbulent flow.
constexpr double kDragCoefficient = 0.44;

/// Rounds of the midpoint rule: each leaves a dt² of what the one before it did.
constexpr int kMidpointRounds = 3;

/// [rad] As a rotation vector.
Quaternion exponential(const Vec3& turn) noexcept {
  const double angle = turn.norm();
  if (!(angle > 0.0)) return Quaternion::Identity();
  const Vec3 part = std::sin(0.5 * angle) / angle * turn;
  return Quaternion(std::cos(0.5 * angle), part.x(), part.y(), part.z());
}

Vec3 turn_back(const Quaternion& orientation, const Vec3& inertia, const Vec3& momentum) noexcept {
  return orientation * (orientation.conjugate() * momentum).cwiseQuotient(inertia);
}

/// [m] Of a sphere of that volume.
double find_equivalent_radius(double volume) noexcept {
  return std::cbrt(0.75 * volume / std::numbers::pi);
}

void add_icosahedron(SurfaceMesh& mesh) {
  const double g = std::numbers::phi;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
}

}  // namespace

SurfaceMesh divide_triangles(const SurfaceMesh& coarse) {
  SurfaceMesh mesh;
  mesh.vertices = coarse.vertices;
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [found, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
    if (is_new) {
      mesh.vertices.push_back(0.5 * (mesh.vertices[static_cast<std::size_t>(a)] +
                                     mesh.vertices[static_cast<std::size_t>(b)]));
    }
    return found->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const Triangle& t :
         {Triangle{a, ab, ca}, Triangle{b, bc, ab}, Triangle{c, ca, bc}, Triangle{ab, bc, ca}}) {
      mesh.triangles.push_back(t);
    }
  }
  return mesh;
}

SurfaceMesh build_sphere_mesh(std::span<const Vec3> centres, std::span<const double> radii) {
  SurfaceMesh ball;
  add_icosahedron(ball);
  ball = divide_triangles(ball);
  for (Vec3& v : ball.vertices) v.normalize();
  SurfaceMesh mesh;
  for (std::size_t s = 0; s < centres.size(); ++s) {
    const auto first = static_cast<int>(mesh.vertices.size());
    for (const Vec3& v : ball.vertices) mesh.vertices.push_back(centres[s] + radii[s] * v);
    for (const auto& [a, b, c] : ball.triangles) {
      mesh.triangles.push_back({first + a, first + b, first + c});
    }
  }
  return mesh;
}

double compute_rigid_volume(const RigidBody& body) {
  double volume = 0.0;
  const Vec3Array& x = body.mesh.vertices;
  for (const auto& [i, j, k] : body.mesh.triangles) {
    volume += x[static_cast<std::size_t>(i)].dot(
                  x[static_cast<std::size_t>(j)].cross(x[static_cast<std::size_t>(k)])) /
              6.0;
  }
  return volume;
}

/// Symplectic Euler bears dt² k/m <= 4; with every contact there may be at once, and both of its
/// ends in motion, half of that is left, and half again for friction beside the pressure.
MovedMass raise_mass(const RigidBody& body, double stiffness, double turning_stiffness,
                     double dt) noexcept {
  MovedMass moved{std::max(body.mass, 2.0 * dt * dt * stiffness), body.inertia};
  moved.inertia = moved.inertia.cwiseMax(Vec3::Constant(2.0 * dt * dt * turning_stiffness));
  return moved;
}

/// Stokes' drag 6 pi mu r v and 8 pi mu r³ w, and 1/2 rho C A v² beyond it, of a sphere of the same
/// volume.
void add_fluid(const RigidBody& body, const Fluid& fluid, const Vec3& gravity, double volume,
               const RigidState& state, Wrench& wrench) noexcept {
  wrench.force += (body.mass - fluid.density * volume) * gravity;
  if (fluid.density == 0.0 && fluid.viscosity == 0.0) return;
  const double r = find_equivalent_radius(volume), r2 = r * r;
  const double linear = 6.0 * std::numbers::pi * fluid.viscosity * r;
  const double quadratic = 0.5 * fluid.density * kDragCoefficient * std::numbers::pi * r2;
  wrench.force -= (linear + quadratic * state.velocity.norm()) * state.velocity;
  wrench.torque -= 8.0 * std::numbers::pi * fluid.viscosity * r2 * r * state.angular_velocity;
}

/// Symplectic Euler; what turns keeps its angular momentum L:
///
///     v += dt f/m,  x += dt v;   L += dt t,  w = R I^-1 R^T L at the middle of the step,
///     q <- exp(w dt) q
///
/// the rotation exact for that w, so that q stays a unit, and the middle found in some rounds.
void advance_rigid(const MovedMass& moved, const Wrench& wrench, double dt,
                   RigidState& state) noexcept {
  state.velocity += dt / moved.mass * wrench.force;
  state.position += dt * state.velocity;
  const Vec3 momentum = compute_angular_momentum(moved.inertia, state) + dt * wrench.torque;
  const Quaternion before = state.orientation;
  Vec3 w = turn_back(before, moved.inertia, momentum);
  for (int round = 0; round < kMidpointRounds; ++round) {
    w = turn_back(exponential(0.5 * dt * w) * before, moved.inertia, momentum);
  }
  state.orientation = (exponential(dt * w) * before).normalized();
  state.angular_velocity = turn_back(state.orientation, moved.inertia, momentum);
}

double compute_kinetic_energy(const MovedMass& moved, const RigidState& state) noexcept {
  const Vec3 momentum = compute_angular_momentum(moved.inertia, state);
  return 0.5 * moved.mass * state.velocity.squaredNorm() +
         0.5 * state.angular_velocity.dot(momentum);
}

Vec3 compute_angular_momentum(const Vec3& inertia, const RigidState& state) noexcept {
  const Vec3 in_frame = state.orientation.conjugate() * state.angular_velocity;
  return state.orientation * in_frame.cwiseProduct(inertia);
}

}  // namespace palpate
