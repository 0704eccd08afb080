// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <asio/io_context.hpp>
#include <asio/serial_port.hpp>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "palpate/sim/arm/transport.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/base/private/realtime.h"

#ifdef __linux__
#include <linux/serial.h>
#endif

namespace palpate {
namespace {

namespace fs = std::filesystem;

/// An FTDI chip sends at once when this byte comes: the end of every frame. Bit 8 switches it on.
constexpr const char* kEventCharacter = "256";

fs::path find_device_folder(const std::string& path) {
  std::error_code none;
  const fs::path real = fs::canonical(path, none);
  return fs::path("/sys/class/tty") / (none ? fs::path(path) : real).filename() / "device";
}

std::string read_line(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

bool write_line(const fs::path& path, const std::string& line) {
  std::ofstream file(path);
  return static_cast<bool>(file << line << std::flush);
}

int read_latency_timer(const fs::path& folder) {
  const std::string line = read_line(folder / "latency_timer");
  return line.empty() || line.size() > 4 ? -1 : std::atoi(line.c_str());
}

/// Asks the driver and the adapter not to keep bytes back. Returns what came of it.
std::string ask_for_low_latency(int handle, const std::string& path) {
  const fs::path folder = find_device_folder(path);
  std::string note;
#ifdef TIOCSSERIAL
  serial_struct settings{};
  if (ioctl(handle, TIOCGSERIAL, &settings) == 0) {
    settings.flags |= ASYNC_LOW_LATENCY;
    note = ioctl(handle, TIOCSSERIAL, &settings) == 0 ? "driver set to low latency"
                                                      : "driver refused low latency";
  }
#else
  (void)handle;
#endif
  const int before = read_latency_timer(folder);
  if (before < 0) return note.empty() ? "nothing here keeps bytes back" : note;
  if (!note.empty()) note += "; ";
  write_line(folder / "event_char", kEventCharacter);
  const bool set = before <= 1 || write_line(folder / "latency_timer", "1");
  note += set ? "latency timer 1 ms"
              : "latency timer " + std::to_string(before) +
                    " ms: a udev rule with ATTR{latency_timer}=\"1\" would make the loop " +
                    std::to_string(before - 1) + " ms shorter";
  return note;
}

}  // namespace

struct SerialTransport::Impl {
  explicit Impl(std::string path_in) : path(std::move(path_in)), port(context) {}

  std::string path, note;
  asio::io_context context;
  asio::serial_port port;
  std::atomic<bool> open{true};
};

SerialTransport::SerialTransport(const std::string& path, int baud)
    : impl_(std::make_unique<Impl>(path)) {
  using Port = asio::serial_port_base;
  asio::serial_port& port = impl_->port;
  try {
    port.open(path);
    port.set_option(Port::baud_rate(static_cast<unsigned>(baud)));
    port.set_option(Port::character_size(8));
    port.set_option(Port::parity(Port::parity::none));
    port.set_option(Port::stop_bits(Port::stop_bits::one));
    port.set_option(Port::flow_control(Port::flow_control::none));
  } catch (const std::system_error& problem) {
    throw DeviceError(path + ": " + problem.code().message() +
                      ", expected a serial port that takes " + std::to_string(baud) + " bit/s");
  }
  const int handle = port.native_handle();
  fcntl(handle, F_SETFL, fcntl(handle, F_GETFL) | O_NONBLOCK);
  ioctl(handle, TIOCEXCL);  // two hosts would talk past each other
  tcflush(handle, TCIOFLUSH);
  impl_->note = ask_for_low_latency(handle, path);
}

SerialTransport::~SerialTransport() = default;

std::size_t SerialTransport::read(double, std::span<std::uint8_t> bytes) noexcept {
  if (!is_open()) return 0;
  const ssize_t count = ::read(impl_->port.native_handle(), bytes.data(), bytes.size());
  if (count > 0) return static_cast<std::size_t>(count);
  // a terminal without bytes says so by EAGAIN; an end of file or another error is a pulled cable
  if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
    impl_->open.store(false, std::memory_order_relaxed);
  }
  return 0;
}

/// What does not fit is dropped with the rest of its frame, which then fails its check: a backlog
/// of commands would be felt later, which is worse.
void SerialTransport::write(double, std::span<const std::uint8_t> bytes) noexcept {
  if (!is_open()) return;
  const ssize_t count = ::write(impl_->port.native_handle(), bytes.data(), bytes.size());
  if (count < 0 && errno != EAGAIN && errno != EINTR) {
    impl_->open.store(false, std::memory_order_relaxed);
  }
}

bool SerialTransport::wait(std::int64_t latest) noexcept {
  pollfd port{impl_->port.native_handle(), POLLIN, 0};
  const std::int64_t left = std::max<std::int64_t>(0, latest - read_clock());
  const timespec patience{left / 1000000000, left % 1000000000};
  return is_open() && ppoll(&port, 1, &patience, nullptr) > 0;
}

bool SerialTransport::is_open() const noexcept {
  return impl_->open.load(std::memory_order_relaxed);
}

double SerialTransport::now(double) const noexcept { return 1e-9 * double(read_clock()); }
std::string SerialTransport::name() const { return impl_->path; }
std::string SerialTransport::latency_note() const { return impl_->note; }

std::vector<SerialPort> find_serial_ports() {
  std::vector<SerialPort> ports;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator("/sys/class/tty", none)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with("ttyUSB") && !name.starts_with("ttyACM")) continue;
    const fs::path folder = entry.path() / "device";
    SerialPort port;
    port.path = "/dev/" + name;
    port.driver = fs::canonical(folder / "driver", none).filename();
    // the interface lies one or two folders below the device that has the name
    for (fs::path up = fs::canonical(folder, none); up.has_relative_path(); up = up.parent_path()) {
      port.product = read_line(up / "product");
      if (!port.product.empty()) break;
    }
    port.latency_timer = read_latency_timer(folder);
    port.permitted = access(port.path.c_str(), R_OK | W_OK) == 0;
    ports.push_back(port);
  }
  std::sort(ports.begin(), ports.end(),
            [](const SerialPort& a, const SerialPort& b) { return a.path < b.path; });
  return ports;
}

}  // namespace palpate
