// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace palpate {

/// What the operating system granted a thread.
struct Realtime {
  bool scheduled = false;  ///< SCHED_FIFO, priority 80
  bool locked = false;     ///< memory stays in RAM
  std::string note;        ///< what was not granted and why, in words; empty when all was
};

/// Asks for the calling thread: real-time scheduling and locked memory if `wanted`, and to stay on
/// core `cpu` unless that is -1. Never fails; what was refused stands in the note.
Realtime enter_realtime(bool wanted, int cpu);

/// Lets the memory go again once the last thread that locked it has left.
void leave_realtime(const Realtime& granted);

/// [ns] of the clock that never jumps.
std::int64_t read_clock() noexcept;

/// [ns] of a processor that the calling thread has had.
std::int64_t read_thread_clock() noexcept;

/// Sleeps until `spin` [ns] before `due` [ns of read_clock()] and spins the rest: the kernel wakes
/// a sleeper some 40 us late, a spinning thread is there within one.
void wait_until(std::int64_t due, std::int64_t spin) noexcept;

}  // namespace palpate
