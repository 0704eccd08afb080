// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/collision/private/choose_barrier.h"
#include "palpate/sim/tick/private/stop_at_scenery.h"

namespace palpate {
namespace {

/// [m] That deep a body may begin in what stops it: more than meshes round by, and next to nothing
/// to be thrown out of.
constexpr double kDeepestStart = 1e-5;

void check_body(const Scene& scene, const Scenery& scenery, int index, const std::string& where) {
  const auto count = static_cast<int>(scene.bodies.size());
  if (index < 0 || index >= count) {
    refuse(where + ".bodies", write_text("body ", index),
           write_text("some of the ", count, " bodies, counted from 0"));
  }
  if (std::ranges::count(scenery.bodies, index) > 1) {
    refuse(where + ".bodies", write_text("body ", index, " again"), "each body once");
  }
  const SoftBody& body = scene.bodies[static_cast<std::size_t>(index)];
  const std::string its = write_text("scene: bodies[", index, "].");
  if (!body.tissue.elastic.corners.empty() && body.kernel != Kernel::reference) {
    refuse(its + "kernel", "a linear solid under its response",
           "reference, or a tissue of another law, for a body that stops at scenery: contacts with "
           "it are not solved with a precomputed response");
  }
  if (body.force_error > 0.0) {
    refuse(its + "force_error [N]", write_text(body.force_error),
           "0 for a body that stops at scenery: how wrong sleep makes a force is known of balls");
  }
}

void check_start(const TissueModel& tissue, const Scenery& scenery, int index,
                 const std::string& where) {
  const Nearest deepest = find_deepest_at_rest(tissue, scenery.mesh);
  if (!(deepest.gap < -kDeepestStart)) return;
  const double depth = -1e3 * deepest.gap;
  refuse(where,
         deepest.of_first ? write_text("vertex ", deepest.vertex, " of body ", index, " ", depth,
                                       " mm inside of the scenery")
                          : write_text("vertex ", deepest.vertex, " of the scenery ", depth,
                                       " mm inside of body ", index),
         "bodies that begin outside of what stops them: move one of them, or hold what is "
         "fastened there");
}

}  // namespace

void check_scenery(const Scene& scene) {
  for (std::size_t s = 0; s < scene.scenery.size(); ++s) {
    const Scenery& scenery = scene.scenery[s];
    const std::string where = write_text("scene: scenery[", s, "]");
    try {
      validate(scenery.mesh);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(where + ".mesh: " + error.what());
    }
    if (!(scenery.friction >= 0.0) || !std::isfinite(scenery.friction)) {
      refuse(where + ".friction [-]", write_text(scenery.friction), "0, or a positive number");
    }
    if (scene.exchange_rate > 0.0) {
      refuse("scene: exchange_rate [Hz]", write_text(scene.exchange_rate),
             "0 for a scene with scenery: between two exchanges nothing but tissue is felt");
    }
    for (const int body : scenery.bodies) {
      check_body(scene, scenery, body, where);
      check_start(scene.bodies[static_cast<std::size_t>(body)].tissue, scenery, body, where);
    }
  }
}

}  // namespace palpate
