// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/tick/scene.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "palpate/sim/dynamics/stable_step.h"
#include "palpate/sim/model/volumes.h"
#include "palpate/sim/packed/private/follow_motion.h"
#include "palpate/sim/packed/simd_targets.h"

namespace palpate {
namespace {

// a tip flicked at 3 m/s passes a wall of 2000 vertices at 8 substeps and does not at 16, and one
// of 5300 at 16 and not at 24 (tests/laws/test_contact.cpp); contact asks for them in an impact
// only
constexpr int kSubstepsInImpact = 32;
// beyond this a tick of 1 ms could not be kept by any machine this is made for
constexpr int kMostSubsteps = 10000;

[[noreturn]] void refuse(const char* field, double found, const char* expected) {
  std::ostringstream text;
  text << "scene: " << field << ": got " << found << ", expected " << expected;
  throw std::invalid_argument(text.str());
}

void require_positive(const char* field, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) refuse(field, value, "a positive number");
}

void check_target(const std::string& target) {
  const std::vector<std::string> targets = simd_targets();
  if (target.empty() || std::find(targets.begin(), targets.end(), target) != targets.end()) return;
  std::string names = "none, or one of";
  for (const std::string& name : targets) names += " " + name;
  throw std::invalid_argument("scene: simd_target: got " + target + ", expected " + names);
}

void validate(const Scene& scene) {
  palpate::validate(scene.tissue);
  if (scene.tissue.triangles.empty()) refuse("tissue.triangles", 0, "at least one to touch");
  require_positive("tool.radius [m]", scene.tool.radius);
  require_positive("tool.stiffness [N/m^3]", scene.tool.stiffness);
  require_positive("coupling.stiffness [N/m]", scene.coupling.stiffness);
  require_positive("coupling.force_max [N]", scene.coupling.force_max);
  require_positive("hold_stiffness [N/m]", scene.hold_stiffness);
  require_positive("rate [Hz]", scene.rate);
  if (!(scene.force_error >= 0.0) || !std::isfinite(scene.force_error)) {
    refuse("force_error [N]", scene.force_error, "0, or a small part of the forces to be felt");
  }
  if (scene.force_error > 0.0) {
    derive_active_rule(scene.tissue, scene.tool.radius, scene.force_error);
  }
  if (!scene.gravity.allFinite()) refuse("gravity [m/s^2]", scene.gravity.norm(), "finite numbers");
  check_target(scene.simd_target);
  if (scene.substeps < 0 || scene.substeps > kMostSubsteps) {
    refuse("substeps", scene.substeps, "0 to 10000");
  }
  if (scene.substeps_max != 0 &&
      (scene.substeps_max < scene.substeps || scene.substeps_max > kMostSubsteps)) {
    refuse("substeps_max", scene.substeps_max, "0, or from substeps to 10000");
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
void choose_kernel(Scene& scene) {
  scene.response.reset();
  const bool linear = !scene.tissue.elastic.corners.empty();
  if (scene.kernel == Kernel::response && !linear) {
    throw std::invalid_argument(
        "scene: kernel: got response, expected packed or reference for a tissue that is no linear "
        "solid");
  }
  if (!linear || scene.kernel == Kernel::reference) return;
  scene.kernel = Kernel::response;
  scene.response = std::make_shared<const Response>(build_response(scene.tissue, scene.gravity));
}

}  // namespace

/// Substeps are what stable_step() allows at rest, n = ceil(dt / stable_step). Contact may raise
/// them by a third, and to kSubstepsInImpact at least: more brings no more stability, for the
/// massless tool gives way before a contact gets as stiff as its row sum says [contact: substeps].
Scene build_scene(Scene scene) {
  static std::atomic<std::uint64_t> built{0};
  validate(scene);
  scene.identity = ++built;
  choose_kernel(scene);
  scene.rest_areas = compute_rest_areas(scene.tissue);
  const Spectrum spectrum = estimate_spectrum(scene.tissue);
  scene.spectrum_stiffness = spectrum.stiffness;
  scene.spectrum_damping = spectrum.damping;
  if (scene.substeps == 0) {
    const double needed = std::ceil(1.0 / (scene.rate * stable_step(scene.tissue)));
    if (!(needed <= kMostSubsteps)) {
      refuse("tissue", needed, "a tissue that needs at most 10000 substeps per tick");
    }
    scene.substeps = std::max(1, static_cast<int>(needed));
  }
  if (scene.substeps_max == 0) {
    scene.substeps_max =
        std::max(kSubstepsInImpact, scene.substeps + std::max(1, scene.substeps / 3));
  }
  if (scene.substeps_max < scene.substeps) {
    refuse("substeps_max", scene.substeps_max, "at least the substeps the tissue needs");
  }
  return scene;
}

}  // namespace palpate
