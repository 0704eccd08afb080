// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/dynamics/state.h"

#include "palpate/sim/dynamics/private/laws.h"

namespace palpate {

State::State(const TissueModel& model)
    : position(model.rest_position),
      velocity(model.rest_position.size(), Vec3::Zero()),
      force(model.rest_position.size(), Vec3::Zero()),
      internal(count_internal(model), 0.0) {
  scratch.position = scratch.velocity = force;
  scratch.slope_position = scratch.slope_velocity = force;
}

std::size_t count_internal(const TissueModel& model) noexcept {
  std::size_t count = 0;
  laws::for_each([&]<class Law>(Law) { count += laws::count_internal<Law>(model); });
  return count;
}

void advance_internal(const TissueModel& model, double dt, State& state) noexcept {
  laws::for_each_part(
      model, std::span(state.internal), [&]<class Law>(Law, std::span<double> part) {
        if constexpr (requires { Law::advance_internal(model, state.position, dt, part); }) {
          Law::advance_internal(model, state.position, dt, part);
        }
      });
}

}  // namespace palpate
