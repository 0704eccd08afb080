// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "core/session/some_record.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/session/private/record_file.h"
#include "palpate/sim/session/record.h"

using namespace palpate;
using namespace palpate::record_layout;
using namespace palpate::testing;

namespace {

constexpr RecordCodec kCodecs[] = {RecordCodec::none, RecordCodec::deflate};

/// The bytes of `record` as a file.
std::vector<char> bytes_of(const Folder& folder, const Record& record, RecordCodec codec) {
  write_record(folder.file("whole.prec"), record, codec);
  return read_bytes(folder.file("whole.prec"));
}

/// What the reader makes of these bytes; none if it refuses them.
std::optional<Record> read_back(const Folder& folder, const std::vector<char>& bytes) {
  write_bytes(folder.file("other.prec"), bytes);
  try {
    return read_record(folder.file("other.prec"));
  } catch (const FileError&) {
    return std::nullopt;
  }
}

std::string refusal(const Folder& folder, const std::vector<char>& bytes) {
  write_bytes(folder.file("other.prec"), bytes);
  try {
    read_record(folder.file("other.prec"));
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

constexpr std::size_t kSummaryBlock = 84;

std::span<const std::uint8_t> as_bytes(const std::vector<char>& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

}  // namespace

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

TEST_CASE("a file cut off anywhere is a readable beginning or refused, never something else") {
  const Folder folder;
  for (const auto& [codec, ticks, instruments] : {std::tuple{RecordCodec::none, 10, 1},
                                                  {RecordCodec::none, 6, 3},
                                                  {RecordCodec::deflate, 260, 1}}) {
    const Record record = some_record(ticks, instruments);
    const std::vector<char> bytes = bytes_of(folder, record, codec);
    std::size_t most = 0;

    for (std::size_t size = 0; size < bytes.size(); ++size) {
      const auto back = read_back(folder, {bytes.begin(), bytes.begin() + std::ptrdiff_t(size)});
      if (!back) {
        // only what is no record yet: the header is cut
        REQUIRE(most == 0);
        continue;
      }
      REQUIRE(is_prefix(*back, record));
      REQUIRE_FALSE(back->complete);
      REQUIRE(count_ticks(*back) >= most);
      most = count_ticks(*back);
    }
    CHECK(most == static_cast<std::size_t>(ticks));
  }
}

TEST_CASE("a flipped bit in any byte of a finished file is refused and its block named") {
  const Folder folder;
  for (const auto& [codec, instruments] :
       {std::pair{RecordCodec::none, 1}, {RecordCodec::deflate, 1}, {RecordCodec::deflate, 2}}) {
    const std::vector<char> bytes = bytes_of(folder, some_record(8, instruments), codec);

    for (std::size_t at = 0; at < bytes.size(); ++at) {
      std::vector<char> damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at * 5 + at / 8) % 8));
      const std::string text = refusal(folder, damaged);
      REQUIRE_MESSAGE(!text.empty(), at);
      const bool named = text.find("header") != std::string::npos ||
                         text.find("block") != std::string::npos ||
                         text.find("summary") != std::string::npos;
      REQUIRE_MESSAGE(named, text);
    }
  }
}

TEST_CASE("an unfinished file ends before a flipped bit") {
  const Folder folder;
  const Record record = some_record(520);
  for (const RecordCodec codec : kCodecs) {
    std::vector<char> bytes = bytes_of(folder, record, codec);
    bytes.resize(bytes.size() - kSummaryBlock);

    for (std::size_t at = 0; at < bytes.size(); at += 13) {
      std::vector<char> damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
      const auto back = read_back(folder, damaged);
      if (!back) continue;
      REQUIRE(is_prefix(*back, record));
      REQUIRE(back->hashes.empty());  // the last block: whatever was flipped comes before it
    }
  }
}

