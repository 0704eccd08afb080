// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "palpate/sim/task/private/judgement.h"

namespace palpate {
namespace {

constexpr double kPeakTime = 0.01;  // [s] for which a force is held that counts as a peak

}  // namespace

void Judgement::tell(TaskEvent kind, std::size_t index, double value, int source) noexcept {
  if (progress_.event_count == static_cast<int>(progress_.events.size())) return;
  progress_.events[static_cast<std::size_t>(progress_.event_count++)] = {
      number_, static_cast<EventKind>(kind), static_cast<std::int32_t>(index), value, source};
}

void Judgement::judge(std::span<const HapticSample> samples,
                      std::span<const HapticCommand> commands) noexcept {
  progress_.event_count = 0;
  if (state_.outcome != Outcome::running) return;
  ++state_.ticks;
  state_.time = static_cast<double>(state_.ticks) * dt_;
  if (world_.alarm) return end(Outcome::diverged);
  measure(samples, commands);
  begin_steps();
  // before the steps: what is too much in the tick that would finish a task is too much
  for (std::size_t l = 0; l < task_.limits.size(); ++l) judge_limit(l);
  for (std::size_t s = 0; s < task_.steps.size(); ++s) {
    if (state_.steps[s].status == StepStatus::active) judge_step(s);
  }
  end_where_over();
}

void Judgement::measure(std::span<const HapticSample> samples,
                        std::span<const HapticCommand> commands) noexcept {
  for (std::size_t i = 0; i < progress_.signals.size(); ++i) {
    measures_[i] = measure_instrument(task_, world_, i, samples[i], commands[i],
                                      task_.tool_radii[i], dt_, progress_.signals[i]);
    follow_peak(progress_.signals[i]);
  }
}

/// The least force of the last 10 ms is a candidate for the peak: a spike of a tick is none.
void Judgement::follow_peak(const JudgeSignals& signals) noexcept {
  constexpr std::int64_t kLength = JudgeSignals::kHistory;
  const std::int64_t ticks = std::clamp<std::int64_t>(std::llround(kPeakTime / dt_), 1, kLength);
  if (number_ + 1 < ticks) return;
  double least = std::numeric_limits<double>::infinity();
  for (std::int64_t t = number_; t > number_ - ticks; --t) {
    least = std::min(least, signals.forces[static_cast<std::size_t>(t % kLength)]);
  }
  state_.peak_force = std::max(state_.peak_force, least);
}

void Judgement::end(Outcome outcome) noexcept {
  for (std::size_t l = 0; l < task_.limits.size(); ++l) {
    if (state_.limits[l].open) close_limit(l);
  }
  state_.outcome = outcome;
  tell(TaskEvent::task_ended, static_cast<std::size_t>(outcome), state_.time, 0);
}

void Judgement::end_where_over() noexcept {
  const bool errs = task_.errors_at_most >= 0 && state_.errors > task_.errors_at_most;
  if (ends_ || errs) return end(Outcome::failed);
  const bool all_done = std::ranges::all_of(
      state_.steps, [](const StepState& step) noexcept { return step.status == StepStatus::done; });
  if (all_done) return end(Outcome::done);
  if (state_.time >= task_.time_limit - kTimeRounding) end(Outcome::timed_out);
}

void judge(const Task& task, const World& world, std::span<const HapticSample> samples,
           std::span<const HapticCommand> commands, double dt, Progress& progress) noexcept {
  Judgement(task, world, dt, progress).judge(samples, commands);
}

}  // namespace palpate
