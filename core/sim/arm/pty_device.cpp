// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "palpate/sim/arm/simulated_arm.h"
#include "palpate/sim/arm/transport.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/base/private/realtime.h"

namespace palpate {
namespace {

constexpr std::int64_t kTick = 1000000;  // [ns]

/// Bytes pass as they are, nothing is echoed.
void make_raw(int handle) {
  termios settings{};
  tcgetattr(handle, &settings);
  cfmakeraw(&settings);
  tcsetattr(handle, TCSANOW, &settings);
}

}  // namespace

struct PtyDevice::Impl {
  Impl(const Plant& plant, const NativeCoreOptions& options) : core(plant, options) {
    core.hold({Workspace{}.center, Vec3::Zero(), true});
  }
  ~Impl() {
    stopping.store(true);
    if (thread.joinable()) thread.join();
    if (ours >= 0) close(ours);
    if (theirs >= 0) close(theirs);
  }

  void run() noexcept {
    const std::int64_t start = read_clock();
    std::array<std::uint8_t, 512> bytes;
    for (std::int64_t tick = 1; !stopping.load(std::memory_order_relaxed); ++tick) {
      wait_until(start + tick * kTick, 0);
      const double time = 1e-9 * double(tick * kTick);
      core.press_buttons(buttons.load(std::memory_order_relaxed));
      const ssize_t came = ::read(ours, bytes.data(), bytes.size());
      if (came > 0) core.write(time, std::span(bytes).first(static_cast<std::size_t>(came)));
      const std::size_t count = core.read(time, bytes);
      // a full terminal has no reader: a wire without a reader loses bytes too
      if (count > 0 && ::write(ours, bytes.data(), count) < 0 && errno != EAGAIN) return;
    }
  }

  NativeCore core;
  int ours = -1, theirs = -1;
  std::string path;
  std::atomic<bool> stopping{false};
  std::atomic<std::uint8_t> buttons{0};
  std::thread thread;
};

PtyDevice::PtyDevice(const Plant& plant, const NativeCoreOptions& options)
    : impl_(std::make_unique<Impl>(plant, options)) {
  Impl& my = *impl_;
  my.ours = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (my.ours < 0 || grantpt(my.ours) != 0 || unlockpt(my.ours) != 0) {
    throw DeviceError(std::string("pseudo terminal: ") + std::strerror(errno));
  }
  my.path = ptsname(my.ours);
  // held open, so that it stays between two hosts
  my.theirs = open(my.path.c_str(), O_RDWR | O_NOCTTY);
  make_raw(my.theirs);
  my.thread = std::thread([&my] { my.run(); });
}

PtyDevice::~PtyDevice() = default;

std::string PtyDevice::path() const { return impl_->path; }

void PtyDevice::press_buttons(std::uint8_t buttons) noexcept {
  impl_->buttons.store(buttons, std::memory_order_relaxed);
}

}  // namespace palpate