TEST_CASE("a block that was swapped for another whole one does not pass the SHA-256") {
  const Folder folder;
  Record other = some_record(8);
  other.hand[3].position.x() += 1e-9;
  const std::vector<char> bytes = bytes_of(folder, some_record(8), RecordCodec::none);
  std::vector<char> forged = bytes_of(folder, other, RecordCodec::none);
  std::copy(bytes.end() - kSummaryBlock, bytes.end(), forged.end() - kSummaryBlock);

  CHECK(refusal(folder, forged).find("SHA-256") != std::string::npos);
}

TEST_CASE("bytes after the summary are refused") {
  const Folder folder;
  std::vector<char> bytes = bytes_of(folder, some_record(8), RecordCodec::deflate);
  bytes.push_back('x');

  CHECK(refusal(folder, bytes).find("summary") != std::string::npos);
}

TEST_CASE("zeros that a crash left after the last block are not a damaged summary") {
  const Folder folder;
  const Record record = some_record(8);
  std::vector<char> bytes = bytes_of(folder, record, RecordCodec::deflate);
  std::fill(bytes.end() - kSummaryBlock, bytes.end(), '\0');

  const auto back = read_back(folder, bytes);

  REQUIRE(back);
  CHECK(is_same(*back, record));
  CHECK_FALSE(back->complete);
}

// 1.1 MB of such blocks would be the 8.4 million rows that a file may have, and 1.2 GB of memory.
TEST_CASE("a summary of which the disk kept some bytes and not others cuts the record off") {
  const Folder folder;
  const Record record = some_record(8);
  const std::vector<char> whole = bytes_of(folder, record, RecordCodec::deflate);
  for (std::size_t first = 0; first < kSummaryBlock; ++first) {
    for (std::size_t last = first + 2; last <= kSummaryBlock; ++last) {
      std::vector<char> bytes = whole;
      const auto at = [&bytes](std::size_t i) {
        return bytes.end() - static_cast<std::ptrdiff_t>(kSummaryBlock - i);
      };
      const long lost = std::count_if(at(first), at(last), [](char byte) { return byte != 0; });
      std::fill(at(first), at(last), '\0');
      if (lost == 1) continue;  // it may as well be a bit that was turned

      const auto back = read_back(folder, bytes);

      REQUIRE(back);
      CHECK(is_same(*back, record));
      CHECK(back->complete == (lost == 0));
    }
  }
}

TEST_CASE("blocks that unpack to more than any writer makes are refused before they are unpacked") {
  const Folder folder;
  const std::vector<char> good = bytes_of(folder, some_record(8), RecordCodec::deflate);
  const std::size_t begin = kPreambleBytes + unpack_u32(as_bytes(good).subspan(12, 4)) + 4;
  Bytes zeros = deflate(Bytes(kMostBlockRows * row_bytes(BlockKind::ticks)));
  zeros.resize(zeros.size() / 2);  // level 9 would be as short; this is no whole stream any more
  const Bytes noise(zeros.size(), 0x5a);
  for (const Bytes& body : {zeros, noise}) {
    BlockHeader header{.codec = 1, .count = kMostBlockRows};
    header.length = static_cast<std::uint32_t>(body.size());
    std::vector<char> bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(begin));
    for (int block = 0; block < 2048; ++block) {
      header.first_tick = block * std::int64_t(kMostBlockRows);
      header.crc = compute_crc(header, body);
      const auto packed = pack_block_header(header);
      bytes.insert(bytes.end(), packed.begin(), packed.end());
      bytes.insert(bytes.end(), body.begin(), body.end());
    }

    const std::string text = refusal(folder, bytes);

    // a stream that is none, but nothing has checked: of the first block, and of no other
    CHECK(text.find("block 0 at byte") != std::string::npos);
    CHECK(text.find("expected at least a 256th") != std::string::npos);
  }
}

TEST_CASE("the most compressible record that can be written is read") {
  const Folder folder;
  Record record = some_record(1);
  record.hand.resize(20000, record.hand[0]);
  record.felt.resize(20000, record.felt[0]);
  const std::vector<char> bytes = bytes_of(folder, record, RecordCodec::deflate);

  const auto back = read_back(folder, bytes);

  REQUIRE(back);
  CHECK(is_same(*back, record));
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
