// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "palpate/sim/task/private/judgement.h"
#include "palpate/sim/task/private/objects.h"

namespace palpate {
namespace {

constexpr double kCalm = 0.1;     // [s] of quiet after which a limit closes,
constexpr double kRelease = 0.9;  // [-] below this part of its bound

}  // namespace

double Judgement::measure_limit(const TaskLimit& limit) const noexcept {
  const Measures& now = measures(limit.instrument);
  const auto i = static_cast<std::size_t>(limit.instrument);
  const bool touches = now.contact.weight > 0.0;
  switch (limit.measure) {
    case TaskMeasure::force:
      if (limit.place < 0) return now.force;
      [[fallthrough]];
    case TaskMeasure::contact:
      return now.contact.weight * find_contact_share(task_, world_, i, place(limit.place), now);
    case TaskMeasure::force_rate:
      return now.force_rate;
    case TaskMeasure::depth:
      return now.depth;
    case TaskMeasure::distance:
      return now.displacement.norm();
    case TaskMeasure::speed:
      return now.speed;
    case TaskMeasure::clearance:
      return std::max(0.0, find_distance(place(limit.place), world_.instruments[i].tool.position) -
                               task_.tool_radii[i]);
    case TaskMeasure::off_path:
      return touches ? find_distance(place(limit.place), now.contact.at_rest) : 0.0;
    case TaskMeasure::strain:
      return find_strain(task_, world_, i, limit.place < 0 ? nullptr : &place(limit.place));
    case TaskMeasure::loose:
      return is_object_held(task_, world_, i, place(limit.place).body) ? 0.0 : 1.0;
    case TaskMeasure::out_of_view:
      return is_watched_there(limit) && !is_in_view(task_, world_, i) ? 1.0 : 0.0;
    case TaskMeasure::object_force:
      return world_.rigid[static_cast<std::size_t>(place(limit.place).body)].tissue_force.norm();
    case TaskMeasure::pad_pressure:
      return world_.instruments[i].tool.pad_pressure;
    case TaskMeasure::torn:
      return std::ranges::any_of(
          world_.bodies, [](const SoftState& body) noexcept { return body.torn_count > 0; });
  }
  return 0.0;
}

/// Everywhere, or while the tip is inside a space.
bool Judgement::is_watched_there(const TaskLimit& limit) const noexcept {
  if (limit.place < 0) return true;
  const auto i = static_cast<std::size_t>(limit.instrument);
  return find_distance(place(limit.place), world_.instruments[i].tool.position) == 0.0;
}

void Judgement::judge_limit(std::size_t l) noexcept {
  const TaskLimit& limit = task_.limits[l];
  LimitState& state = state_.limits[l];
  JudgeTimer& timer = progress_.limit_timers[l];
  const bool watched =
      limit.during.empty() || std::ranges::any_of(limit.during, [&](int step) noexcept {
        return state_.steps[static_cast<std::size_t>(step)].status == StepStatus::active;
      });
  if (!watched) {
    timer = {};
    if (state.open) close_limit(l);
    return;
  }
  const double value = measure_limit(limit);
  if (state.open) return follow_open_limit(l, value);
  const bool wrong = limit.above ? value > limit.bound : value < limit.bound;
  timer.held = wrong ? timer.held + 1 : 0;
  if (wrong && timer.held * dt_ >= limit.duration - kTimeRounding) open_limit(l, value);
}

void Judgement::open_limit(std::size_t l, double value) noexcept {
  const TaskLimit& limit = task_.limits[l];
  LimitState& state = state_.limits[l];
  progress_.limit_timers[l] = {};
  state.open = true;
  ++state.count;
  if (state.count == 1) state.worst = value;
  tell(TaskEvent::limit_opened, l, value, limit.instrument);
  if (limit.then == LimitConsequence::warn) ++state_.warnings;
  if (limit.then != LimitConsequence::warn) add_error();
  if (limit.then == LimitConsequence::end) ends_ = true;
  follow_open_limit(l, value);
}

void Judgement::follow_open_limit(std::size_t l, double value) noexcept {
  const TaskLimit& limit = task_.limits[l];
  LimitState& state = state_.limits[l];
  JudgeTimer& timer = progress_.limit_timers[l];
  const double beyond = limit.above ? value - limit.bound : limit.bound - value;
  state.worst = limit.above ? std::max(state.worst, value) : std::min(state.worst, value);
  state.excess += std::max(0.0, beyond) * dt_;
  state.duration += dt_;
  ++timer.held;
  const bool calm = limit.above ? value <= kRelease * limit.bound : value >= limit.bound / kRelease;
  timer.quiet = calm ? timer.quiet + 1 : 0;
  if (timer.quiet * dt_ >= kCalm - kTimeRounding) close_limit(l);
}

void Judgement::close_limit(std::size_t l) noexcept {
  JudgeTimer& timer = progress_.limit_timers[l];
  state_.limits[l].open = false;
  tell(TaskEvent::limit_closed, l, timer.held * dt_, task_.limits[l].instrument);
  timer = {};
}

}  // namespace palpate
