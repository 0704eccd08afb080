// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "palpate/sim/loop/private/exchange_tree.h"
#include "palpate/sim/session/private/slow_replay.h"
#include "palpate/sim/session/record.h"

namespace palpate {
namespace {

void validate(const Scene& scene, const Record& record) {
  count_ticks(record);
  const auto refuse = [](const std::string& text) {
    throw std::invalid_argument("replay: " + text);
  };
  if (scene.instruments.size() != static_cast<std::size_t>(record.instruments)) {
    refuse("got a scene of " + std::to_string(scene.instruments.size()) +
           " instruments, expected " + std::to_string(record.instruments) +
           ", as many as the record has hands");
  }
  for (const Event& event : record.events) {
    if (event.kind != EventKind::record_gap) continue;
    refuse("got a record that lost " + std::to_string(event.index) + " ticks before tick " +
           std::to_string(event.tick) + ", expected one without gaps");
  }
  for (std::size_t i = 0; i < record.hand.size(); ++i) {
    if (!record.hand[i].position.allFinite()) {
      refuse("got a hand position that is not finite at tick " +
             std::to_string(i / static_cast<std::size_t>(record.instruments)));
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

/// Records made before forces faded after an alarm have zeros there.
bool same_after_alarm(const World& world, const Felt& felt, const Felt& then) {
  return world.alarm && then.force.isZero(0.0f) && same_bits(felt.position, then.position) &&
         felt.touched == then.touched;
}

bool is_exchange(const Event& event) { return event.kind == EventKind::tree_exchanged; }

/// The trees of a body in the recorded run, each built over the same positions and taken up before
/// the same tick. Answers do not depend on them; how long they take does.
class RecordedTrees {
 public:
  /// Throws std::invalid_argument for exchanges that no run has: of a body, one tree is built at a
  /// time.
  RecordedTrees(const Record& record, std::size_t body) : body_(body) {
    std::int64_t last = 0;
    for (const Event& event : record.events) {
      if (!is_exchange(event) || static_cast<std::size_t>(event.source) != body_) continue;
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
      SoftState& body = world.bodies[body_];
      if (exchange.tick - exchange.index == world.tick_count) {
        built_ = build_over(surface_position(body), body.tree.triangles());
      }
      if (exchange.tick != world.tick_count) return;
      exchange_tree(built_, body);
    }
  }

 private:
  const std::size_t body_;
  std::vector<Event> exchanges_;  // one after the other
  std::size_t next_ = 0;
  BuiltTree built_;
};

/// Of each body. Throws std::invalid_argument as RecordedTrees does, and for another body's.
std::vector<RecordedTrees> list_trees(const Scene& scene, const Record& record) {
  const std::size_t count = scene.bodies.size();
  for (const Event& event : record.events) {
    if (!is_exchange(event) || (event.source >= 0 && std::size_t(event.source) < count)) continue;
    throw std::invalid_argument("replay: got at tick " + std::to_string(event.tick) +
                                " a tree of body " + std::to_string(event.source) +
                                ", expected 0 to " + std::to_string(count - 1));
  }
  std::vector<RecordedTrees> trees;
  for (std::size_t body = 0; body < count; ++body) trees.emplace_back(record, body);
  return trees;
}

/// What the devices of a run kept passive; nothing where they bore the instruments' own couplings.
void bound_couplings(const Record& record, World& world) {
  for (const Event& event : record.events) {
    if (event.kind != EventKind::coupling_limited) continue;
    const auto count = static_cast<std::int32_t>(world.instruments.size());
    const bool known = event.source >= 0 && event.source < count;
    if (event.tick != 0 || !known || !(event.value > 0.0) || !std::isfinite(event.value)) {
      throw std::invalid_argument("replay: got at tick " + std::to_string(event.tick) +
                                  " the coupling of instrument " + std::to_string(event.source) +
                                  " bounded to " + std::to_string(event.value) +
                                  " N/m, expected it at tick 0, of 0 to " +
                                  std::to_string(count - 1) + ", and a positive number");
    }
    DeviceCoupling& device = world.instruments[static_cast<std::size_t>(event.source)].device;
    device.passive_stiffness = event.value;
    device.delay = 1e-6 * std::max(0, event.index);
  }
}

/// Compares what was felt row by row with what was recorded.
class Comparison {
 public:
  explicit Comparison(ReplayReport& report) : report_(report) {}

  void differs_at(std::size_t tick) {
    if (report_.first_difference < 0) report_.first_difference = static_cast<long>(tick);
  }
  /// Of an instrument in a tick; keeps what was felt.
  void compare(const World& world, std::size_t tick, Felt felt, const Felt& then) {
    felt.lateness_us = then.lateness_us;
    felt.touched |= then.touched & kNotRendered;  // of the device, not of the tick
    report_.felt.push_back(felt);
    const bool same = same_bits(felt.force, then.force) &&
                      same_bits(felt.position, then.position) && felt.touched == then.touched;
    if (same || same_after_alarm(world, felt, then)) return;
    differs_at(tick);
    report_.largest_force_difference =
        std::max(report_.largest_force_difference, distance(felt.force, then.force));
    report_.largest_position_difference =
        std::max(report_.largest_position_difference, distance(felt.position, then.position));
  }

 private:
  ReplayReport& report_;
};

/// An end that no judge has come to, but who ran it.
bool is_end_from_outside(const Event& event) {
  return is_kind(event, TaskEvent::task_ended) &&
         (event.index == static_cast<int>(Outcome::left) ||
          event.index == static_cast<int>(Outcome::device_fault));
}

/// Records of one instrument and body have no source of an event, so that is not compared.
bool is_same(const Event& a, const Event& b) {
  return a.tick == b.tick && a.kind == b.kind && a.index == b.index &&
         std::memcmp(&a.value, &b.value, sizeof a.value) == 0;
}

/// Judges a replay again, and compares what comes of it with what was recorded.
class Rejudging {
 public:
  Rejudging(const Task& task, const Record& record, ReplayReport& report)
      : task_(task), progress_(task), report_(report) {
    for (const Event& event : record.events) {
      if (is_of_task(event) && !is_end_from_outside(event)) then_.push_back(event);
    }
  }

  void judge_tick(const World& world, std::span<const HapticSample> samples,
                  std::span<const HapticCommand> commands, double dt) {
    judge(task_, world, samples, commands, dt, progress_);
    report_.events.insert(report_.events.end(), progress_.events.begin(),
                          progress_.events.begin() + progress_.event_count);
  }

  void finish(const Record& record) {
    report_.task = progress_.state;
    if (report_.task.outcome == Outcome::running) report_.task.outcome = find_outcome(record);
    const std::vector<Event>& now = report_.events;
    const auto [a, b] = std::ranges::mismatch(now, then_, is_same);
    report_.events_equal = a == now.end() && b == then_.end();
    if (report_.events_equal) return;
    report_.first_event_difference =
        std::min(a == now.end() ? std::numeric_limits<long>::max() : long{a->tick},
                 b == then_.end() ? std::numeric_limits<long>::max() : long{b->tick});
  }

 private:
  const Task& task_;
  Progress progress_;
  std::vector<Event> then_;
  ReplayReport& report_;
};

void validate(const Task& task, std::size_t instruments) {
  if (task.tool_radii.size() == instruments) return;
  throw std::invalid_argument("replay: got a task for " + std::to_string(task.tool_radii.size()) +
                              " instruments, expected one that build_task made for the scene, " +
                              "which has " + std::to_string(instruments));
}

}  // namespace

Outcome find_outcome(const Record& record) noexcept {
  for (auto event = record.events.rbegin(); event != record.events.rend(); ++event) {
    if (!is_kind(*event, TaskEvent::task_ended)) continue;
    const bool known = event->index > static_cast<int>(Outcome::running) &&
                       event->index < static_cast<int>(Outcome::interrupted);
    return known ? static_cast<Outcome>(event->index) : Outcome::interrupted;
  }
  return Outcome::interrupted;
}

ReplayReport replay(const Scene& scene, const Record& record, const Task* task,
                    const std::function<bool()>& stopped) {
  validate(scene, record);
  if (task) validate(*task, scene.instruments.size());
  const std::size_t tick_count = count_ticks(record), instruments = scene.instruments.size();
  ReplayReport report;
  report.ticks = static_cast<long>(tick_count);
  report.instruments = record.instruments;
  report.felt.reserve(record.hand.size());
  Comparison comparison(report);

  std::vector<StateHash> hashes = record.hashes;
  std::sort(hashes.begin(), hashes.end(),
            [](const StateHash& a, const StateHash& b) { return a.tick < b.tick; });
  auto next = hashes.begin();

  World world(scene);
  bound_couplings(record, world);
  std::vector<RecordedTrees> trees = list_trees(scene, record);
  std::optional<SlowReplay> slow;
  if (scene.exchange_rate > 0.0) slow.emplace(scene, record);
  std::vector<HapticCommand> commands(instruments);
  std::optional<Rejudging> rejudging;
  if (task) rejudging.emplace(*task, record, report);
  for (std::size_t t = 0; t < tick_count; ++t) {
    if (stopped && stopped()) {
      report.ticks = static_cast<long>(t);
      comparison.differs_at(t);
      break;
    }
    const std::size_t row = t * instruments;
    const std::span hands = std::span(record.hand).subspan(row, instruments);
    if (slow) {
      slow->tick(hands, world, commands);
    } else {
      for (RecordedTrees& body : trees) body.follow(world);
      tick(scene, hands, 1.0 / scene.rate, world, commands);
    }
    if (rejudging) rejudging->judge_tick(world, hands, commands, 1.0 / scene.rate);
    for (std::size_t i = 0; i < instruments; ++i) {
      comparison.compare(world, t, compute_felt(commands[i], world, i), record.felt[row + i]);
    }
    for (; next != hashes.end() && next->tick <= static_cast<std::int64_t>(t); ++next) {
      if (next->hash != compute_hash(slow ? slow->world() : world)) comparison.differs_at(t);
    }
  }
  report.equal = report.first_difference < 0;
  if (rejudging) rejudging->finish(record);
  return report;
}

}  // namespace palpate
