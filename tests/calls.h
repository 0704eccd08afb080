// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::testing {

/// What one thread has asked for: memory, from the C allocator under `new` and Eigen alike, and
/// locks, of any kind POSIX knows. calls.cpp stands before the C library's own functions.
struct Calls {
  long allocations = 0;
  long locks = 0;
};

Calls count_calls_of_this_thread() noexcept;

/// False under the sanitizers, which stand in the same place.
bool calls_are_counted() noexcept;

}  // namespace palpate::testing
