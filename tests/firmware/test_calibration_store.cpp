// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cstring>

#include "bench.h"

using namespace palpate;

namespace {

Bytes pages_of(std::uint32_t serial_number) {
  palpate_calibration calibration = plain_calibration();
  calibration.serial_number = serial_number;
  Bytes pages(PALPATE_CALIBRATION_BYTES);
  palpate_write_calibration(&calibration, pages.data());
  return pages;
}

std::uint16_t crc_of(const Bytes& pages) {
  return palpate_compute_crc(pages.data(), static_cast<std::uint16_t>(pages.size()));
}

void write_pages(Bench& bench, const Bytes& pages) {
  for (int p = 0; p < PALPATE_PAGES; ++p) {
    REQUIRE(bench.ask(bench.host.write_page(p, &pages[static_cast<std::size_t>(p) * 16])) ==
            PALPATE_DONE);
  }
}

/// STORE and the time it takes: 120 bytes of 4 ms.
int store(Bench& bench, const Bytes& pages) {
  write_pages(bench, pages);
  bench.say(bench.host.store(crc_of(pages)));
  bench.wait(600);
  return bench.result();
}

std::uint32_t serial_after_reset(const std::uint8_t* eeprom) {
  palpate_board board;
  palpate_board_init(&board, eeprom);
  return board.device.calibrated ? board.device.serial_number : 0;
}

}  // namespace

TEST_CASE("a stored calibration is there after a reset, and CLEAR then frees the torque") {
  Bench bench(false);
  bench.say(bench.host.hello());
  bench.wait();

  REQUIRE(store(bench, pages_of(41)) == PALPATE_DONE);

  CHECK(serial_after_reset(bench.board.eeprom) == 41);
  CHECK(bench.ask(bench.host.clear()) == PALPATE_DONE);
}

TEST_CASE("pages read back as they were written") {
  Bench bench;
  bench.say(bench.host.hello());
  bench.wait();
  const Bytes pages = pages_of(20261121);
  for (int p = 0; p < PALPATE_PAGES; ++p) {
    bench.say(bench.host.read_page(p));
    bench.wait();
    REQUIRE(!bench.host.pages.empty());
    CHECK(bench.host.pages.back().page == p);
    CHECK(std::memcmp(bench.host.pages.back().bytes, &pages[static_cast<std::size_t>(p) * 16],
                      16) == 0);
  }
  CHECK(bench.ask(bench.host.read_page(PALPATE_PAGES)) == PALPATE_NO_SUCH_PAGE);
}

TEST_CASE("power lost at any byte of a write leaves the calibration before or the one after") {
  for (std::uint32_t older : {1u, 2u}) {
    int survived = 0;
    long strength = 0;
    for (; strength < 200; ++strength) {
      Bench bench(false);
      bench.say(bench.host.hello());
      bench.wait();
      for (std::uint32_t serial = 1; serial <= older; ++serial) {
        REQUIRE(store(bench, pages_of(serial)) == PALPATE_DONE);
      }
      write_pages(bench, pages_of(99));
      bench.board.eeprom_strength = strength;
      bench.say(bench.host.store(crc_of(pages_of(99))));
      bench.wait(600);

      const std::uint32_t serial = serial_after_reset(bench.board.eeprom);
      REQUIRE((serial == older || serial == 99));
      survived += serial == older;
      if (serial == 99) break;
    }
    CHECK(survived > 3);
    CHECK(strength < 200);
  }
}

TEST_CASE("a byte that does not keep is told") {
  Bench bench;
  bench.say(bench.host.hello());
  bench.wait();
  write_pages(bench, pages_of(5));
  bench.board.eeprom_strength = 10;
  bench.say(bench.host.store(crc_of(pages_of(5))));
  bench.wait(600);

  CHECK(bench.result() == PALPATE_EEPROM_FAILED);
}

