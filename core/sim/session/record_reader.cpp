// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>

#include <algorithm>

#include "palpate/sim/session/private/json_object.h"
#include "palpate/sim/session/private/record_file.h"

namespace palpate {
namespace {

using namespace record_layout;

/// What a block unpacks to is at most so many times what it takes in the file. The writer's level 1
/// makes 225 of zeros alone.
constexpr std::size_t kMostRatio = 256;

constexpr std::uint64_t kSummaryBlockBytes = kBlockHeaderBytes + kSummaryBytes;

/// Room for any body there can be: a deflated one is at most a little longer than a plain one.
std::uint32_t most_body_bytes(BlockKind kind, const Layout& layout) {
  if (kind == BlockKind::summary) return kSummaryBytes;
  const auto plain = static_cast<std::uint32_t>(kMostBlockRows * row_bytes(kind, layout));
  return plain + plain / 1000 + 64;
}

std::string to_hexadecimal(std::span<const std::uint8_t> bytes) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

std::string to_hexadecimal(std::uint32_t word) {
  Bytes bytes = pack_u32(word);
  std::reverse(bytes.begin(), bytes.end());
  return to_hexadecimal(bytes);
}

/// Why the bytes at some place are not a whole block.
struct Damage {
  std::string found, expected;
};

/// Reads one file from front to back.
class Reader {
 public:
  explicit Reader(const std::string& path)
      : file_(path, O_RDONLY | O_NONBLOCK), size_(file_.size()) {}

  Record read() {
    read_header();
    end_ = ends_with_summary() ? size_ - kSummaryBlockBytes : size_;
    const bool finished = end_ < size_;
    while (at_ < end_) {
      const std::optional<Damage> damage = read_block();
      if (!damage) continue;
      if (finished) file_.refuse(where(), damage->found, damage->expected);
      refuse_damaged_summary(*damage);
      break;
    }
    if (finished) check_summary();
    finish(finished);
    return std::move(record_);
  }

 private:
  void read_header();
  void read_version(const Bytes& preamble);
  void read_instruments(const Bytes& header);
  bool ends_with_summary() const;
  std::optional<Damage> read_block();
  void unpack_block(const BlockHeader& header, const Bytes& stored);
  Bytes unpack_body(const BlockHeader& header, const Bytes& stored) const;
  void take_ticks(const BlockHeader& header, const Bytes& body);
  void refuse_damaged_summary(const Damage& damage);
  bool is_torn_summary(std::span<const std::uint8_t> tail);
  void check_summary();
  void finish(bool finished);

  std::size_t count_ticks() const noexcept {
    return record_.hand.size() / static_cast<std::size_t>(layout_.instruments);
  }
  std::string where() const {
    return "block " + std::to_string(block_) + " at byte " + std::to_string(at_);
  }

