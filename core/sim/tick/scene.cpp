// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/scene.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/packed/private/follow_motion.h"
#include "palpate/sim/packed/simd_targets.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

// a tip flicked at 3 m/s passes a wall of 2000 vertices at 8 substeps and does not at 16, and one
// of 5300 at 16 and not at 24 (tests/laws/test_contact.cpp); contact asks for them in an impact
// only
constexpr int kSubstepsInImpact = 32;
// beyond this a tick of 1 ms could not be kept by any machine this is made for
constexpr int kMostSubsteps = 10000;

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

void check_target(const std::string& field, const std::string& target) {
  const std::vector<std::string> targets = simd_targets();
  if (target.empty() || std::find(targets.begin(), targets.end(), target) != targets.end()) return;
  std::string names = "none, or one of";
  for (const std::string& name : targets) names += " " + name;
  throw std::invalid_argument("scene: " + field + ": got " + target + ", expected " + names);
}

void validate(const Instrument& instrument, const Place& place) {
  require_positive(place("tool.radius [m]"), instrument.tool.radius);
  require_positive(place("tool.stiffness [N/m^3]"), instrument.tool.stiffness);
  require_positive(place("coupling.stiffness [N/m]"), instrument.coupling.stiffness);
  require_positive(place("coupling.force_max [N]"), instrument.coupling.force_max);
  require_positive(place("hold_stiffness [N/m]"), instrument.hold_stiffness);
}

void validate(const SoftBody& body, const Scene& scene, const Place& place) {
  try {
    palpate::validate(body.tissue);
  } catch (const std::invalid_argument& error) {
    if (scene.bodies.size() == 1) throw;
    throw std::invalid_argument("scene: " + place(error.what()));
  }
  if (body.tissue.triangles.empty()) refuse(place("tissue.triangles"), 0, "at least one to touch");
  if (!(body.force_error >= 0.0) || !std::isfinite(body.force_error)) {
    refuse(place("force_error [N]"), body.force_error,
           "0, or a small part of the forces to be felt");
  }
  if (body.force_error > 0.0) {
    derive_active_rule(body.tissue, find_largest_radius(scene), body.force_error);
  }
  check_target(place("simd_target"), body.simd_target);
  if (body.substeps < 0 || body.substeps > kMostSubsteps) {
    refuse(place("substeps"), body.substeps, "0 to 10000");
  }
  if (body.substeps_max != 0 &&
      (body.substeps_max < body.substeps || body.substeps_max > kMostSubsteps)) {
    refuse(place("substeps_max"), body.substeps_max, "0, or from substeps to 10000");
  }
}

void validate(const Scene& scene) {
  if (scene.bodies.empty()) refuse("bodies", 0, "at least one to touch");
  if (scene.instruments.empty()) refuse("instruments", 0, "at least one to touch with");
  for (std::size_t i = 0; i < scene.instruments.size(); ++i) {
    validate(scene.instruments[i], Place("instruments", i, scene.instruments.size()));
  }
  require_positive("rate [Hz]", scene.rate);
  if (!scene.gravity.allFinite()) refuse("gravity [m/s^2]", scene.gravity.norm(), "finite numbers");
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    validate(scene.bodies[b], scene, Place("bodies", b, scene.bodies.size()));
  }
}

std::vector<double> compute_rest_areas(const TissueModel& tissue) {
  std::vector<double> areas;
  areas.reserve(tissue.triangles.size());
  const Vec3Array rest = compute_surface(tissue, tissue.rest_position);
  for (const auto& [i, j, k] : tissue.triangles) {
    const Vec3 a = rest[j] - rest[i];
    const Vec3 b = rest[k] - rest[i];
    areas.push_back(0.5 * a.cross(b).norm());
  }
  return areas;
}

/// A linear solid answers from its response, unless the reference is asked for: then its masses
/// swing as those of any other tissue, and every substep costs a pass over the tetrahedra. Said in
/// the scene, so that a record tells what ran.
void choose_kernel(const Vec3& gravity, const Place& place, SoftBody& body) {
  body.response.reset();
  const bool linear = !body.tissue.elastic.corners.empty();
  if (body.kernel == Kernel::response && !linear) {
    throw std::invalid_argument(
        "scene: " + place("kernel") +
        ": got response, expected packed or reference for a tissue that is no linear solid");
  }
  if (!linear || body.kernel == Kernel::reference) return;
  body.kernel = Kernel::response;
  body.response = std::make_shared<const Response>(build_response(body.tissue, gravity));
}

/// Substeps are what stable_step() allows at rest, n = ceil(dt / stable_step). Contact may raise
/// them by a third, and to kSubstepsInImpact at least: more brings no more stability, for the
/// massless tool gives way before a contact gets as stiff as its row sum says [contact: substeps].
void choose_substeps(double rate, const Place& place, SoftBody& body) {
  if (body.substeps == 0) {
    const double needed = std::ceil(1.0 / (rate * stable_step(body.tissue)));
    if (!(needed <= kMostSubsteps)) {
      refuse(place("tissue"), needed, "a tissue that needs at most 10000 substeps per tick");
    }
    body.substeps = std::max(1, static_cast<int>(needed));
  }
  if (body.substeps_max == 0) {
    body.substeps_max = std::max(kSubstepsInImpact, body.substeps + std::max(1, body.substeps / 3));
  }
  if (body.substeps_max < body.substeps) {
    refuse(place("substeps_max"), body.substeps_max, "at least the substeps the tissue needs");
  }
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
  scene.identity = ++built;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Place place("bodies", b, scene.bodies.size());
    SoftBody& body = scene.bodies[b];
    choose_kernel(scene.gravity, place, body);
    body.rest_areas = compute_rest_areas(body.tissue);
    const Spectrum spectrum = estimate_spectrum(body.tissue);
    body.spectrum_stiffness = spectrum.stiffness;
    body.spectrum_damping = spectrum.damping;
    choose_substeps(scene.rate, place, body);
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
