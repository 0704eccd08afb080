// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/scene.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/dynamics/private/step_limit.h"
#include "palpate/sim/grasp/private/tear.h"
#include "palpate/sim/implicit/private/step_solver.h"
#include "palpate/sim/mesh/private/triangle_areas.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/packed/private/follow_motion.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/tick/private/choose_substeps.h"
#include "palpate/sim/tick/private/stop_at_scenery.h"
#include "palpate/sim/tick/private/touch_bodies.h"
#include "palpate/sim/tick/private/touch_rigid.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

// a tip flicked at 3 m/s passes a wall of 2000 vertices at 8 substeps and does not at 16, and one
// of 5300 at 16 and not at 24 (tests/laws/test_contact.cpp); contact asks for them in an impact
// only
constexpr int kSubstepsInImpact = 32;
/// [Hz] Between rarer exchanges a hand would leave any place that a local model is of.
constexpr double kSlowestExchange = 10.0;
/// [-] By which an interval may miss a whole number of ticks: rounding.
constexpr double kRounding = 1e-6;
// beyond this a tick of 1 ms could not be kept by any machine this is made for
constexpr int kMostSubsteps = 10000;

/// [m] From the position of a tool: no instrument for the abdomen is longer.
constexpr double kFarthestCapsule = 0.5;

/// Where in a scene a value is: "tissue" where there is one body, else "bodies[1].tissue".
class Place {
 public:
  Place() = default;
  Place(const char* table, std::size_t index, std::size_t count)
      : prefix_(count == 1 ? "" : std::string(table) + "[" + std::to_string(index) + "].") {}
  std::string operator()(const std::string& field) const { return prefix_ + field; }

 private:
  std::string prefix_;
};

[[noreturn]] void refuse(const std::string& field, double found, const char* expected) {
  std::ostringstream text;
  text << "scene: " << field << ": got " << found << ", expected " << expected;
  throw std::invalid_argument(text.str());
}

void require_positive(const std::string& field, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) refuse(field, value, "a positive number");
}

void check_force_error(const SoftBody& body, const Scene& scene, const Place& place) {
  if (!(body.force_error >= 0.0) || !std::isfinite(body.force_error)) {
    refuse(place("force_error [N]"), body.force_error,
           "0, or a small part of the forces to be felt");
  }
  if (body.force_error == 0.0) return;
  if (body.integrator != Integrator::symplectic_euler) {
    refuse(place("force_error [N]"), body.force_error,
           "0 for an integrator other than symplectic_euler: parts of a tissue sleep in vector "
           "code only");
  }
  derive_active_rule(body.tissue, find_largest_radius(scene), body.force_error);
}

void check_target(const std::string& field, const std::string& target) {
  const std::vector<std::string> targets = simd_targets();
  if (target.empty() || std::find(targets.begin(), targets.end(), target) != targets.end()) return;
  std::string names = "none, or one of";
  for (const std::string& name : targets) names += " " + name;
  throw std::invalid_argument("scene: " + field + ": got " + target + ", expected " + names);
}

void check_capsules(const Tool& tool, const Place& place) {
  const std::vector<Capsule>& capsules = tool.capsules;
  if (capsules.size() > kMostCapsules) {
    refuse(place("tool.capsules"), static_cast<double>(capsules.size()), "at most 8");
  }
  for (const Capsule& capsule : capsules) {
    for (const Vec3& end : {capsule.from, capsule.to}) {
      if (end.allFinite() && end.norm() <= kFarthestCapsule) continue;
      refuse(place("tool.capsules [m]"), end.norm(), "ends within 0.5 m of the tool's position");
    }
  }
}

/// The hinge lies no farther than capsules may, and jaws open no wider than a right angle.
void check_jaws(const Tool& tool, const Place& place) {
  if (!tool.jaws) return;
  constexpr double kWidest = 0.5 * std::numbers::pi;
  const Jaws& jaws = *tool.jaws;
  if (tool.capsules.size() != 2) {
    refuse(place("tool.jaws"), static_cast<double>(tool.capsules.size()),
           "a tool of two capsules, which are its jaws");
  }
  if (!jaws.hinge.allFinite() || jaws.hinge.norm() > kFarthestCapsule) {
    refuse(place("tool.jaws.hinge [m]"), jaws.hinge.norm(), "within 0.5 m of the tool's position");
  }
  if (!(std::abs(jaws.axis.norm() - 1.0) <= kRounding)) {
    refuse(place("tool.jaws.axis"), jaws.axis.norm(), "a unit vector");
  }
  if (!(jaws.open > 0.0 && jaws.open <= kWidest)) {
    refuse(place("tool.jaws.open [rad]"), jaws.open, "more than 0, up to pi/2");
  }
  require_positive(place("tool.jaws.grip [N]"), jaws.grip);
  require_positive(place("tool.jaws.pad_area [m^2]"), jaws.pad_area);
}