  File file_;
  const std::uint64_t size_;
  std::uint64_t at_ = 0, end_ = 0;
  long block_ = 0;
  Sha256 sha256_;
  Layout layout_;
  Record record_;
  std::vector<TickLog::Tick> rows_;  // of one block
  std::int64_t next_tick_ = 0;
};

void Reader::read_header() {
  if (size_ < kPreambleBytes) {
    file_.refuse("header", std::to_string(size_) + " bytes", "a record of at least 20");
  }
  const Bytes preamble = file_.read(0, kPreambleBytes);
  if (!std::equal(kMagic.begin(), kMagic.end(), preamble.begin())) {
    file_.refuse("header: magic", to_hexadecimal(std::span(preamble).first(kMagic.size())),
                 to_hexadecimal(kMagic) + " of a palpate record");
  }
  read_version(preamble);
  const std::size_t begin = preamble_bytes(layout_.version);
  const std::uint32_t length = unpack_u32(std::span(preamble).subspan(12));
  if (length > kMostHeaderBytes || begin + length + 4 > size_) {
    file_.refuse("header: JSON length", std::to_string(length),
                 "at most 1 MiB and no more than the file holds");
  }
  const Bytes header = file_.read(0, begin + length + 4);
  const auto checked = std::span(header).first(begin + length);
  const std::uint32_t found = compute_crc(checked);
  const std::uint32_t expected = unpack_u32(std::span(header).last(4));
  if (found != expected) {
    file_.refuse("header: CRC32", to_hexadecimal(found), to_hexadecimal(expected));
  }
  record_.header.assign(header.begin() + static_cast<std::ptrdiff_t>(begin), header.end() - 4);
  read_instruments(header);
  if (const auto problem = find_json_problem(record_.header)) {
    file_.refuse("header: JSON", "text that is not a JSON object", *problem);
  }
  sha256_.add(header);
  at_ = header.size();
}

void Reader::read_version(const Bytes& preamble) {
  layout_.version = unpack_u32(std::span(preamble).subspan(8));
  if (layout_.version >= 1 && layout_.version <= kNewestVersion) return;
  file_.refuse("header: version", std::to_string(layout_.version),
               "1 or 2: this palpate reads no other, a newer one may");
}

void Reader::read_instruments(const Bytes& header) {
  if (layout_.version == 1) return;
  const std::uint32_t found = unpack_u32(std::span(header).subspan(kPreambleBytes));
  if (found < 1 || found > static_cast<std::uint32_t>(kMostLoggedInstruments)) {
    file_.refuse("header: instruments", std::to_string(found),
                 "1 to " + std::to_string(kMostLoggedInstruments));
  }
  layout_.instruments = static_cast<int>(found);
  record_.instruments = layout_.instruments;
}

/// Whether this is a finished file: its last bytes are a whole summary.
bool Reader::ends_with_summary() const {
  if (size_ < at_ + kSummaryBlockBytes) return false;
  const Bytes tail = file_.read(size_ - kSummaryBlockBytes, kSummaryBlockBytes);
  const auto header = unpack_block_header(tail);
  return header && header->kind == BlockKind::summary && header->length == kSummaryBytes &&
         header->crc == compute_crc(*header, std::span(tail).subspan(kBlockHeaderBytes));
}

/// Takes in one block, or says what keeps the bytes here from being one. A block whose CRC holds
/// but whose contents are wrong is refused: a file that was cut off does not end in such a one.
std::optional<Damage> Reader::read_block() {
  if (end_ - at_ < kBlockHeaderBytes) {
    return Damage{std::to_string(end_ - at_) + " bytes", "a block header of 28"};
  }
  const Bytes bytes = file_.read(at_, kBlockHeaderBytes);
  const auto header = unpack_block_header(bytes);
  if (!header) return Damage{"an unknown kind of block", "TICK, HAPP, HASH or SUMM"};
  if (header->length > most_body_bytes(header->kind, layout_) ||
      header->length > end_ - at_ - kBlockHeaderBytes) {
    return Damage{"a length of " + std::to_string(header->length),
                  "no more than such a block or the file can hold"};
  }
  const Bytes stored = file_.read(at_ + kBlockHeaderBytes, header->length);
  const std::uint32_t crc = compute_crc(*header, stored);
  if (crc != header->crc) {
    return Damage{"CRC32 " + to_hexadecimal(crc), to_hexadecimal(header->crc)};
  }
  if (header->kind == BlockKind::summary) {
    file_.refuse(where(), "a summary with more after it", "the summary at the end of the file");
  }
  unpack_block(*header, stored);
  sha256_.add(bytes);
  sha256_.add(stored);
  at_ += kBlockHeaderBytes + header->length;
  ++block_;
  return std::nullopt;
}

Bytes Reader::unpack_body(const BlockHeader& header, const Bytes& stored) const {
  const std::size_t size = header.count * row_bytes(header.kind, layout_);
  if (header.codec == static_cast<std::uint32_t>(RecordCodec::none)) {
    if (stored.size() != size) {
      file_.refuse(where() + ": length", std::to_string(stored.size()), std::to_string(size));
    }
    return stored;
  }
  if (header.codec != static_cast<std::uint32_t>(RecordCodec::deflate)) {
    file_.refuse(where() + ": codec", std::to_string(header.codec), "0 or 1");
  }
  if (size > kMostRatio * (stored.size() + kBlockHeaderBytes)) {
    file_.refuse(where() + ": body",
                 std::to_string(stored.size()) + " bytes for " + std::to_string(size),
                 "at least a 256th: none was ever written like this");
  }
  const std::optional<Bytes> shuffled = inflate(stored, size);
  if (!shuffled) {
    file_.refuse(where() + ": body", "a zlib stream of another length or none at all",
                 "one of " + std::to_string(size) + " bytes");
  }
  return unshuffle_differences(header.kind, layout_, header.count, *shuffled);
}

void Reader::unpack_block(const BlockHeader& header, const Bytes& stored) {
  if (header.count < 1 || header.count > kMostBlockRows) {
    file_.refuse(where() + ": count", std::to_string(header.count), "1 to 4096");
  }
  const std::size_t have = header.kind == BlockKind::ticks    ? count_ticks()
                           : header.kind == BlockKind::events ? record_.events.size()
                                                              : record_.hashes.size();
  const std::int64_t most = header.kind == BlockKind::ticks ? most_ticks(layout_) : kMostRows;
  if (have + header.count > static_cast<std::size_t>(most)) {
    file_.refuse(where(), "more than " + std::to_string(most) + " " + kind_name(header.kind),
                 "fewer");
  }
  const Bytes body = unpack_body(header, stored);
  switch (header.kind) {
    case BlockKind::ticks:
      return take_ticks(header, body);
    case BlockKind::events:
      return unpack(body, header, layout_, record_.events);
    case BlockKind::hashes:
      return unpack(body, header, layout_, record_.hashes);
    case BlockKind::summary:
      return;
  }
}

void Reader::take_ticks(const BlockHeader& header, const Bytes& body) {
  constexpr std::int64_t kLastTick = std::int64_t{1} << 53;
  if (header.first_tick < next_tick_ || header.first_tick > kLastTick) {
    file_.refuse(where() + ": first tick", std::to_string(header.first_tick),
                 std::to_string(next_tick_) + " or, after a gap, more");
  }
  rows_.clear();
  unpack(body, header, layout_, rows_);
  for (const TickLog::Tick& row : rows_) {
    record_.hand.push_back(row.sample);
    record_.felt.push_back(row.felt);
  }
  next_tick_ = header.first_tick + header.count;
}

/// Whether these bytes are the summary of what was read, but for two or more that are zero: the
/// disk had not written them yet when the power went.
bool Reader::is_torn_summary(std::span<const std::uint8_t> tail) {
  const Bytes body = pack_summary({.ticks = count_ticks(),
                                   .events = record_.events.size(),
                                   .hashes = record_.hashes.size(),
                                   .sha256 = sha256_.finish()});
  BlockHeader header{
      .kind = BlockKind::summary, .first_tick = next_tick_, .count = 1, .length = kSummaryBytes};
  header.crc = compute_crc(header, body);
  const auto packed = pack_block_header(header);
  Bytes whole(packed.begin(), packed.end());
  whole.insert(whole.end(), body.begin(), body.end());
  int lost = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (tail[i] == whole[i]) continue;
    if (tail[i] != 0) return false;
    ++lost;
  }
  return lost > 1;  // one may be a bit that was turned
}

/// A file that was cut off ends in part of a block. One that ends in exactly as many bytes as a
/// summary has, and not in another kind of block nor in zeros a loss of power left in place of its
/// beginning or its end, was finished once and has been damaged since.
void Reader::refuse_damaged_summary(const Damage& damage) {
  if (size_ - at_ != kSummaryBlockBytes) return;
  const Bytes tail = file_.read(at_, kSummaryBlockBytes);
  const auto header = unpack_block_header(tail);
  const auto are_zeros = [](std::span<const std::uint8_t> bytes) {
    return std::all_of(bytes.begin(), bytes.end(), [](auto byte) { return byte == 0; });
  };
  const bool torn = are_zeros(std::span(tail).first(8)) || are_zeros(std::span(tail).last(8));
  if (torn || (header && header->kind != BlockKind::summary) || is_torn_summary(tail)) return;
  file_.refuse("summary at byte " + std::to_string(at_), damage.found, damage.expected);
}

void Reader::check_summary() {
  const Bytes body = file_.read(end_ + kBlockHeaderBytes, kSummaryBytes);
  const Summary summary = unpack_summary(body);
  const auto check = [&](const char* what, std::uint64_t found, std::uint64_t expected) {
    if (found == expected) return;
    file_.refuse(std::string("summary: ") + what, std::to_string(found), std::to_string(expected));
  };
  check("ticks", count_ticks(), summary.ticks);
  check("events", record_.events.size(), summary.events);
  check("hashes", record_.hashes.size(), summary.hashes);
  const auto digest = sha256_.finish();
  if (digest != summary.sha256) {
    file_.refuse("summary: SHA-256", to_hexadecimal(digest), to_hexadecimal(summary.sha256));
  }
}

void Reader::finish(bool finished) {
  record_.complete = finished;
  const auto check = [&](const char* what, std::int64_t found) {
    if (found < 0) file_.refuse(what, std::to_string(found), "0 or more");
  };
  for (const Event& event : record_.events) {
    check("events: tick", event.tick);
    check("events: source", event.source);
  }
  for (const StateHash& hash : record_.hashes) check("hashes: tick", hash.tick);
}

}  // namespace

Record read_record(const std::string& path) { return Reader(path).read(); }

}  // namespace palpate
