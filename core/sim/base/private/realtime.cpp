// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/base/private/realtime.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <time.h>

#include <atomic>
#include <cerrno>
#include <cstring>

namespace palpate {
namespace {

constexpr int kPriority = 80;

/// Threads that hold the memory of the process locked.
std::atomic<int> locking_threads{0};

void append(std::string& note, const std::string& sentence) {
  if (!note.empty()) note += "; ";
  note += sentence;
}

void pin_to(int cpu, std::string& note) {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  int error = EINVAL;
  if (cpu < CPU_SETSIZE) {
    CPU_SET(cpu, &cores);
    error = pthread_setaffinity_np(pthread_self(), sizeof cores, &cores);
  }
  if (error != 0) {
    append(note, "not pinned to core " + std::to_string(cpu) + ": " + std::strerror(error));
  }
}

std::string explain_no_scheduling(int error) {
  std::string text = std::string("no real-time priority: ") + std::strerror(error);
  rlimit limit{};
  if (error == EPERM && getrlimit(RLIMIT_RTPRIO, &limit) == 0) {
    text += " (rtprio limit " + std::to_string(limit.rlim_cur) + ", needs " +
            std::to_string(kPriority) + "; set it in /etc/security/limits.conf)";
  }
  return text;
}

std::string explain_no_locking(int error) {
  std::string text = std::string("memory not locked: ") + std::strerror(error);
  rlimit limit{};
  if ((error == ENOMEM || error == EPERM) && getrlimit(RLIMIT_MEMLOCK, &limit) == 0) {
    text += " (memlock limit " + std::to_string(limit.rlim_cur / 1024) +
            " kB; set it in /etc/security/limits.conf)";
  }
  return text;
}

std::int64_t read(clockid_t clock) noexcept {
  timespec now;
  clock_gettime(clock, &now);
  return now.tv_sec * std::int64_t{1000000000} + now.tv_nsec;
}

void spin_once() noexcept {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

}  // namespace

Realtime enter_realtime(bool wanted, int cpu) {
  Realtime granted;
  if (cpu >= 0) pin_to(cpu, granted.note);
  if (!wanted) {
    append(granted.note, "real-time priority was not asked for");
    return granted;
  }
  sched_param priority{};
  priority.sched_priority = kPriority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
  granted.scheduled = error == 0;
  if (error != 0) append(granted.note, explain_no_scheduling(error));

  // only what is there now, and of that only what has been touched: a tick allocates nothing, and
  // what Python allocates later need not stay in RAM (nor fail for want of a limit)
  granted.locked = mlockall(MCL_CURRENT | MCL_ONFAULT) == 0;
  if (granted.locked) {
    locking_threads.fetch_add(1);
  } else {
    append(granted.note, explain_no_locking(errno));
  }
  return granted;
}

void leave_realtime(const Realtime& granted) {
  if (granted.locked && locking_threads.fetch_sub(1) == 1) munlockall();
}

std::int64_t read_clock() noexcept { return read(CLOCK_MONOTONIC); }

std::int64_t read_thread_clock() noexcept { return read(CLOCK_THREAD_CPUTIME_ID); }

void wait_until(std::int64_t due, std::int64_t spin) noexcept {
  const std::int64_t wake = due - spin;
  if (wake > read_clock()) {
    const timespec until{wake / 1000000000, wake % 1000000000};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
    }
  }
  while (read_clock() < due) spin_once();
}

}  // namespace palpate