void check_trocar(const Instrument& instrument, const Place& place) {
  if (!instrument.trocar) return;
  const double far = instrument.trocar->norm();
  if (!std::isfinite(far)) refuse(place("trocar [m]"), far, "a place");
  if (instrument.tool.capsules.empty()) {
    refuse(place("trocar [m]"), far, "none for a ball: it has no shaft that would go through");
  }
}

/// The near field is that of a ball, or of one capsule in a solid, as each jaw is; parts of a
/// tissue sleep around a ball.
void check_shape_in(const SoftBody& body, const Place& place, const Tool& tool) {
  if (body.force_error > 0.0) {
    refuse(place("force_error [N]"), body.force_error,
           "0 for an instrument of capsules: how wrong sleep makes a force is known of balls");
  }
  if (body.contact_modulus == 0.0) return;
  // capsules feel a wall by the hard law
  if (!body.tissue.prisms.corners.empty()) return;
  if (body.contact_facets) {
    refuse(place("contact_facets"), 1.0,
           "false for an instrument of capsules: how curved facets are is felt by balls");
  }
  if (body.tied_holds) {
    refuse(place("tied_holds"), 1.0,
           "false for an instrument of capsules: what is tied is the disc under a ball");
  }
  if (tool.capsules.size() > 1 && !tool.jaws) {
    refuse(place("contact_modulus [Pa]"), body.contact_modulus,
           "0, the hard law, for an instrument of several capsules: the near field is of one");
  }
}

void check_shapes(const Scene& scene) {
  for (const Instrument& instrument : scene.instruments) {
    if (instrument.tool.capsules.empty()) continue;
    if (scene.exchange_rate > 0.0) {
      refuse("exchange_rate [Hz]", scene.exchange_rate,
             "0 for an instrument of capsules: between two exchanges a ball is felt");
    }
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      check_shape_in(scene.bodies[b], Place("bodies", b, scene.bodies.size()), instrument.tool);
    }
  }
}

/// Of each surface of the scene, where the tool has friction at all.
void check_pair_friction(const Instrument& instrument, std::size_t surfaces, const Place& place) {
  const std::vector<double>& pairs = instrument.pair_friction;
  if (pairs.empty()) return;
  const std::string where = place("pair_friction [-]");
  if (pairs.size() != surfaces) {
    palpate::refuse("scene: " + where, write_text(pairs.size(), " numbers"),
                    write_text(surfaces, ", one per body, scenery and rigid body, or none"));
  }
  for (const double mu : pairs) {
    if (!(mu >= 0.0) || !std::isfinite(mu)) refuse(where, mu, "0, or positive numbers");
    if (mu > 0.0 && instrument.tool.friction == 0.0) {
      refuse(where, mu, "0 for all with a tool.friction of 0: such a tool slides on everything");
    }
  }
}

void validate(const Instrument& instrument, std::size_t surfaces, const Place& place) {
  require_positive(place("tool.radius [m]"), instrument.tool.radius);
  require_positive(place("tool.stiffness [N/m^3]"), instrument.tool.stiffness);
  if (!(instrument.tool.friction >= 0.0) || !std::isfinite(instrument.tool.friction)) {
    refuse(place("tool.friction [-]"), instrument.tool.friction, "0, or a positive number");
  }
  check_pair_friction(instrument, surfaces, place);
  check_capsules(instrument.tool, place);
  check_jaws(instrument.tool, place);
  require_positive(place("coupling.stiffness [N/m]"), instrument.coupling.stiffness);
  require_positive(place("coupling.force_max [N]"), instrument.coupling.force_max);
  require_positive(place("hold_stiffness [N/m]"), instrument.hold_stiffness);
  check_trocar(instrument, place);
}

void check_far_compliance(const SoftBody& body, const Place& place) {
  const std::vector<Symmetric>& far = body.far_compliance;
  if (far.empty()) return;
  const std::string where = "scene: " + place("far_compliance");
  const auto vertices = static_cast<std::size_t>(surface_count(body.tissue));
  if (far.size() != vertices) {
    palpate::refuse(where, write_text(far.size(), " tensors"),
                    write_text(vertices, ", one per vertex of the surface"));
  }
  if (body.contact_modulus == 0.0) {
    palpate::refuse(where, "one without a contact_modulus", "none: the hard law has no use for it");
  }
  for (const Symmetric& tensor : far) {
    for (const double number : tensor) {
      if (!std::isfinite(number)) refuse(place("far_compliance"), number, "finite numbers [m/N]");
    }
  }
}

