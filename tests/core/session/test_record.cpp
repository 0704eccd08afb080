// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "core/session/record_bytes.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/session/private/record_file.h"
#include "palpate/sim/session/record.h"

using namespace palpate;
using namespace palpate::record_layout;
using namespace palpate::testing;

TEST_CASE("a record comes back from its file bit by bit, deflated or not") {
  const Folder folder;
  for (const RecordCodec codec : kCodecs) {
    for (const int ticks : {0, 1, 249, 250, 251, 1777}) {
      Record record = some_record(ticks);

      write_record(folder.file("a.prec"), record, codec);
      const Record back = read_record(folder.file("a.prec"));

      CHECK(is_same(back, record));
      CHECK(back.complete);
      CHECK(back.header.starts_with(R"({"kernel":"reference","prec":{"version":1,"columns":)"));
    }
  }
}

TEST_CASE("a record of several instruments comes back from its file bit by bit, deflated or not") {
  const Folder folder;
  for (const RecordCodec codec : kCodecs) {
    for (const auto& [ticks, instruments] :
         {std::pair{0, 2}, {1, 2}, {250, 3}, {251, 2}, {777, kMostLoggedInstruments}}) {
      Record record = some_record(ticks, instruments);

      write_record(folder.file("a.prec"), record, codec);
      const Record back = read_record(folder.file("a.prec"));

      CHECK(is_same(back, record));
      CHECK(back.complete);
      CHECK(count_ticks(back) == static_cast<std::size_t>(ticks));
    }
  }
}

TEST_CASE("one instrument keeps the columns of version 1, and events of another body ask for 2") {
  const Folder folder;
  Record record = some_record(10);
  const std::vector<char> bytes = bytes_of(folder, record, RecordCodec::none);
  CHECK(bytes[8] == 1);
  record.events.push_back({6, EventKind::tree_exchanged, 2, 1.5, 1});

  const std::vector<char> wider = bytes_of(folder, record, RecordCodec::none);

  CHECK(wider[8] == 2);
  const auto back = read_back(folder, wider);
  REQUIRE(back);
  CHECK(is_same(*back, record));
  CHECK(back->header.find(R"("version":2,"instruments":1,"columns":{"ticks":[["time","f8"],)") !=
        std::string::npos);
}

TEST_CASE("numbers that are no ordinary numbers keep their bits") {
  const Folder folder;
  Record record = some_record(5);
  record.hand[0].velocity.x() = -0.0;
  record.hand[1].velocity.x() = std::numeric_limits<double>::denorm_min();
  record.hand[2].velocity.x() = std::numeric_limits<double>::max();
  record.hand[3].velocity.x() = -std::numeric_limits<double>::infinity();
  record.felt[4].force.x() = std::numeric_limits<float>::quiet_NaN();

  for (const RecordCodec codec : kCodecs) {
    write_record(folder.file("a.prec"), record, codec);
    CHECK(is_same(read_record(folder.file("a.prec")), record));
  }
}

TEST_CASE("writing what was read gives the same file") {
  const Folder folder;
  write_record(folder.file("a.prec"), some_record(600));

  write_record(folder.file("b.prec"), read_record(folder.file("a.prec")));

  CHECK(read_bytes(folder.file("a.prec")) == read_bytes(folder.file("b.prec")));
}

TEST_CASE("deflating makes a smooth hand's record smaller") {
  const Folder folder;
  const Record record = some_record(2000);

  CHECK(bytes_of(folder, record, RecordCodec::deflate).size() <
        0.7 * static_cast<double>(bytes_of(folder, record, RecordCodec::none).size()));
}

TEST_CASE("ticks lost from a record keep the numbers of the others") {
  const Folder folder;
  Record record = some_record(600);
  record.events = {{100, EventKind::record_gap, 40, 0.0},
                   {150, EventKind::missed_ticks, 3, 0.0},
                   {400, EventKind::record_gap, 7, 0.0}};

  const std::vector<char> bytes = bytes_of(folder, record, RecordCodec::none);
  const auto back = read_back(folder, bytes);

  REQUIRE(back);
  CHECK(is_same(*back, record));
  std::vector<std::int64_t> first_ticks;
  for (std::size_t at = 0; at + 4 < bytes.size(); ++at) {
    if (std::memcmp(&bytes[at], "TICK", 4) != 0) continue;
    std::int64_t first = 0;
    std::memcpy(&first, &bytes[at + 8], 8);
    first_ticks.push_back(first);
  }
  CHECK(first_ticks == std::vector<std::int64_t>{0, 100, 350, 400});
}

