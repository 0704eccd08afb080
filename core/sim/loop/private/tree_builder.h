// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <optional>
#include <thread>

#include "palpate/sim/loop/private/exchange_tree.h"
#include "palpate/sim/tick/tick_log.h"

namespace palpate {

/// Builds trees for the haptic thread in a thread of its own.
///
/// Both share one buffer in turns: positions go one way, a tree built over them the other, and then
/// the old tree back, to be freed. Whose turn it is stands in an atomic number; nobody ever waits
/// for the other with a lock, and the haptic thread neither allocates nor frees.
class TreeBuilder {
 public:
  /// For bodies with these triangles and vertices of their surface.
  explicit TreeBuilder(const SoftState& body);
  ~TreeBuilder();  ///< waits for a tree that is being built

  /// Haptic thread: whether serve() would now have a tree built, were the body's surface up to date
  /// (catch_up).
  bool will_ask(const World& world, std::size_t body) const noexcept;

  /// Haptic thread, between two ticks: takes over a tree that is ready, and says what a record
  /// keeps of that; or has one built where the body's own has become costly.
  std::optional<Event> serve(std::size_t body, World& world) noexcept;

 private:
  enum class Turn { free, asked, ready, returned, failed };

  void work() noexcept;
  Turn build() noexcept;
  void call_worker() noexcept;

  Vec3Array surface_;  // [m]
  const std::vector<Triangle> triangles_;
  BuiltTree built_;
  long asked_at_ = 0;  // ticks done
  double growth_ = 1.0;
  std::atomic<Turn> turn_{Turn::free};
  std::atomic<unsigned> calls_{0};  // what the worker sleeps on
  std::atomic<bool> over_{false};
  std::thread thread_;
};

}  // namespace palpate
