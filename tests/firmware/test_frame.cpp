// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <utility>

#include "host_of_device.h"

using namespace palpate;

namespace {

struct Heard {
  std::vector<Bytes> frames;
  int damaged = 0;
};

Heard listen(const Bytes& wire, palpate_decoder* decoder) {
  Heard heard;
  for (std::uint8_t byte : wire) {
    const palpate_decoded decoded = palpate_decode_byte(decoder, byte);
    heard.damaged += decoded == PALPATE_DAMAGED;
    if (decoded == PALPATE_FRAME) {
      heard.frames.emplace_back(decoder->body, decoder->body + decoder->count);
    }
  }
  return heard;
}

Heard listen(const Bytes& wire) {
  palpate_decoder decoder;
  palpate_start_decoder(&decoder);
  return listen(wire, &decoder);
}

Bytes random_body(std::mt19937& random) {
  Bytes body(1 + random() % PALPATE_BODY_MAX);
  // many zeros: they are what the stuffing is about
  for (std::uint8_t& byte : body) byte = random() % 3 ? static_cast<std::uint8_t>(random()) : 0;
  return body;
}

}  // namespace

TEST_CASE("the CRC of 123456789 is the catalogue's check value of MCRF4XX") {
  const Bytes digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};

  CHECK(palpate_compute_crc(digits.data(), 9) == 0x6f91);
}

TEST_CASE("a body is framed byte for byte as PROTOCOL.md shows it") {
  // DISABLE with seq 0: type, seq, CRC low, CRC high
  const Bytes body{PALPATE_DISABLE, 0};
  const std::uint16_t crc = palpate_compute_crc(body.data(), 2);
  REQUIRE(crc == 0xbdb0);

  CHECK(encode(body) == Bytes{2, 0x07, 3, 0xb0, 0xbd, 0});
}

TEST_CASE("any body of any length comes back as it was sent, in one frame with one zero") {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Bytes body = random_body(random);
    const Bytes wire = encode(body);

    const Heard heard = listen(wire);

    REQUIRE(wire.size() == body.size() + 4);
    REQUIRE(std::count(wire.begin(), wire.end(), 0) == 1);
    REQUIRE(heard.frames == std::vector<Bytes>{body});
    REQUIRE(heard.damaged == 0);
  }
}

TEST_CASE("a frame with any one bit flipped is never taken, and the one after the next is") {
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    const Bytes body = random_body(random);
    const Bytes wire = encode(body);
    const Bytes next = encode({1, 2, 3});
    const Bytes last = encode({4, 5, 6});
    for (std::size_t bit = 0; bit < 8 * wire.size(); ++bit) {
      Bytes wounded = wire;
      wounded[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
      // a wounded delimiter joins two frames, and both are lost
      wounded.insert(wounded.end(), next.begin(), next.end());
      wounded.insert(wounded.end(), last.begin(), last.end());

      const Heard heard = listen(wounded);

      REQUIRE(!heard.frames.empty());
      REQUIRE(heard.frames.back() == Bytes{4, 5, 6});
      for (const Bytes& frame : heard.frames) REQUIRE(frame != body);
      REQUIRE(heard.frames.size() <= 2);
      REQUIRE(heard.damaged >= 1);
    }
  }
}

TEST_CASE("what the CRC cannot see, a zero after it, the length of a message shows") {
  palpate_command command{};
  Bytes body(PALPATE_BODY_MAX);
  body.resize(palpate_write_command(&command, body.data()));
  Bytes wire = encode(body);
  wire.back() = 1;  // the delimiter wounded into the code of one more zero
  wire.push_back(0);

  const Heard heard = listen(wire);

  REQUIRE(heard.frames.size() == 1);
  const Bytes& grown = heard.frames[0];
  CHECK_FALSE(
      palpate_read_command(grown.data(), static_cast<std::uint8_t>(grown.size()), &command));
}

TEST_CASE("after a start in the middle of a frame the next whole one is found") {
  const Bytes body{1, 0, 2, 0, 3};
  const Bytes whole = encode(body);
  for (std::size_t lost = 1; lost < whole.size(); ++lost) {
    Bytes wire(whole.begin() + static_cast<std::ptrdiff_t>(lost), whole.end());
    wire.insert(wire.end(), whole.begin(), whole.end());
    palpate_decoder decoder;
    palpate_skip_to_delimiter(&decoder);

    const Heard heard = listen(wire, &decoder);

    CHECK(heard.frames == std::vector<Bytes>{body});
  }
}

TEST_CASE("a frame longer than any is damaged, and silence between frames is not") {
  Bytes endless(PALPATE_WIRE_MAX + 50, 1);
  endless.push_back(0);
  const Bytes after = encode({9, 9});
  endless.insert(endless.end(), 5, 0);
  endless.insert(endless.end(), after.begin(), after.end());

  const Heard heard = listen(endless);

  CHECK(heard.damaged == 1);
  CHECK(heard.frames == std::vector<Bytes>{Bytes{9, 9}});
}

TEST_CASE("a CRC alone is not a frame") {
  // two bytes whose CRC over nothing is right: 0xffff
  const Heard heard = listen({3, 0xff, 0xff, 0});

  CHECK(heard.frames.empty());
  CHECK(heard.damaged == 1);
}
