// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/loop/private/tree_builder.h"

#include <algorithm>
#include <exception>

#include "palpate/sim/tick/private/follow_tissue.h"
#include "palpate/sim/tick/private/world_internals.h"

namespace palpate {

TreeBuilder::TreeBuilder(const SoftState& body)
    : surface_(surface_position(body).size()),
      triangles_(body.tree.triangles().begin(), body.tree.triangles().end()),
      thread_([this] { work(); }) {}

TreeBuilder::~TreeBuilder() {
  over_.store(true, std::memory_order_release);
  call_worker();
  thread_.join();
}

void TreeBuilder::call_worker() noexcept {
  calls_.fetch_add(1, std::memory_order_release);
  calls_.notify_one();
}

bool TreeBuilder::will_ask(const World& world, std::size_t body) const noexcept {
  return turn_.load(std::memory_order_acquire) == Turn::free && !world.alarm &&
         wants_tree(world.bodies[body]);
}

std::optional<Event> TreeBuilder::serve(std::size_t body, World& world) noexcept {
  SoftState& state = world.bodies[body];
  const Turn turn = turn_.load(std::memory_order_acquire);
  if (will_ask(world, body) && !is_behind(state)) {
    std::ranges::copy(surface_position(state), surface_.begin());
    asked_at_ = world.tick_count;
    growth_ = internals(state).tree_cost.growth();
    turn_.store(Turn::asked, std::memory_order_release);
    call_worker();
  }
  if (turn != Turn::ready) return std::nullopt;
  exchange_tree(built_, state);
  turn_.store(Turn::returned, std::memory_order_release);
  call_worker();
  const auto age = static_cast<std::int32_t>(world.tick_count - asked_at_);
  return Event{world.tick_count, EventKind::tree_exchanged, age, growth_,
               static_cast<std::int32_t>(body)};
}

TreeBuilder::Turn TreeBuilder::build() noexcept {
  try {
    built_ = build_over(surface_, triangles_);
    return Turn::ready;
  } catch (const std::exception&) {
    // no memory: the world keeps its tree, whose answers are as right, only later
    return Turn::failed;
  }
}

void TreeBuilder::work() noexcept {
  unsigned seen = 0;
  while (!over_.load(std::memory_order_acquire)) {
    const Turn turn = turn_.load(std::memory_order_acquire);
    if (turn == Turn::asked) turn_.store(build(), std::memory_order_release);
    if (turn == Turn::returned) {
      built_ = {};
      turn_.store(Turn::free, std::memory_order_release);
    }
    calls_.wait(seen, std::memory_order_acquire);
    seen = calls_.load(std::memory_order_acquire);
  }
}

}  // namespace palpate