void validate(const SoftBody& body, const Scene& scene, const Place& place) {
  try {
    palpate::validate(body.tissue);
  } catch (const std::invalid_argument& error) {
    if (scene.bodies.size() == 1) throw;
    throw std::invalid_argument("scene: " + place(error.what()));
  }
  if (body.tissue.triangles.empty()) refuse(place("tissue.triangles"), 0, "at least one to touch");
  if (!(body.contact_modulus >= 0.0) || !std::isfinite(body.contact_modulus)) {
    refuse(place("contact_modulus [Pa]"), body.contact_modulus,
           "0 for the hard law, or E / (1 - nu^2) of the tissue");
  }
  check_far_compliance(body, place);
  if (body.contact_facets && body.contact_modulus == 0.0) {
    palpate::refuse("scene: " + place("contact_facets"), "true without a contact_modulus",
                    "false: the hard law has no use for them");
  }
  if (body.tied_holds && body.contact_modulus == 0.0) {
    palpate::refuse("scene: " + place("tied_holds"), "true without a contact_modulus",
                    "false: under the hard law holds are fastened to vertices");
  }
  check_tear(body.tissue, body.tear_stretch, "scene: " + place("tear_stretch"));
  check_integrator("scene: " + place(""), body.tissue, body.integrator, body.iterations);
  check_force_error(body, scene, place);
  check_target(place("simd_target"), body.simd_target);
  if (body.substeps < 0 || body.substeps > kMostSubsteps) {
    refuse(place("substeps"), body.substeps, "0 to 10000");
  }
  if (body.substeps_max != 0 &&
      (body.substeps_max < body.substeps || body.substeps_max > kMostSubsteps)) {
    refuse(place("substeps_max"), body.substeps_max, "0, or from substeps to 10000");
  }
}

/// Exchanges come every whole number of ticks, and no slower than the hand can be followed.
void check_exchange_rate(const Scene& scene) {
  const double rate = scene.exchange_rate, ticks = scene.rate / rate;
  if (rate == 0.0) return;
  if (!(rate >= kSlowestExchange && rate <= scene.rate)) {
    palpate::refuse(
        "scene: exchange_rate [Hz]", write_text(rate),
        write_text("0 for none, or ", kSlowestExchange, " to the rate of ", scene.rate, " Hz"));
  }
  if (std::abs(ticks - std::round(ticks)) <= kRounding * ticks) return;
  palpate::refuse(
      "scene: exchange_rate [Hz]", write_text(rate),
      write_text("one that goes into the rate of ", scene.rate, " Hz a whole number of times, as ",
                 scene.rate / std::ceil(ticks), " or ", scene.rate / std::floor(ticks)));
}

void validate(const Scene& scene) {
  if (scene.bodies.empty()) refuse("bodies", 0, "at least one to touch");
  if (scene.instruments.empty()) refuse("instruments", 0, "at least one to touch with");
  const std::size_t surfaces = scene.bodies.size() + scene.scenery.size() + scene.rigid.size();
  for (std::size_t i = 0; i < scene.instruments.size(); ++i) {
    validate(scene.instruments[i], surfaces, Place("instruments", i, scene.instruments.size()));
  }
  check_shapes(scene);
  require_positive("rate [Hz]", scene.rate);
  check_exchange_rate(scene);
  if (!scene.gravity.allFinite()) refuse("gravity [m/s^2]", scene.gravity.norm(), "finite numbers");
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    validate(scene.bodies[b], scene, Place("bodies", b, scene.bodies.size()));
  }
}

/// A linear solid answers from its response, unless the reference is asked for: then its masses
/// swing as those of any other tissue, and every substep costs a pass over the tetrahedra. Vector
/// code has symplectic Euler alone. Said in the scene, so that a record tells what ran.
void choose_kernel(const Vec3& gravity, const Place& place, SoftBody& body) {
  body.response.reset();
  const bool linear = !body.tissue.elastic.corners.empty();
  if (body.kernel == Kernel::response && !linear) {
    palpate::refuse("scene: " + place("kernel"), "response",
                    "automatic, packed or reference for a tissue that is no linear solid");
  }
  if (body.integrator != Integrator::symplectic_euler) {
    if (body.kernel == Kernel::packed || body.kernel == Kernel::response) {
      const std::string chosen = body.kernel == Kernel::packed ? "packed" : "response";
      palpate::refuse(
          "scene: " + place("kernel"), chosen,
          write_text("automatic or reference with the integrator ",
                     integrator_name(body.integrator), ": the others step by symplectic_euler"));
    }
    body.kernel = Kernel::reference;
  }
  if (!linear && !has_packed_form(body.tissue)) {
    if (body.kernel == Kernel::packed) {
      palpate::refuse("scene: " + place("kernel"), "packed",
                      "automatic or reference for a corotated or neo-Hookean solid, which vector "
                      "code does not step");
    }
    body.kernel = Kernel::reference;
  }
  if (body.kernel == Kernel::automatic) body.kernel = Kernel::packed;
  if (!linear || body.kernel == Kernel::reference) return;
  body.kernel = Kernel::response;
  body.response = std::make_shared<const Response>(build_response(body.tissue, gravity));
}

