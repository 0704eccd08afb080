// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>

namespace palpate {

/// A mailbox for one writer and one reader that holds only the newest value.
///
/// Three buffers: one belongs to the writer, one to the reader, one waits between them. Neither
/// side ever waits, allocates or locks, so the haptic thread may write while Python reads.
template <class T>
class Latest {
 public:
  explicit Latest(const T& initial = T()) : buffers_{initial, initial, initial} {}

  /// The writer's own buffer: fill it, then publish().
  T& back() noexcept { return buffers_[back_]; }

  /// Hands the writer's buffer over; what the reader had not yet taken is dropped.
  void publish() noexcept {
    back_ = waiting_.exchange(back_ | kFresh, std::memory_order_acq_rel) & ~kFresh;
  }

  /// Takes the newest value if there is one the reader has not seen. True if there was.
  bool take() noexcept {
    if (!(waiting_.load(std::memory_order_acquire) & kFresh)) return false;
    front_ = waiting_.exchange(front_, std::memory_order_acq_rel) & ~kFresh;
    return true;
  }

  /// The value last taken; stays unchanged until the next take().
  const T& front() const noexcept { return buffers_[front_]; }

 private:
  static constexpr int kFresh = 4;

  std::array<T, 3> buffers_;
  std::atomic<int> waiting_{1};
  int back_ = 0;
  int front_ = 2;
};

}  // namespace palpate
