// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/loop/private/pending_snapshot.h"

#include <algorithm>
#include <utility>

#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/packed/private/packed.h"
#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {
namespace {

/// [-] Of the vertices of a skin, as they follow the particles.
std::vector<float> carry_by_skin(const Skin& skin, std::span<const float> particles) {
  std::vector<float> vertices;
  vertices.reserve(skin.corners.size());
  for (std::size_t v = 0; v < skin.corners.size(); ++v) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      sum += skin.weights[v][k] * particles[static_cast<std::size_t>(skin.corners[v][k])];
    }
    vertices.push_back(static_cast<float>(std::clamp(sum, 0.0, 1.0)));
  }
  return vertices;
}

}  // namespace

PendingSnapshot::PendingSnapshot(const World& world, const TaskState& task)
    : packed(world.bodies.size()) {
  seen.task = task;
  seen.instruments.resize(world.instruments.size());
  for (const RigidState& body : world.rigid) {
    seen.rigid.push_back({body.position, body.orientation});
  }
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    const SoftState& body = world.bodies[b];
    if (const PackedKernel* kernel = find_packed(body)) {
      packed[b].displacement.resize(kernel->state.displacement.size());
    }
    const std::span<const Vec3> surface = surface_position(body);
    seen.bodies.push_back({{surface.begin(), surface.end()}, body.substeps, body.safeguard, {}});
    if (internals(body).tear.may_tear()) seen.bodies[b].torn.resize(body.tissue.position.size());
  }
}

void note_world(const World& world, std::span<const HapticSample> samples,
                PendingSnapshot& pending) noexcept {
  pending.seen.tick = world.tick_count - 1;
  pending.seen.time = samples[0].time;
  for (std::size_t i = 0; i < world.instruments.size(); ++i) {
    const ToolState& tool = world.instruments[i].tool;
    InstrumentSnapshot& seen = pending.seen.instruments[i];
    seen.sample = samples[i];
    seen.tool_position = tool.position;
    seen.tool_orientation = tool.orientation;
    seen.touching = tool.touching;
    seen.jaw_angle = tool.jaw_angle;
    seen.pinch = tool.pinch;
    seen.pad_pressure = tool.pad_pressure;
    seen.carried = tool.carried;
    seen.turn_limited = tool.turn_limited;
  }
  for (std::size_t r = 0; r < world.rigid.size(); ++r) {
    pending.seen.rigid[r] = {world.rigid[r].position, world.rigid[r].orientation};
  }
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    const SoftState& body = world.bodies[b];
    pending.seen.bodies[b].substeps = body.substeps;
    pending.seen.bodies[b].safeguard = body.safeguard;
    const Tear& tear = internals(body).tear;
    if (tear.has_torn()) tear.write_damage(pending.seen.bodies[b].torn);
    // after an alarm the packed tissue is not where the world stands still
    pending.packed[b].in_use = lags(world, body) && is_behind(body);
    if (pending.packed[b].in_use) {
      std::ranges::copy(find_packed(body)->state.displacement,
                        pending.packed[b].displacement.begin());
    } else {
      std::ranges::copy(surface_position(body), pending.seen.bodies[b].position.begin());
    }
  }
}

SnapshotReader::Unpacked::Unpacked(const SoftState& body)
    : model(find_packed(body) ? find_packed(body)->model : nullptr),
      slices(model ? model->slice_count : 0),
      particles(body.skin.empty() ? 0 : body.tissue.position.size()) {}

SnapshotReader::SnapshotReader(const World& world)
    : unpacked_(world.bodies.begin(), world.bodies.end()), snapshot_(PendingSnapshot(world).seen) {
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    std::vector<float>& torn = snapshot_.bodies[b].torn;
    if (!torn.empty()) torn.resize(snapshot_.bodies[b].position.size());
  }
}

void SnapshotReader::read(const Scene& scene, const PendingSnapshot& pending) {
  std::vector<BodySnapshot> bodies = std::move(snapshot_.bodies);
  snapshot_ = pending.seen;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const TissueModel& tissue = scene.bodies[b].tissue;
    std::vector<float>& torn = snapshot_.bodies[b].torn;
    if (!torn.empty() && !tissue.skin.corners.empty()) torn = carry_by_skin(tissue.skin, torn);
    if (!pending.packed[b].in_use) continue;
    Unpacked& unpacked = unpacked_[b];
    Vec3Array& to = unpacked.particles.empty() ? bodies[b].position : unpacked.particles;
    unpack_positions(*unpacked.model, tissue, pending.packed[b].displacement,
                     unpacked.slices.span(), to);
    if (!unpacked.particles.empty()) move_skin(tissue.skin, unpacked.particles, bodies[b].position);
    std::swap(snapshot_.bodies[b].position, bodies[b].position);
  }
}

}  // namespace palpate