TEST_CASE("STORE refuses pages with another CRC, without sense, or while torque is on") {
  Bench bench;
  bench.say(bench.host.hello());
  bench.wait();
  Bytes pages = pages_of(6);
  write_pages(bench, pages);
  CHECK(bench.ask(bench.host.store(static_cast<std::uint16_t>(crc_of(pages) + 1))) ==
        PALPATE_BAD_CALIBRATION);
  pages[0] = 77;  // a version nobody knows
  write_pages(bench, pages);
  CHECK(bench.ask(bench.host.store(crc_of(pages))) == PALPATE_BAD_CALIBRATION);

  bench.power_up();
  CHECK(bench.ask(bench.host.store(crc_of(pages))) == PALPATE_WRONG_MODE);
  CHECK(bench.ask(bench.host.write_page(0, pages.data())) == PALPATE_WRONG_MODE);
}

TEST_CASE("while the EEPROM is written there is no second write and no torque") {
  Bench bench;
  bench.say(bench.host.hello());
  bench.wait();
  const Bytes pages = pages_of(7);
  write_pages(bench, pages);
  bench.say(bench.host.store(crc_of(pages)));
  bench.drive(3, 0, 0, 0);

  CHECK(bench.ask(bench.host.enable()) == PALPATE_BUSY);
  CHECK(bench.ask(bench.host.store(crc_of(pages))) == PALPATE_BUSY);
  CHECK(bench.ask(bench.host.write_page(0, pages.data())) == PALPATE_BUSY);
}

TEST_CASE(
    "a newest copy spoiled in one bit is told and takes the torque; the older one is not obeyed") {
  Bench bench;
  bench.say(bench.host.hello());
  bench.wait();
  REQUIRE(store(bench, pages_of(8)) == PALPATE_DONE);
  constexpr int kNewest = 0, kOlder = 512;
  for (int byte = 0; byte < 118; ++byte) {
    Bench spoiled;
    std::memcpy(spoiled.board.eeprom, bench.board.eeprom, PALPATE_EEPROM_BYTES);
    spoiled.board.eeprom[kNewest + byte] ^= 4;
    palpate_board_reset(&spoiled.board, 1);
    spoiled.say(spoiled.host.hello());
    spoiled.wait();

    CHECK((spoiled.host.info.features & PALPATE_FEATURE_DAMAGED) != 0);
    CHECK(spoiled.host.info.calibration_crc == 0);
    CHECK(spoiled.host.state.first_fault == PALPATE_FAULT_CALIBRATION);
    CHECK(spoiled.ask(spoiled.host.clear()) == PALPATE_CAUSE_REMAINS);
  }
  for (int byte = 0; byte < 118; ++byte) {
    std::uint8_t eeprom[PALPATE_EEPROM_BYTES];
    std::memcpy(eeprom, bench.board.eeprom, sizeof eeprom);
    eeprom[kOlder + byte] ^= 4;
    // its sequence says which it is: without it nobody knows
    CHECK(serial_after_reset(eeprom) == (byte == 2 || byte == 3 ? 0 : 8));
  }
}

TEST_CASE("the older copy can be read where the newest is damaged, and stored again to go on") {
  Bench bench;
  bench.say(bench.host.hello());
  bench.wait();
  const Bytes older = pages_of(20261121);
  REQUIRE(store(bench, pages_of(8)) == PALPATE_DONE);
  bench.board.eeprom[50] ^= 1;
  palpate_board_reset(&bench.board, 1);
  bench.say(bench.host.hello());
  bench.wait();
  for (int p = 0; p < PALPATE_PAGES; ++p) {
    bench.say(bench.host.read_page(p));
    bench.wait();
    REQUIRE(!bench.host.pages.empty());
    CHECK(std::memcmp(bench.host.pages.back().bytes, &older[static_cast<std::size_t>(p) * 16],
                      16) == 0);
  }

  bench.say(bench.host.store(crc_of(older)));
  bench.wait(600);
  CHECK(bench.result() == PALPATE_DONE);
  CHECK(bench.ask(bench.host.clear()) == PALPATE_DONE);
  CHECK(serial_after_reset(bench.board.eeprom) == 20261121);
}
