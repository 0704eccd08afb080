// SPDX-License-Identifier: BSD-3-Clause
// The fuzz harness of the device without a fuzzer: good sessions, wounded; the same on every run.
//
//     test_mutated_frames COUNT
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>

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
  const int inputs = count > 1 ? std::atoi(words[1]) : 2000;
  const Bytes session = record_session();
  for (int i = 0; i < inputs; ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    const Bytes input = i % 4 ? wound(random, session) : noise(random);
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  std::printf("%d inputs: each was obeyed or refused\n", inputs);
}
