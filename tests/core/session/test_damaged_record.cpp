// SPDX-License-Identifier: BSD-3-Clause
// Records that were cut off, changed or made to break a reader.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "core/session/record_bytes.h"
#include "palpate/sim/session/private/record_file.h"

using namespace palpate;
using namespace palpate::record_layout;
using namespace palpate::testing;

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

// 1.1 MB of such blocks would be the 8.4 million rows that a file may have, and 1.2 GB of memory.
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
