// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/task/private/judgement.h"
#include "palpate/sim/task/private/objects.h"

namespace palpate {
namespace {

constexpr double kHalf = 0.5;  // [-] of force or stiffness that is at a place
constexpr double kGap = 0.1;   // [s] that a dwell may be left for
/// [-] of a path's radius: how far ahead of what has been touched the next point may be.
constexpr double kLookAhead = 2.0;

bool lies_in(double value, const Band& band) noexcept {
  return value >= band.least && value <= band.most;
}

}  // namespace

void Judgement::begin_steps() noexcept {
  for (std::size_t s = 0; s < task_.steps.size(); ++s) {
    StepState& step = state_.steps[s];
    if (step.status != StepStatus::waiting) continue;
    const bool may = std::ranges::all_of(task_.steps[s].after, [&](int other) noexcept {
      return state_.steps[static_cast<std::size_t>(other)].status == StepStatus::done;
    });
    if (!may) continue;
    step.status = StepStatus::active;
    step.from_tick = number_;
    tell(TaskEvent::step_begun, s, 0.0, task_.steps[s].instrument);
  }
}

bool Judgement::is_at(const TaskStep& step, const Measures& measures) const noexcept {
  return find_contact_share(task_, world_, static_cast<std::size_t>(step.instrument),
                            place(step.place), measures) >= kHalf;
}

bool Judgement::is_held(const TaskStep& step, const Measures& measures) const noexcept {
  if (step.place < 0) return measures.hold.weight > 0.0;
  return find_hold_share(task_, world_, static_cast<std::size_t>(step.instrument),
                         place(step.place), measures) >= kHalf;
}

bool Judgement::is_seen(const TaskStep& step) const noexcept {
  return std::ranges::any_of(task_.cameras, [&](const TaskCamera& camera) noexcept {
    return camera.instrument == step.instrument &&
           is_looked_at(task_, world_, camera, place(step.place), step.distance);
  });
}

/// Of the verbs that ask for something during a time.
bool Judgement::is_met(const TaskStep& step, const Measures& measures) const noexcept {
  switch (step.verb) {
    case TaskVerb::touch:
      return is_at(step, measures);
    case TaskVerb::hold:
    case TaskVerb::push:
      return lies_in(measures.force, step.force) && lies_in(measures.depth, step.depth) &&
             is_at(step, measures);
    case TaskVerb::pull:
      return lies_in(measures.force, step.force) &&
             lies_in(measures.displacement.norm(), step.distance) &&
             measures.displacement.dot(measures.hold.normal) > 0.0 && is_held(step, measures);
    case TaskVerb::grasp:
      return is_held(step, measures);
    case TaskVerb::release:
      return !is_held(step, measures);
    case TaskVerb::look:
      return is_seen(step);
    case TaskVerb::remove:
      return is_outside(task_, world_, place(step.place).body, place(step.space));
    case TaskVerb::carry:
      return is_inside(world_, place(step.place).body, place(step.space));
    default:
      return false;
  }
}

void Judgement::judge_step(std::size_t s) noexcept {
  const TaskStep& step = task_.steps[s];
  StepState& state = state_.steps[s];
  const Measures& now = measures(step.instrument);
  if (step.verb == TaskVerb::trace) {
    trace(s, now);
  } else if (step.verb == TaskVerb::find) {
    find(s, now);
  } else {
    dwell(s, is_met(step, now));
  }
  const bool late = step.time_limit > 0.0 && state.status == StepStatus::active &&
                    seconds_since(state.from_tick) > step.time_limit + kTimeRounding;
  if (!late || state.overdue) return;
  state.overdue = true;
  add_error();
  tell(TaskEvent::step_overdue, s, step.time_limit, step.instrument);
}

void Judgement::dwell(std::size_t s, bool met) noexcept {
  JudgeTimer& timer = progress_.step_timers[s];
  if (met) {
    ++timer.held;
    timer.quiet = 0;
  } else if (timer.held > 0 && ++timer.quiet * dt_ > kGap + kTimeRounding) {
    timer = {};
  }
  state_.steps[s].dwell = timer.held * dt_;
  if (met && timer.held * dt_ >= task_.steps[s].duration - kTimeRounding) finish_step(s);
}

/// A path is followed in order: from what was touched so far on, a point may be touched next that
/// is not farther ahead than twice the path's radius.
void Judgement::trace(std::size_t s, const Measures& measures) noexcept {
  const TaskStep& step = task_.steps[s];
  const TaskPlace& path = place(step.place);
  if (!(measures.contact.weight > 0.0) || measures.contact.body != path.body) return;
  if (!lies_in(measures.force, step.force)) return;
  double& reached = progress_.reached[s];
  const double length = path.arc_length.back();
  const double ahead = std::min(reached + kLookAhead * path.radius, length);
  const OnPath at = find_on_path(path, measures.contact.at_rest, reached, ahead);
  if (at.distance > path.radius) return;
  reached = std::max(reached, at.arc_length);
  state_.steps[s].progress = reached / length;
  if (state_.steps[s].progress >= step.share) finish_step(s);
}

/// A click beside the place, or in the air, is an error: who clicks everywhere has found nothing.
void Judgement::find(std::size_t s, const Measures& measures) noexcept {
  const TaskStep& step = task_.steps[s];
  if (!measures.clicked) return;
  const bool presses = measures.contact.weight > 0.0 && lies_in(measures.force, step.force);
  if (presses && is_at(step, measures)) return finish_step(s);
  add_error();
  const double distance = measures.contact.weight > 0.0
                              ? find_distance(place(step.place), measures.contact.at_rest)
                              : std::numeric_limits<double>::infinity();
  tell(TaskEvent::click_missed, s, std::isfinite(distance) ? distance : -1.0, step.instrument);
}

void Judgement::finish_step(std::size_t s) noexcept {
  StepState& step = state_.steps[s];
  step.status = StepStatus::done;
  step.until_tick = number_;
  tell(TaskEvent::step_done, s, seconds_since(step.from_tick), task_.steps[s].instrument);
}

}  // namespace palpate
