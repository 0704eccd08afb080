// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "palpate/sim/device/device.h"
#include "palpate/sim/dynamics/guard.h"
#include "palpate/sim/tick/scene.h"

namespace palpate {

// What a tick costs, part by part. The parts do not sum to the whole: choosing substeps, and the
// clock itself, are of no part.

/// [s] of one tick.
struct BodyCost {
  double follow = 0.0;  ///< its tree brought to where its surface is
  double step = 0.0;    ///< all its substeps
  double guard = 0.0;   ///< checked, and brought up to date
  double total() const noexcept { return follow + step + guard; }
};

/// [s] of one tick.
struct InstrumentCost {
  double read = 0.0;     ///< hand and button
  double balance = 0.0;  ///< in the air, all substeps
  double total() const noexcept { return read + balance; }
};

/// [s] of one tick. Where a tool may touch several bodies at once it is balanced among all of them,
/// and the time for that is shared out by their candidates. Of two bodies, of a body and scenery,
/// and of rigid bodies: their lists and what they ask of the steps, and their contacts.
struct PairCost {
  double candidates = 0.0;  ///< found in the body's tree
  double contact = 0.0;     ///< the tool balanced against the body, all substeps
  double total() const noexcept { return candidates + contact; }
};

/// What the last tick cost, in the order of the parts of its World; zeros unless it measures.
struct TickCosts {
  std::vector<BodyCost> bodies;
  std::vector<InstrumentCost> instruments;
  std::vector<PairCost> pairs;
  std::vector<PairCost> body_pairs;  ///< bodies with each other, as Scene::body_pairs
  std::vector<PairCost> scenery;     ///< bodies that it stops, as World::scenery_contacts
  PairCost rigid;                    ///< all rigid bodies with what they touch, and their motion
  double tick = 0.0;                 ///< [s] the whole
};

/// Right within 0.4 %, the largest exactly.
struct Percentiles {
  double median = 0.0, p99 = 0.0, p99_9 = 0.0, max = 0.0;  ///< [s]
};

/// What the ticks of a run cost.
struct SceneCosts {
  long ticks = 0;
  Percentiles tick;                      ///< the whole
  std::vector<Percentiles> bodies;       ///< all stages of each, as Scene::bodies
  std::vector<Percentiles> instruments;  ///< as Scene::instruments
  std::vector<Percentiles> pairs;        ///< every instrument with every body
  std::vector<Percentiles> body_pairs;   ///< bodies with each other, as Scene::body_pairs
  std::vector<Percentiles> scenery;      ///< bodies that it stops, as World::scenery_contacts
  Percentiles rigid;                     ///< all rigid bodies; zeros without any
  Alarm alarm;                           ///< that ended the run early
};

/// Runs a scene as fast as the machine can, in the calling thread, from rest through `samples`:
/// for every tick one of each instrument. An alarm ends it. Throws std::invalid_argument for a
/// scene that is not from build_scene and for samples that are not some of each instrument.
SceneCosts measure_costs(const Scene& scene, std::span<const HapticSample> samples);

}  // namespace palpate
