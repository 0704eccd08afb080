// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "palpate/sim/base/private/realtime.h"

namespace palpate::bindings {

/// Lets Ctrl-C end a long call that has released Python's lock: such a call asks this between its
/// pieces, stops when told to, and raises what Python's signal handler raised.
class Interrupt {
 public:
  /// Whether to stop. Asked as often as one likes, it hears Python's signals every 10 ms; without
  /// the lock, and only of use in Python's main thread, which is where signals are handled.
  bool came() {
    const auto now = std::chrono::steady_clock::now();
    if (came_ || now - heard_ < std::chrono::milliseconds(10)) return came_;
    heard_ = now;
    const pybind11::gil_scoped_acquire acquired;
    came_ = PyErr_CheckSignals() != 0;
    return came_;
  }

  /// With the lock: what the handler raised, if it did.
  void rethrow() const {
    if (came_) throw pybind11::error_already_set();
  }

 private:
  std::chrono::steady_clock::time_point heard_ = std::chrono::steady_clock::now();
  bool came_ = false;
};

/// Calls `piece` until it is done, without Python's lock; Ctrl-C ends it between two of them.
template <class Piece>
void run_in_pieces(Piece piece) {
  Interrupt interrupt;
  {
    const pybind11::gil_scoped_release released;
    while (!piece() && !interrupt.came()) {
    }
  }
  interrupt.rethrow();
}

/// `wait(until)` until something came or until `latest` [ns of the monotonic clock], in short
/// pieces; what cannot wait at all says so at once.
template <class Wait>
bool wait_in_pieces(std::int64_t latest, Wait wait) {
  constexpr std::int64_t kPiece = 20'000'000;  // [ns]
  bool came = false;
  run_in_pieces([&] {
    const std::int64_t until = std::min(latest, read_clock() + kPiece);
    came = wait(until);
    return came || until == latest || read_clock() < until;
  });
  return came;
}

}  // namespace palpate::bindings
