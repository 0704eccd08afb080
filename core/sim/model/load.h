// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "palpate/sim/base/types.h"

namespace palpate {

/// A force on a point of a triangle.
struct Push {
  int triangle = 0;
  Vec3 weights = Vec3::Zero();  ///< barycentric, sum 1
  Vec3 force = Vec3::Zero();    ///< [N]
};
static_assert(sizeof(Push) == 56 && alignof(Push) == 8);

/// A force on a particle.
struct ParticleForce {
  int particle = 0;
  Vec3 force = Vec3::Zero();  ///< [N]
};
static_assert(alignof(ParticleForce) == 8);

/// What is done to a tissue during one step beside its laws. Pushes have a fixed capacity, so the
/// haptic thread never allocates.
struct Load {
  explicit Load(int capacity = 0) : storage(static_cast<std::size_t>(capacity)) {}

  Vec3 gravity = Vec3::Zero();  ///< [m/s²]
  std::vector<Push> storage;    ///< capacity
  int push_count = 0;           ///< how many of them are in force
  /// [N] external, on particles that are not held; a view that is valid for one step alone
  std::span<const ParticleForce> forces = {};

  std::span<const Push> pushes() const noexcept {
    return {storage.data(), static_cast<std::size_t>(push_count)};
  }
  void clear() noexcept { push_count = 0; }
  /// False, and nothing added, when the capacity is used up.
  bool add(const Push& push) noexcept {
    if (push_count == static_cast<int>(storage.size())) return false;
    storage[static_cast<std::size_t>(push_count++)] = push;
    return true;
  }
};

}  // namespace palpate
