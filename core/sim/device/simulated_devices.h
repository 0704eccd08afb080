// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "palpate/sim/base/lock_free.h"
#include "palpate/sim/device/device.h"

namespace palpate {

/// One moment of a script; between key frames the hand moves smoothly (minimum jerk), buttons
/// hold from their frame on.
struct KeyFrame {
  double time = 0.0;  ///< [s], ascending
  Vec3 position = Vec3::Zero();
  std::uint8_t buttons = 0;
};
static_assert(sizeof(KeyFrame) == 40 && alignof(KeyFrame) == 8);

/// A hand that follows a script, the same in every run.
class ScriptedDevice : public HapticDevice {
 public:
  /// Throws std::invalid_argument for no frames, times that do not ascend, or non-finite numbers.
  explicit ScriptedDevice(std::vector<KeyFrame> frames);

  HapticSample read(double time) noexcept override;
  void write(const HapticCommand& command) noexcept override { last_command = command; }
  std::string name() const override { return "script"; }
  DeviceDynamics dynamics() const noexcept override { return {.position_source = true}; }
  double duration() const noexcept { return frames_.back().time; }

  HapticCommand last_command;

 private:
  std::vector<KeyFrame> frames_;
};

/// A hand that a window moves: set() from the GUI thread, read() from the haptic thread.
///
/// A window tells where its pointer is some 60 times a second. In between the hand glides there,
/// two thirds of the path in 15 ms and never faster than 1 m/s, or the tissue would feel a
/// staircase. The first position is taken at once.
class PointerDevice : public HapticDevice {
 public:
  /// One calling thread; time and velocity are filled in by read().
  void set(const HapticSample& sample);
  HapticSample read(double time) noexcept override;
  void write(const HapticCommand& command) noexcept override;
  std::string name() const override { return "pointer"; }
  DeviceDynamics dynamics() const noexcept override { return {.position_source = true}; }
  /// The newest force, for the same thread as set().
  HapticCommand take_command() noexcept;

 private:
  Latest<HapticSample> samples_;
  Latest<HapticCommand> commands_;
  HapticSample hand_;  ///< as read last
  bool has_hand_ = false;
};

/// A hand read back from a record, one sample per call, whatever the time; the last one stays.
class ReplayDevice : public HapticDevice {
 public:
  /// Throws std::invalid_argument for no samples.
  explicit ReplayDevice(std::vector<HapticSample> samples);

  HapticSample read(double time) noexcept override;
  void write(const HapticCommand& command) noexcept override { last_command = command; }
  std::string name() const override { return "replay"; }
  DeviceDynamics dynamics() const noexcept override { return {.position_source = true}; }
  bool finished() const noexcept { return next_ >= samples_.size(); }

  HapticCommand last_command;

 private:
  std::vector<HapticSample> samples_;
  std::size_t next_ = 0;
};

}  // namespace palpate