/// What the integrator can be stable by: the spectrum at rest, and damping where it needs that.
void fill_spectrum(SoftBody& body) {
  const Spectrum spectrum = estimate_spectrum(body.tissue);
  body.spectrum_stiffness = spectrum.stiffness;
  body.spectrum_damping = spectrum.damping;
  body.least_damping_time =
      uses_damping(body.integrator) ? estimate_least_damping_time(body.tissue) : 0.0;
  const bool damped = body.integrator == Integrator::symplectic_euler_implicit_damping;
  body.damped_limit = damped ? find_damped_limit(body.tissue) : 0.0;
}

/// Substeps are what stable_step() allows at rest, n = ceil(dt / stable_step). Contact may raise
/// them by a third, and to kSubstepsInImpact at least: more brings no more stability, for the
/// massless tool gives way before a contact gets as stiff as its row sum says [contact: substeps].
/// A scene's own are held to the same, but for XPBD, which is stable in any.
void choose_substeps(double rate, const Place& place, SoftBody& body) {
  const bool chooses = body.substeps == 0;
  if (chooses || needs_damping(body.integrator)) {
    const double needed = std::ceil(count_needed_substeps(rate, body));
    if (!(needed <= kMostSubsteps) && needs_damping(body.integrator)) {
      palpate::refuse("scene: " + place("integrator"),
                      std::string(integrator_name(body.integrator)),
                      write_text("one that is stable where next to nothing is damped, as "
                                 "symplectic_euler: this needs ",
                                 needed, " substeps per tick, of 10000"));
    }
    if (!(needed <= kMostSubsteps)) {
      palpate::refuse("scene: " + place("tissue"), write_text("one of ", needed, " substeps"),
                      write_text("one of at most 10000 substeps per tick, as this with ",
                                 find_fitting_part(rate, body, double(kMostSubsteps)),
                                 " of all its stiffness and damping"));
    }
    if (chooses) body.substeps = std::max(1, static_cast<int>(needed));
  }
  if (!chooses && body.integrator != Integrator::xpbd) {
    require_enough_substeps("scene: " + place("substeps"), rate, body);
  }
  if (body.substeps_max == 0) {
    body.substeps_max = std::max(kSubstepsInImpact, body.substeps + std::max(1, body.substeps / 3));
  }
  if (body.substeps_max < body.substeps) {
    palpate::refuse("scene: " + place("substeps_max"), write_text(body.substeps_max),
                    write_text("at least the ", body.substeps, " substeps that the tissue needs"));
  }
}

void build_contact(double radius, SoftBody& body) {
  body.near_field.reset();
  if (body.contact_modulus == 0.0) return;
  NearField near = build_near_field(body.tissue, body.contact_modulus, radius, body.far_compliance,
                                    body.contact_facets);
  near.ties_holds = body.tied_holds;
  body.near_field = std::make_shared<const NearField>(std::move(near));
}

/// [m] Half of what an instrument may press at once.
double find_largest_reach(const Scene& scene) noexcept {
  double most = 0.0;
  for (const Instrument& instrument : scene.instruments) {
    most = std::max(most, instrument.tool.radius);
    for (const Capsule& capsule : instrument.tool.capsules) {
      const double half = 0.5 * (capsule.to - capsule.from).norm();
      most = std::max(most, instrument.tool.radius + half);
    }
  }
  return most;
}

}  // namespace

Scene make_scene(TissueModel tissue) {
  Scene scene;
  scene.bodies[0].tissue = std::move(tissue);
  return scene;
}

Scene build_scene(Scene scene) {
  static std::atomic<std::uint64_t> built{0};
  validate(scene);
  build_body_pairs(scene);
  check_scenery(scene);
  build_rigid(scene);
  scene.identity = ++built;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Place place("bodies", b, scene.bodies.size());
    SoftBody& body = scene.bodies[b];
    choose_kernel(find_gravity(scene, body), place, body);
    if (body.iterations == 0) body.iterations = usual_iterations(body.integrator);
    body.rest_areas = compute_triangle_areas(
        compute_surface(body.tissue, body.tissue.rest_position), body.tissue.triangles);
    fill_spectrum(body);
    choose_substeps(scene.rate, place, body);
    build_contact(find_largest_reach(scene), body);
  }
  return scene;
}

double find_smallest_radius(const Scene& scene) noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (const Instrument& instrument : scene.instruments) {
    least = std::min(least, instrument.tool.radius);
  }
  return least;
}

double find_largest_radius(const Scene& scene) noexcept {
  double most = 0.0;
  for (const Instrument& instrument : scene.instruments) {
    most = std::max(most, instrument.tool.radius);
  }
  return most;
}

}  // namespace palpate
