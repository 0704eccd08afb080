// SPDX-License-Identifier: BSD-3-Clause
// The fuzz harness of the device without a fuzzer: good sessions, wounded; the same on every run.
//
//     test_mutated_frames COUNT
//     test_mutated_frames seed FILE      a short session for the fuzzer to begin with
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>

#include "../firmware/bench.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using palpate::Bytes;

void append(Bytes& stream, const Bytes& wire) {
  stream.insert(stream.end(), wire.begin(), wire.end());
}

/// A host that calibrates a blank device and then drives it, as one stream of bytes: a frame in
/// each millisecond of the harness, which takes forty bytes at a time.
Bytes record_session() {
  palpate::Bench bench(false);
  Bytes stream;
  const auto say = [&](const Bytes& wire) {
    Bytes padded = wire;
    padded.resize(40, 0);
    append(stream, padded);
    bench.say(wire);
    bench.wait();
  };
  say(bench.host.hello());
  std::uint8_t pages[PALPATE_CALIBRATION_BYTES];
  const palpate_calibration calibration = palpate::plain_calibration();
  palpate_write_calibration(&calibration, pages);
  for (int p = 0; p < PALPATE_PAGES; ++p) say(bench.host.write_page(p, pages + 16 * p));
  say(bench.host.store(palpate_compute_crc(pages, sizeof pages)));
  for (int ms = 0; ms < 520; ++ms) say(bench.host.read_page(ms % 8));
  say(bench.host.clear());
  for (int i = 0; i < 3; ++i) say(bench.host.command(0, 0, 0));
  say(bench.host.enable());
  if (!bench.board.enabled) {
    std::fprintf(stderr, "a good session does not enable the motors\n");
    std::abort();
  }
  for (int i = 0; i < 40; ++i) say(bench.host.command(1000 * i, -500 * i, 30));
  say(bench.host.disable());
  return stream;
}

/// A host that arms a device that was calibrated before: short enough for a fuzzer to play with.
Bytes record_short_session() {
  palpate::Bench bench(true);
  Bytes stream = {128};
  stream.resize(40, 0);
  bench.wait();
  const auto say = [&](Bytes wire) {
    bench.say(wire);
    bench.wait();
    wire.resize(40, 0);
    append(stream, wire);
  };
  say(bench.host.hello());
  say(bench.host.clear());
  for (int i = 0; i < 3; ++i) say(bench.host.command(0, 0, 0));
  say(bench.host.enable());
  if (!bench.board.enabled) {
    std::fprintf(stderr, "a short session does not enable the motors\n");
    std::abort();
  }
  for (int i = 0; i < 30; ++i) {
    palpate_command command{};
    command.has_law = i % 3 == 0;
    command.shift = 4;
    command.torque[0] = static_cast<std::int16_t>(1000 * i);
    command.stiffness[0] = 3000;
    say(bench.host.command(command));
  }
  say(bench.host.disable());
  return stream;
}

Bytes wound(std::mt19937& random, Bytes stream) {
  const int wounds = static_cast<int>(random() % 6);
  for (int i = 0; i < wounds; ++i) {
    const std::size_t at = random() % stream.size();
    const auto place = stream.begin() + static_cast<std::ptrdiff_t>(at);
    switch (random() % 4) {
      case 0:
        stream[at] ^= static_cast<std::uint8_t>(1u << random() % 8);
        break;
      case 1:
        stream[at] = static_cast<std::uint8_t>(random());
        break;
      case 2:
        stream.insert(place, 1 + random() % 60, static_cast<std::uint8_t>(random()));
        break;
      case 3:
        stream.erase(place, stream.begin() + static_cast<std::ptrdiff_t>(
                                                 std::min(stream.size() - 1, at + random() % 60)));
        break;
    }
  }
  return stream;
}

Bytes noise(std::mt19937& random) {
  Bytes stream(1 + random() % 4000);
  for (std::uint8_t& byte : stream) byte = static_cast<std::uint8_t>(random() % 6 ? random() : 0);
  return stream;
}

}  // namespace

int main(int count, char** words) {
  if (count > 2 && std::string(words[1]) == "seed") {
    const Bytes seed = record_short_session();
    std::ofstream file(words[2], std::ios::binary);
    file.write(reinterpret_cast<const char*>(seed.data()),
               static_cast<std::streamsize>(seed.size()));
    return file.good() ? 0 : 1;
  }
  const int inputs = count > 1 ? std::atoi(words[1]) : 2000;
  const Bytes sessions[] = {record_session(), record_short_session()};
  for (int i = 0; i < inputs; ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    const Bytes input = i % 4 ? wound(random, sessions[i % 2]) : noise(random);
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  std::printf("%d inputs: each was obeyed or refused\n", inputs);
}