TEST_CASE("the bytes of a file are where RECORD.md says") {
  const Folder folder;
  const Record record = some_record(6);
  const std::vector<char> bytes = bytes_of(folder, record, RecordCodec::none);
  const auto number = [&]<class T>(std::size_t at, T) {
    T value;
    std::memcpy(&value, &bytes[at], sizeof value);
    return value;
  };

  CHECK(std::memcmp(bytes.data(), "\x89PREC\r\n\x1a", 8) == 0);
  CHECK(number(8, std::uint32_t{}) == 1);
  const std::size_t block = 16 + number(12, std::uint32_t{}) + 4;
  CHECK(std::memcmp(&bytes[block], "TICK", 4) == 0);
  CHECK(number(block + 4, std::uint32_t{}) == 0);         // codec
  CHECK(number(block + 8, std::int64_t{}) == 0);          // first tick
  CHECK(number(block + 16, std::uint32_t{}) == 6);        // count
  CHECK(number(block + 20, std::uint32_t{}) == 6 * 124);  // length
  const std::size_t body = block + 28;
  CHECK(number(body + 5 * 8, 0.0) == record.hand[5].time);
  CHECK(number(body + (3 * 6 + 2) * 8, 0.0) == record.hand[2].position.z());
  CHECK(number(body + (7 * 6 + 1) * 8, 0.0) == record.hand[1].orientation.w());
  CHECK(number(body + (11 * 6 + 4) * 8, 0.0) == record.hand[4].grip);
  CHECK(number(body + 12 * 6 * 8 + 6, 0.0f) == record.felt[0].force.x());
  CHECK(number(body + 6 * 122 + 2 * 3, std::uint16_t{}) == record.felt[3].lateness_us);
  const std::size_t events = body + 6 * 124;
  CHECK(std::memcmp(&bytes[events], "HAPP", 4) == 0);
  CHECK(number(events + 28, std::int64_t{}) == 3);
  CHECK(number(events + 28 + 16 + 4, std::int32_t{}) == 6);  // kind of the second
  const std::size_t summary = bytes.size() - kSummaryBlock;
  CHECK(std::memcmp(&bytes[summary], "SUMM", 4) == 0);
  CHECK(number(summary + 28, std::uint64_t{}) == 6);
}

TEST_CASE("the bytes of a file of two instruments are where RECORD.md says") {
  const Folder folder;
  const Record record = some_record(6, 2);
  const std::vector<char> bytes = bytes_of(folder, record, RecordCodec::none);
  const auto number = [&]<class T>(std::size_t at, T) {
    T value;
    std::memcpy(&value, &bytes[at], sizeof value);
    return value;
  };

  CHECK(number(8, std::uint32_t{}) == 2);
  CHECK(number(16, std::uint32_t{}) == 2);  // instruments
  const std::size_t block = 20 + number(12, std::uint32_t{}) + 4;
  CHECK(std::memcmp(&bytes[block], "TICK", 4) == 0);
  CHECK(number(block + 16, std::uint32_t{}) == 6);            // count
  CHECK(number(block + 20, std::uint32_t{}) == 6 * 2 * 124);  // length
  const std::size_t body = block + 28, second = body + 6 * 124;
  CHECK(number(body + 5 * 8, 0.0) == record.hand[10].time);
  CHECK(number(second + 5 * 8, 0.0) == record.hand[11].time);
  CHECK(number(second + 12 * 6 * 8 + 6, 0.0f) == record.felt[1].force.x());
  const std::size_t events = second + 6 * 124;
  CHECK(std::memcmp(&bytes[events], "HAPP", 4) == 0);
  CHECK(number(events + 20, std::uint32_t{}) == 2 * 28);
  CHECK(number(events + 28 + 2 * 24, std::int32_t{}) == 1);  // source of the first
  CHECK(std::string(bytes.begin(), bytes.end()).find(R"(["1.force_x","f4"])") != std::string::npos);
}

