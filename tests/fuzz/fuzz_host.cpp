// SPDX-License-Identifier: BSD-3-Clause
// Any words from a device to its driver: what the tick gets is finite, what goes out are whole
// frames of known messages, and a calibration is one that can be computed with or none.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "../firmware/host_of_device.h"
#include "insist.h"
#include "palpate/sim/arm/private/calibration_bytes.h"
#include "palpate/sim/arm/serial_device.h"
#include "palpate/sim/device/safe_device.h"

using palpate::Bytes;
using palpate::fuzz::Input;
using palpate::fuzz::insist;

namespace {

void append(Bytes& stream, const Bytes& more) {
  stream.insert(stream.end(), more.begin(), more.end());
}

Bytes take_bytes(Input& input, std::size_t count) {
  Bytes bytes(count);
  for (std::uint8_t& byte : bytes) byte = input.byte();
  return bytes;
}

/// A message of the device's whose frame is sound, whatever it says.
Bytes take_frame(Input& input) {
  static constexpr std::uint8_t kTypes[] = {PALPATE_INFO, PALPATE_STATE, PALPATE_ANSWER,
                                            PALPATE_PAGE};
  static constexpr std::uint8_t kCounts[] = {22, 31, 4, 3 + PALPATE_PAGE_BYTES};
  const std::uint8_t kind = input.byte();
  Bytes body = {kTypes[kind % 4]};
  const std::size_t count = kind < 240 ? kCounts[kind % 4] : kind % 32 + 1u;
  append(body, take_bytes(input, std::min<std::size_t>(count, PALPATE_BODY_MAX) - 1));
  return palpate::encode(body);
}

/// The real firmware at the end of a wire on which the input decides what comes of its words.
class HostileWire : public palpate::Transport {
 public:
  explicit HostileWire(Input& input, bool calibrated) : input_(input) {
    static const Bytes eeprom = palpate::calibrated_eeprom();
    palpate_board_init(&board_, calibrated ? eeprom.data() : nullptr);
    palpate_start_decoder(&decoder_);
  }

  /// A millisecond of the device; its words come through unchanged for the first `honest` ones.
  void advance(bool honest) {
    palpate_board_tick(&board_);
    Bytes said(PALPATE_SEND_BYTES);
    said.resize(palpate_board_take(&board_, said.data(), PALPATE_SEND_BYTES));
    if (honest) return append(wire_, said);
    const std::uint8_t turn = input_.byte();
    if (turn % 8 != 1) append(wire_, said);
    switch (turn % 8) {
      case 2:
        if (!said.empty()) wire_[wire_.size() - 1 - turn / 8 % said.size()] ^= input_.byte();
        break;
      case 3:
      case 4:
        return append(wire_, take_frame(input_));
      case 5:
        return append(wire_, take_bytes(input_, turn / 8));
      case 6:
        board_.adc[turn / 8 % 6] = static_cast<std::uint16_t>(input_.word() & 1023);
        break;
      case 7:
        if (turn == 255) palpate_board_reset(&board_, 1);
        if (turn == 247) open_ = false;
        break;
      default:
        break;
    }
  }

  std::size_t read(double, std::span<std::uint8_t> bytes) noexcept override {
    const std::size_t count = std::min(bytes.size(), wire_.size());
    std::copy_n(wire_.begin(), count, bytes.begin());
    wire_.erase(wire_.begin(), wire_.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  void write(double, std::span<const std::uint8_t> bytes) noexcept override {
    for (const std::uint8_t byte : bytes) {
      const palpate_decoded decoded = palpate_decode_byte(&decoder_, byte);
      insist(decoded != PALPATE_DAMAGED, "the host sends whole frames");
      if (decoded == PALPATE_FRAME) check_message();
    }
    palpate_board_receive(&board_, bytes.data(), static_cast<std::uint16_t>(bytes.size()));
  }
  bool is_open() const noexcept override { return open_; }
  std::string name() const override { return "hostile wire"; }

 private:
  void check_message() const {
    const std::uint8_t* body = decoder_.body;
    const std::uint8_t count = decoder_.count;
    palpate_hello hello;
    palpate_command command;
    palpate_order order;
    palpate_page page;
    palpate_store store;
    std::uint8_t seq, number;
    insist(palpate_read_hello(body, count, &hello) || palpate_read_command(body, count, &command) ||
               palpate_read_order(body, count, PALPATE_ENABLE, &order) ||
               palpate_read_order(body, count, PALPATE_CLEAR, &order) ||
               (count == 2 && body[0] == PALPATE_DISABLE) ||
               palpate_read_read_page(body, count, &seq, &number) ||
               palpate_read_page(body, count, PALPATE_WRITE_PAGE, &page) ||
               palpate_read_store(body, count, &store),
           "the host sends messages of the protocol");
  }

  Input& input_;
  palpate_board board_;
  palpate_decoder decoder_;
  Bytes wire_;
  bool open_ = true;
};

void check_sample(const palpate::HapticSample& sample) {
  insist(sample.position.allFinite(), "the hand is at a finite place");
  insist(sample.velocity.allFinite(), "the hand has a finite velocity");
  insist(std::abs(sample.orientation.norm() - 1.0) < 1e-6, "the stylus is turned by a rotation");
}

void check_status(palpate::SerialDevice& device) {
  if (!device.take_status()) return;
  const palpate::DeviceStatus& status = device.status();
  insist(status.force_applied.allFinite(), "the force of the motors is finite");
  insist(std::isfinite(status.clock_drift) && std::isfinite(status.local_stiffness),
         "what is measured of the device is finite");
  insist(!palpate::describe_status(status).empty(), "every status has a sentence");
}

/// Thirty honest milliseconds are a link that is made; the rest is the input's.
void run_session(Input& input, bool calibrated, bool greeted) {
  constexpr int kMostTicks = 600;
  HostileWire wire(input, calibrated);
  palpate::SerialDevice device(wire);
  for (int ms = 0; ms < kMostTicks && !(input.empty() && ms > 40); ++ms) {
    const double time = 1e-3 * ms;
    wire.advance(greeted && ms < 30);
    check_sample(device.read(time));
    device.write({palpate::Vec3(3.0, -1.0, 0.002 * ms)});
    check_status(device);
  }
}

/// The pages a device keeps, read as the host reads them.
void read_pages(Input& input) {
  Bytes pages(PALPATE_CALIBRATION_BYTES);
  const palpate_calibration plain = palpate::plain_calibration();
  palpate_write_calibration(&plain, pages.data());
  while (!input.empty()) {
    const std::size_t at = input.byte() % pages.size();
    pages[at] = input.byte();
  }
  const auto calibration = palpate::read_calibration(pages);
  if (!calibration) return;
  palpate::validate(*calibration);
  insist(palpate::write_calibration(*calibration).size() == pages.size(),
         "a calibration that was read can be written");
  for (const std::uint16_t count : {0, 512, 1023}) {
    std::array<std::uint16_t, 6> counts;
    counts.fill(count);
    for (const double angle : palpate::compute_angles(*calibration, counts)) {
      insist(std::isfinite(angle), "an angle is finite");
    }
  }
  try {
    const palpate::SafetyLimits limits = palpate::find_safety_limits(*calibration);
    insist(limits.force_max >= 0.0, "what a device can bear is a force");
  } catch (const std::invalid_argument&) {
    // an arm that cannot push: refused in words
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  const std::uint8_t kind = input.byte();
  if (kind % 4 == 0) {
    read_pages(input);
  } else {
    run_session(input, kind % 4 != 1, kind % 4 == 3);
  }
  return 0;
}
