// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "palpate/sim/task/private/measure.h"
#include "palpate/sim/task/task.h"

namespace palpate {

/// [s] Sums of ticks are told from what was asked for only beyond rounding.
inline constexpr double kTimeRounding = 1e-9;

/// The judgement of one tick.
class Judgement {
 public:
  Judgement(const Task& task, const World& world, double dt, Progress& progress) noexcept
      : task_(task),
        world_(world),
        dt_(dt),
        number_(world.tick_count - 1),
        progress_(progress),
        state_(progress.state) {}

  void judge(std::span<const HapticSample> samples,
             std::span<const HapticCommand> commands) noexcept;

 private:
  void measure(std::span<const HapticSample> samples,
               std::span<const HapticCommand> commands) noexcept;
  void follow_peak(const JudgeSignals& signals) noexcept;
  void begin_steps() noexcept;
  void judge_step(std::size_t s) noexcept;
  bool is_met(const TaskStep& step, const Measures& measures) const noexcept;
  bool is_at(const TaskStep& step, const Measures& measures) const noexcept;
  bool is_held(const TaskStep& step, const Measures& measures) const noexcept;
  bool is_seen(const TaskStep& step) const noexcept;
  void dwell(std::size_t s, bool met) noexcept;
  void trace(std::size_t s, const Measures& measures) noexcept;
  void find(std::size_t s, const Measures& measures) noexcept;
  void finish_step(std::size_t s) noexcept;

  void judge_limit(std::size_t l) noexcept;
  double measure_limit(const TaskLimit& limit) const noexcept;
  bool is_watched_there(const TaskLimit& limit) const noexcept;
  void open_limit(std::size_t l, double value) noexcept;
  void follow_open_limit(std::size_t l, double value) noexcept;
  void close_limit(std::size_t l) noexcept;

  void end(Outcome outcome) noexcept;
  void end_where_over() noexcept;
  void add_error() noexcept { ++state_.errors; }
  void tell(TaskEvent kind, std::size_t index, double value, int source) noexcept;

  const Measures& measures(int instrument) const noexcept {
    return measures_[static_cast<std::size_t>(instrument)];
  }
  const TaskPlace& place(int index) const noexcept {
    return task_.places[static_cast<std::size_t>(index)];
  }
  double seconds_since(std::int64_t tick) const noexcept {
    return static_cast<double>(number_ - tick + 1) * dt_;
  }

  const Task& task_;
  const World& world_;
  const double dt_;
  const std::int64_t number_;
  Progress& progress_;
  TaskState& state_;
  bool ends_ = false;  // a limit that ends the task has opened
  std::array<Measures, kMostLoggedInstruments> measures_;
};

}  // namespace palpate