TEST_CASE("a number of instruments that no record has is refused") {
  const Folder folder;
  for (const int count : {0, kMostLoggedInstruments + 1, 255}) {
    std::vector<char> bytes = bytes_of(folder, some_record(8, 2), RecordCodec::none);
    bytes[16] = static_cast<char>(count);
    const std::size_t end = 20 + unpack_u32(as_bytes(bytes).subspan(12, 4));
    const Bytes crc = pack_u32(compute_crc(as_bytes(bytes).first(end)));
    std::copy(crc.begin(), crc.end(), bytes.begin() + static_cast<std::ptrdiff_t>(end));

    CHECK(refusal(folder, bytes)
              .find("header: instruments: got " + std::to_string(count) + ", expected 1 to 16") !=
          std::string::npos);
  }
}

TEST_CASE("an event of a body or an instrument below the first is refused") {
  const Folder folder;
  Record record = some_record(8, 2);
  record.events[0].source = -1;
  CHECK(refusal(folder, bytes_of(folder, record, RecordCodec::none)).find("source: got -1") !=
        std::string::npos);
}

TEST_CASE("rows that do not make whole ticks are refused before anything is written") {
  const Folder folder;
  Record record = some_record(3, 2), none = some_record(3);
  record.hand.pop_back();
  record.felt.pop_back();
  none.instruments = 0;

  CHECK_THROWS_WITH_AS(write_record(folder.file("a.prec"), record),
                       "record: hand: got 5 samples, expected a multiple of 2, one for each "
                       "instrument in every tick",
                       std::invalid_argument);
  CHECK_THROWS_AS(write_record(folder.file("a.prec"), none), std::invalid_argument);
  CHECK_THROWS_AS(Recorder(folder.file("a.prec"), "{}", RecordCodec::none, 0),
                  std::invalid_argument);
  CHECK_THROWS_AS(Recorder(folder.file("a.prec"), "{}", RecordCodec::none, 1, 0),
                  std::invalid_argument);
  CHECK(std::filesystem::is_empty(folder.path));
}

TEST_CASE("a newer version is refused with a sentence that says so") {
  const Folder folder;
  std::vector<char> bytes = bytes_of(folder, some_record(8), RecordCodec::none);
  bytes[8] = 3;

  const std::string text = refusal(folder, bytes);

  CHECK(text.find("version: got 3, expected 1 or 2") != std::string::npos);
  CHECK(text.find("newer") != std::string::npos);
}

TEST_CASE("what is not a record is refused") {
  const Folder folder;
  write_bytes(folder.file("text.prec"), {'h', 'e', 'l', 'l', 'o'});
  write_bytes(folder.file("long.prec"), std::vector<char>(100, 'x'));
  ::mkfifo(folder.file("pipe.prec").c_str(), 0600);

  CHECK_THROWS_AS(read_record(folder.file("text.prec")), FileError);
  CHECK_THROWS_AS(read_record(folder.file("long.prec")), FileError);
  CHECK_THROWS_AS(read_record(folder.file("pipe.prec")), FileError);
  CHECK_THROWS_AS(read_record(folder.file("missing.prec")), FileError);
  CHECK_THROWS_AS(read_record(folder.path.string()), FileError);
}

TEST_CASE("a header that is not a JSON object is refused before anything is written") {
  const Folder folder;
  Record record = some_record(3);
  record.header = "{\"a\":";

  CHECK_THROWS_AS(write_record(folder.file("a.prec"), record), std::invalid_argument);
  CHECK_THROWS_AS(Recorder(folder.file("a.prec"), "[]"), std::invalid_argument);
  CHECK(std::filesystem::is_empty(folder.path));
}

TEST_CASE("a record that cannot be written leaves the one that was there") {
  const Folder folder;
  write_record(folder.file("a.prec"), some_record(3));
  Record uneven = some_record(4);
  uneven.felt.pop_back();

  CHECK_THROWS_AS(write_record(folder.file("a.prec"), uneven), std::invalid_argument);
  CHECK_THROWS_AS(write_record(folder.file("no/such/folder.prec"), some_record(3)), FileError);

  CHECK(read_record(folder.file("a.prec")).hand.size() == 3);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 1);
}
