// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "core/arm/plants.h"
#include "palpate/sim/arm/serial_device.h"

extern "C" {
#include "firmware/protocol/frame.h"
#include "firmware/protocol/messages.h"
}

namespace palpate {

/// Takes the local law out of every command: the same driver, as if the device obeyed none.
class WithoutLaw : public Transport {
 public:
  explicit WithoutLaw(Transport& transport) : transport_(transport) {}

  std::size_t read(double time, std::span<std::uint8_t> bytes) noexcept override {
    return transport_.read(time, bytes);
  }
  void write(double time, std::span<const std::uint8_t> bytes) noexcept override {
    palpate_command command;
    std::array<std::uint8_t, PALPATE_WIRE_MAX> wire;
    for (const std::uint8_t byte : bytes) {
      if (palpate_decode_byte(&decoder_, byte) != PALPATE_FRAME ||
          !palpate_read_command(decoder_.body, decoder_.count, &command)) {
        continue;
      }
      command.has_law = false;
      std::array<std::uint8_t, PALPATE_BODY_MAX> body;
      const std::uint8_t count = palpate_write_command(&command, body.data());
      bytes = std::span(wire).first(palpate_encode_frame(body.data(), count, wire.data()));
      break;
    }
    transport_.write(time, bytes);
  }
  bool is_open() const noexcept override { return transport_.is_open(); }
  std::string name() const override { return transport_.name(); }

 private:
  Transport& transport_;
  palpate_decoder decoder_{};
};

/// A spring in every direction to one point, through the driver, on a bare arm with fine sensors:
/// this is about delay, not grain. There the upper link is level and the forearm hangs down, so the
/// tip is damped alike in every direction.
template <class Core>
class LawBench {
 public:
  template <class... Arguments>
  explicit LawBench(bool law, const Arguments&... arguments)
      : core(arguments...),
        without_(core),
        device(law ? static_cast<Transport&>(core) : without_, Workspace{}.center) {
    core.state().joints = Vec3(5e-3, 3e-3, -3e-3);  // a millimetre beside
    device.open();
    run(0.7, 0.0);
  }

  /// Of a bare arm that its sensors can see whole.
  static Plant plant() {
    Plant plant = bare_plant();
    plant.joint_min.setConstant(-0.19);
    plant.joint_max.setConstant(0.19);
    plant.count = 4e-4;
    return plant;
  }

  /// By how much the swing of a spring of `stiffness` [N/m] grows or fades in a second; 100 where
  /// it is gone.
  double find_growth(double stiffness) {
    const double early = run(0.25, stiffness);
    run(0.5, stiffness);
    const double late = run(0.25, stiffness);
    device.take_status();
    return late > 0.015 || device.status().mode != DeviceMode::run ? 100.0 : late / early;
  }

  Core core;

 private:
  WithoutLaw without_;

 public:
  SerialDevice device;

 private:
  /// The widest swing [m] meanwhile.
  double run(double duration, double stiffness) {
    const Vec3 rest = compute_tip(find_arm(core.plant()), Vec3::Zero());
    double widest = 0.0;
    for (int k = 0; k < duration / 1e-3 - 1e-9; ++k, time_ += 1e-3) {
      const HapticSample sample = device.read(time_);
      device.write({.force = stiffness * (rest - sample.position)});
      widest = std::max(widest, (find_tip(core.plant(), core.state()) - rest).norm());
    }
    return widest;
  }

  double time_ = 0.0;
};

}  // namespace palpate
