// SPDX-License-Identifier: GPL-3.0-or-later
// What the device's own law is worth: how stiff a spring may be that the host commands late, as a
// torque or as a law, on the chip's image and an arm that turns about its yaw axis.
//
// With PALPATE_CHARTS set to a folder the largest stiffnesses are searched and left there for
// firmware/draw_charts.py.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <fstream>

#include "palpate/sim/haptics/plant.h"
#include "sim_bench.h"

using namespace palpate;

namespace {

constexpr double kCount = 1e-4;  ///< [rad] fine sensors: this is about delay, not grain

/// An arm of mass and the damping of its motors, held by no hand.
Plant bare_plant() {
  Plant plant;
  plant.masses.balance = 1.0;
  plant.dry_friction.setZero();
  plant.viscous_friction.setZero();
  return plant;
}

class YawBench : public SimBench {
 public:
  YawBench(double stiffness, double delay, bool law)
      : stiffness_(stiffness), delay_(delay), law_(law) {
    home_ = state_.joints;
    lever_ = compute_jacobian(find_arm(plant_), home_).col(0).norm();
    power_up();
  }

  /// Lets the arm go 3 mm beside its rest; by how much its swing grows or fades in a second.
  double compute_growth() {
    state_.joints[0] = 0.003 / lever_;
    double early = 0.0, late = 0.0;
    for (int ms = 0; ms < 1000; ++ms) {
      live();
      const double away = std::abs(state_.joints[0]) * lever_;
      if (ms < 250) early = std::max(early, away);
      if (ms >= 750) late = std::max(late, away);
      if (away > 0.012) return 100.0;  // gone
    }
    return late / early;
  }

 private:
  /// A millisecond, in twenty steps of chip and arm.
  void live() {
    for (int step = 0; step < 20; ++step) {
      chip.set_position(0, 512 + static_cast<int>(std::lround(state_.joints[0] / kCount)));
      wait(0.05);
      Drive drive{Vec3(chip.duty(0), 0.0, 0.0), chip.enabled()};
      move_plant(plant_, drive, {}, 50e-6, state_);
      // only the yaw is at work here
      state_.joints[1] = home_[1], state_.joints[2] = home_[2];
      state_.rates[1] = state_.rates[2] = 0.0;
      if (host.states != heard_) {
        heard_ = host.states;
        late_.push_back({chip.cycle() + static_cast<std::uint64_t>(delay_ * SimAvr::kFrequency),
                         host.state.position[0]});
      }
      if (!late_.empty() && late_.front().first <= chip.cycle()) {
        say(host.command(answer(late_.front().second)));
        late_.pop_front();
      }
    }
  }

  palpate_command answer(int position) const {
    // [1/32767 of full scale per count]
    const double slope = stiffness_ * lever_ * lever_ * kCount /
                         compute_stall_torque(plant_.motor) * static_cast<int>(PALPATE_TORQUE_FULL);
    palpate_command command{};
    command.torque[0] = static_cast<std::int16_t>(
        std::lround(std::clamp(slope * (512 - position), -32767.0, 32767.0)));
    if (law_) {
      command.has_law = true;
      command.shift = 4;
      command.stiffness[0] = static_cast<std::int16_t>(std::lround(16.0 * slope));
      for (auto& rest : command.rest) rest = 512 << PALPATE_FRACTION_BITS;
      command.rest[0] = static_cast<std::uint16_t>(position << PALPATE_FRACTION_BITS);
    }
    return command;
  }

  const Plant plant_ = bare_plant();
  PlantState state_{plant_};
  Vec3 home_;
  double lever_;
  const double stiffness_, delay_;
  const bool law_;
  int heard_ = 0;
  std::deque<std::pair<std::uint64_t, int>> late_;  ///< (cycle to answer at, position)
};

double compute_growth(double stiffness, double delay, bool law) {
  YawBench bench(stiffness, delay, law);
  const double growth = bench.compute_growth();
  // an arm that swings that fast is cut off by its firmware
  return bench.host.state.first_fault == PALPATE_FAULT_OVER_SPEED ? 100.0 : growth;
}

/// [N/m] above which a swing grows, by halving.
double find_stiffness_max(double delay, bool law) {
  double least = 20.0, most = 1500.0;
  for (int i = 0; i < 7; ++i) {
    const double middle = std::sqrt(least * most);
    (compute_growth(middle, delay, law) > 1.0 ? most : least) = middle;
  }
  return std::sqrt(least * most);
}

}  // namespace

TEST_CASE("a spring that grows as a torque commanded 1 or 2 ms late calms as a local law") {
  for (double delay : {1e-3, 2e-3}) {
    // 1.5 of what the torque alone allows, by the search below
    const double stiffness = 1.5 * (delay < 1.5e-3 ? 154.0 : 110.0);
    CHECK(compute_growth(stiffness, delay, false) > 1.2);
    CHECK(compute_growth(stiffness, delay, true) < 0.8);
  }
}

TEST_CASE("search of the largest stiffness with and without the law" *
          doctest::skip(std::getenv("PALPATE_CHARTS") == nullptr)) {
  std::ofstream out(std::string(std::getenv("PALPATE_CHARTS")) + "/local_law.csv");
  out << "delay,torque,law\n";
  for (double delay : {0.0, 1e-3, 2e-3, 3e-3, 5e-3}) {
    const double torque = find_stiffness_max(delay, false), law = find_stiffness_max(delay, true);
    std::printf("link %.0f ms late: %.0f N/m as a torque, %.0f N/m as a law, %.1f times\n",
                1e3 * delay, torque, law, law / torque);
    out << delay << ',' << torque << ',' << law << '\n';
  }
}
