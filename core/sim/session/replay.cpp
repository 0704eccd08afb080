// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "palpate/sim/loop/private/exchange_tree.h"
#include "palpate/sim/session/record.h"

namespace palpate {
namespace {

void validate(const Record& record) {
  const auto refuse = [](const std::string& text) {
    throw std::invalid_argument("replay: " + text);
  };
  if (record.felt.size() != record.hand.size()) {
    refuse("got " + std::to_string(record.hand.size()) + " hand samples and " +
           std::to_string(record.felt.size()) + " felt ones, expected as many of both");
  }
  for (const Event& event : record.events) {
    if (event.kind != EventKind::record_gap) continue;
    refuse("got a record that lost " + std::to_string(event.index) + " ticks before tick " +
           std::to_string(event.tick) + ", expected one without gaps");
  }
  for (std::size_t i = 0; i < record.hand.size(); ++i) {
    if (!record.hand[i].position.allFinite()) {
      refuse("got a hand position that is not finite at tick " + std::to_string(i));
    }
  }
}

bool same_bits(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return std::memcmp(a.data(), b.data(), 3 * sizeof(float)) == 0;
}

/// [N] or [m]; what cannot be subtracted is infinitely far apart.
double distance(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  const double d = (a - b).cast<double>().norm();
  return std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
}

}  // namespace

/// Records made before forces faded after an alarm have zeros there.
bool same_after_alarm(const World& world, const Felt& felt, const Felt& then) {
  return world.alarm && then.force.isZero(0.0f) && same_bits(felt.position, then.position) &&
         felt.touched == then.touched;
}

/// The trees of the recorded run, each built over the same positions and taken up before the same
/// tick. Answers do not depend on them; how long they take does.
class RecordedTrees {
 public:
  /// Throws std::invalid_argument for exchanges that no run has: one tree is built at a time.
  explicit RecordedTrees(const Record& record) {
    std::int64_t last = 0;
    for (const Event& event : record.events) {
      if (event.kind != EventKind::tree_exchanged) continue;
      if (event.index < 0 || event.index > event.tick - last) {
        throw std::invalid_argument(
            "replay: got at tick " + std::to_string(event.tick) + " a tree built " +
            std::to_string(event.index) + " ticks before, expected 0 to " +
            std::to_string(event.tick - last) + ", after the exchange before it");
      }
      exchanges_.push_back(event);
      last = event.tick;
    }
  }

  /// Between two ticks.
  void follow(World& world) {
    for (; next_ < exchanges_.size(); ++next_) {
      const Event& exchange = exchanges_[next_];
      if (exchange.tick - exchange.index == world.tick_count) {
        built_ = build_over(surface_position(world.bodies[0]), world.bodies[0].tree.triangles());
      }
      if (exchange.tick != world.tick_count) return;
      exchange_tree(built_, world.bodies[0]);
    }
  }

 private:
  std::vector<Event> exchanges_;  // one after the other
  std::size_t next_ = 0;
  BuiltTree built_;
};

ReplayReport replay(const Scene& scene, const Record& record) {
  if (scene.instruments.size() != 1) {
    throw std::invalid_argument("replay: got a scene of " +
                                std::to_string(scene.instruments.size()) +
                                " instruments, expected one, as a record has one hand");
  }
  validate(record);
  ReplayReport report;
  report.ticks = static_cast<long>(record.hand.size());
  report.felt.reserve(record.hand.size());
  const auto differs_at = [&](std::size_t tick) {
    if (report.first_difference < 0) report.first_difference = static_cast<long>(tick);
  };

  std::vector<StateHash> hashes = record.hashes;
  std::sort(hashes.begin(), hashes.end(),
            [](const StateHash& a, const StateHash& b) { return a.tick < b.tick; });
  auto next = hashes.begin();

  World world(scene);
  RecordedTrees trees(record);
  for (std::size_t i = 0; i < record.hand.size(); ++i) {
    trees.follow(world);
    const HapticCommand command = tick(scene, record.hand[i], 1.0 / scene.rate, world);
    Felt felt = compute_felt(command, world);
    const Felt& then = record.felt[i];
    felt.lateness_us = then.lateness_us;
    felt.touched |= then.touched & kNotRendered;  // of the device, not of the tick
    report.felt.push_back(felt);
    const bool same = same_bits(felt.force, then.force) &&
                      same_bits(felt.position, then.position) && felt.touched == then.touched;
    if (!same && !same_after_alarm(world, felt, then)) {
      differs_at(i);
      report.largest_force_difference =
          std::max(report.largest_force_difference, distance(felt.force, then.force));
      report.largest_position_difference =
          std::max(report.largest_position_difference, distance(felt.position, then.position));
    }
    for (; next != hashes.end() && next->tick <= static_cast<std::int64_t>(i); ++next) {
      if (next->hash != compute_hash(world)) differs_at(i);
    }
  }
  report.equal = report.first_difference < 0;
  return report;
}

}  // namespace palpate
