// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <optional>
#include <stdexcept>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/mesh/topology.h"
#include "palpate/sim/tick/private/touch_rigid.h"
#include "palpate/sim/tick/tick.h"

namespace palpate {
namespace {

/// More spheres are another kind of scene, and cost as much.
constexpr std::size_t kMostSpheres = 64;

/// [-] By which a unit may miss 1.
constexpr double kRounding = 1e-6;

void require_positive(const std::string& where, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    refuse(where, write_text(value), "a positive number");
  }
}

void check_spheres(const RigidBody& body, const std::string& where) {
  const std::size_t count = body.sphere_centres.size();
  if (count == 0 || count > kMostSpheres || body.sphere_radii.size() != count) {
    refuse(where + ".sphere_radii",
           write_text(count, " centres and ", body.sphere_radii.size(), " radii"),
           write_text("as many of both, 1 to ", kMostSpheres));
  }
  for (std::size_t s = 0; s < count; ++s) {
    require_positive(where + write_text(".sphere_radii[", s, "] [m]"), body.sphere_radii[s]);
    if (body.sphere_centres[s].allFinite()) continue;
    refuse(where + write_text(".sphere_centres[", s, "] [m]"), "no number", "finite numbers");
  }
}

/// No body has an inertia that is more than the other two together.
void check_mass(const RigidBody& body, const std::string& where) {
  require_positive(where + ".mass [kg]", body.mass);
  for (int k = 0; k < 3; ++k) {
    const double its = body.inertia[k], others = body.inertia.sum() - its;
    require_positive(where + ".inertia [kg m^2]", its);
    if (its <= others * (1.0 + kRounding)) continue;
    refuse(where + ".inertia [kg m^2]", write_text(its, " about one axis"),
           write_text("at most ", others, ", the sum about the others"));
  }
  require_positive(where + ".stiffness [N/m^3]", body.stiffness);
  require_positive(where + ".contact_stiffness [N/m]", body.contact_stiffness);
  if (!(body.friction >= 0.0) || !std::isfinite(body.friction)) {
    refuse(where + ".friction [-]", write_text(body.friction), "0, or a positive number");
  }
  if (!body.position.allFinite()) refuse(where + ".position [m]", "no number", "finite numbers");
  const double norm = body.orientation.norm();
  if (!(std::abs(norm - 1.0) <= kRounding)) {
    refuse(where + ".orientation [-]", write_text("a norm of ", norm), "a unit quaternion");
  }
}

void check_mesh(const Scene& scene, const RigidBody& body, const std::string& where) {
  if (body.mesh.triangles.empty()) {
    if (body.sphere_radii.size() == 1 || scene.fluid.density == 0.0) return;
    refuse(where + ".mesh", "none for several spheres in a fluid",
           "a closed mesh, whose volume is what the fluid bears");
  }
  try {
    validate(body.mesh);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(where + ".mesh: " + error.what());
  }
  if (!is_closed(body.mesh.triangles)) {
    refuse(where + ".mesh", "an open one", "a closed one");
  }
  const double volume = compute_rigid_volume(body);
  if (!(volume > 0.0)) {
    refuse(where + ".mesh", write_text("a volume of ", volume, " m^3"),
           "triangles that run counter-clockwise seen from outside");
  }
}

/// The first sphere of a body that begins deep in a surface.
std::optional<std::size_t> find_deep_sphere(const RigidBody& body, const Vec3Array& x,
                                            const std::vector<Triangle>& triangles) {
  const AabbTree tree(x, triangles);
  for (std::size_t s = 0; s < body.sphere_radii.size(); ++s) {
    const Vec3 centre = body.position + body.orientation * body.sphere_centres[s];
    if (!has_room(tree, x, centre, body.sphere_radii[s])) return s;
  }
  return {};
}

/// No sphere begins deep in what it touches: it would be shot out.
void check_place(const Scene& scene, const RigidBody& body, const std::string& where) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const TissueModel& tissue = scene.bodies[b].tissue;
    const auto deep =
        find_deep_sphere(body, compute_surface(tissue, tissue.rest_position), tissue.triangles);
    if (deep)
      refuse(where, write_text("sphere ", *deep, " deep in body ", b),
             "one that begins outside: move the body");
  }
  for (std::size_t s = 0; s < scene.scenery.size(); ++s) {
    const SurfaceMesh& mesh = scene.scenery[s].mesh;
    const auto deep = find_deep_sphere(body, mesh.vertices, mesh.triangles);
    if (deep)
      refuse(where, write_text("sphere ", *deep, " deep in scenery ", s),
             "one that begins outside: move the body");
  }
}

void check_scene(const Scene& scene) {
  const auto check_fluid = [](const char* where, double value) {
    if (value >= 0.0 && std::isfinite(value)) return;
    refuse(where, write_text(value), "0, or a positive number");
  };
  check_fluid("scene: fluid.density [kg/m^3]", scene.fluid.density);
  check_fluid("scene: fluid.viscosity [Pa s]", scene.fluid.viscosity);
  if (scene.rigid.empty()) return;
  if (scene.exchange_rate > 0.0) {
    refuse("scene: exchange_rate [Hz]", write_text(scene.exchange_rate),
           "0 for a scene with rigid bodies: between two exchanges nothing but tissue is felt");
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const SoftBody& body = scene.bodies[b];
    const std::string where = write_text("scene: bodies[", b, "].");
    if (!body.tissue.elastic.corners.empty() && body.kernel != Kernel::reference) {
      refuse(where + "kernel", "a linear solid under its response",
             "reference, or a tissue of another law, beside rigid bodies: contacts with them are "
             "not solved with a precomputed response");
    }
    if (body.force_error > 0.0) {
      refuse(where + "force_error [N]", write_text(body.force_error),
             "0 beside rigid bodies: how wrong sleep makes a force is known of balls");
    }
  }
}

}  // namespace

void build_rigid(Scene& scene) {
  check_scene(scene);
  for (std::size_t r = 0; r < scene.rigid.size(); ++r) {
    RigidBody& body = scene.rigid[r];
    const std::string where = write_text("scene: rigid[", r, "]");
    check_spheres(body, where);
    check_mass(body, where);
    check_mesh(scene, body, where);
    check_place(scene, body, where);
    if (!body.mesh.triangles.empty()) continue;
    body.mesh = build_sphere_mesh(body.sphere_centres, body.sphere_radii);
  }
}

}  // namespace palpate
