// SPDX-License-Identifier: GPL-3.0-or-later
// Row 12 of the verification plan: a calibration survives the loss of power at any time.
#include <doctest/doctest.h>

#include "sim_bench.h"

using namespace palpate;

namespace {

std::vector<std::uint8_t> pages_of(std::uint32_t serial_number) {
  palpate_calibration calibration = plain_calibration();
  calibration.serial_number = serial_number;
  std::vector<std::uint8_t> pages(PALPATE_CALIBRATION_BYTES);
  palpate_write_calibration(&calibration, pages.data());
  return pages;
}

void begin_store(SimBench& bench, const std::vector<std::uint8_t>& pages) {
  bench.wait(5);
  bench.say(bench.host.hello());
  bench.wait(5);
  for (int p = 0; p < PALPATE_PAGES; ++p) {
    REQUIRE(bench.ask(bench.host.write_page(p, &pages[static_cast<std::size_t>(p) * 16])) ==
            PALPATE_DONE);
  }
  bench.say(bench.host.store(
      palpate_compute_crc(pages.data(), static_cast<std::uint16_t>(pages.size()))));
}

std::uint32_t serial_after_power_up(const std::array<std::uint8_t, 1024>& eeprom, int* fault) {
  SimBench bench;
  bench.chip = SimAvr(image(1000000), 1000000, eeprom);
  bench.wait(5);
  bench.say(bench.host.hello());
  bench.wait(5);
  *fault = bench.host.state.first_fault;
  return bench.host.info.serial_number;
}

}  // namespace

TEST_CASE(
    "the image of the chip: a stored calibration is answered, told, and there after power-up" *
    doctest::test_suite("landing")) {
  SimBench bench(1000000, false);
  begin_store(bench, pages_of(77));
  CHECK(bench.host.state.first_fault == PALPATE_FAULT_CALIBRATION);
  bench.wait(600);

  REQUIRE(bench.host.answers.size() == 1);
  CHECK(bench.host.answers.back().type == PALPATE_STORE);
  CHECK(bench.host.answers.back().result == PALPATE_DONE);
  CHECK((bench.host.state.faults & 1 << PALPATE_FAULT_OVERRUN) == 0);
  int fault = 0;
  CHECK(serial_after_power_up(bench.chip.eeprom(), &fault) == 77);
  CHECK(fault == PALPATE_FAULT_NONE);
}

TEST_CASE("the image of the chip: power lost while it stores leaves one calibration or the other") {
  SimBench bench;
  begin_store(bench, pages_of(88));
  int older = 0, newer = 0;
  for (int cut = 0; cut < 24 && newer < 2; ++cut) {
    bench.wait(19.7);
    int fault = 0;
    const std::uint32_t serial = serial_after_power_up(bench.chip.eeprom(), &fault);

    CHECK(fault == PALPATE_FAULT_NONE);
    CHECK((serial == 20261121 || serial == 88));
    ++(serial == 88 ? newer : older);
  }

  CHECK(older > 3);
  CHECK(newer > 0);
}
