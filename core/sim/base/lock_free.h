// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <span>
#include <vector>

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

/// A queue between one writer and one reader [Lamport77], without lock or allocation: `tail` counts
/// what was ever written and only the writer moves it, `head` what was ever read and only the
/// reader moves it. Each side publishes its counter with release after it is done with the slot and
/// reads the other's with acquire before it touches one.
template <class T>
class Ring {
 public:
  explicit Ring(std::size_t capacity) : slots_(capacity) {}

  /// False where there is no room.
  bool push(const T& value) noexcept { return push(std::span(&value, 1)); }

  /// All of them, which the reader then finds together, or none: false where there is no room.
  bool push(std::span<const T> values) noexcept {
    const std::size_t written = tail_.load(std::memory_order_relaxed);
    const std::size_t used = written - head_.load(std::memory_order_acquire);
    if (slots_.size() - used < values.size()) return false;
    for (std::size_t i = 0; i < values.size(); ++i) {
      slots_[(written + i) % slots_.size()] = values[i];
    }
    tail_.store(written + values.size(), std::memory_order_release);
    return true;
  }

  /// The oldest value, until pop(); null where there is none.
  const T* front() const noexcept {
    const std::size_t read = head_.load(std::memory_order_relaxed);
    if (read == tail_.load(std::memory_order_acquire)) return nullptr;
    return &slots_[read % slots_.size()];
  }

  /// Drops front(), which must not be null.
  void pop() noexcept {
    head_.store(head_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }

  /// Appends all there is to `out`.
  void take(std::vector<T>& out) {
    const std::size_t written = tail_.load(std::memory_order_acquire);
    std::size_t read = head_.load(std::memory_order_relaxed);
    for (; read != written; ++read) out.push_back(slots_[read % slots_.size()]);
    head_.store(read, std::memory_order_release);
  }

 private:
  std::vector<T> slots_;
  // apart, so that the two threads do not fight over one cache line
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
};

}  // namespace palpate
