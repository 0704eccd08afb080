// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/session/private/record_layout.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

namespace palpate::record_layout {
namespace {

constexpr std::array<std::array<char, 4>, 4> kBlockMagics = {
    {{'T', 'I', 'C', 'K'}, {'H', 'A', 'P', 'P'}, {'H', 'A', 'S', 'H'}, {'S', 'U', 'M', 'M'}}};

// The columns of each kind of block, in order. Every table is walked for packing, for unpacking
// and for the description in the header, so the three cannot disagree.

template <class Visit>
void visit_columns(const TickLog::Tick*, const Layout&, Visit visit) {
  visit("time", [](auto& t) { return &t.sample.time; });
  visit("position_x", [](auto& t) { return &t.sample.position[0]; });
  visit("position_y", [](auto& t) { return &t.sample.position[1]; });
  visit("position_z", [](auto& t) { return &t.sample.position[2]; });
  visit("orientation_x", [](auto& t) { return &t.sample.orientation.coeffs()[0]; });
  visit("orientation_y", [](auto& t) { return &t.sample.orientation.coeffs()[1]; });
  visit("orientation_z", [](auto& t) { return &t.sample.orientation.coeffs()[2]; });
  visit("orientation_w", [](auto& t) { return &t.sample.orientation.coeffs()[3]; });
  visit("velocity_x", [](auto& t) { return &t.sample.velocity[0]; });
  visit("velocity_y", [](auto& t) { return &t.sample.velocity[1]; });
  visit("velocity_z", [](auto& t) { return &t.sample.velocity[2]; });
  visit("grip", [](auto& t) { return &t.sample.grip; });
  visit("buttons", [](auto& t) { return &t.sample.buttons; });
  visit("force_x", [](auto& t) { return &t.felt.force[0]; });
  visit("force_y", [](auto& t) { return &t.felt.force[1]; });
  visit("force_z", [](auto& t) { return &t.felt.force[2]; });
  visit("tool_x", [](auto& t) { return &t.felt.position[0]; });
  visit("tool_y", [](auto& t) { return &t.felt.position[1]; });
  visit("tool_z", [](auto& t) { return &t.felt.position[2]; });
  visit("touched", [](auto& t) { return &t.felt.touched; });
  visit("lateness_us", [](auto& t) { return &t.felt.lateness_us; });
}

template <class Visit>
void visit_columns(const Event*, const Layout& layout, Visit visit) {
  visit("tick", [](auto& h) { return &h.tick; });
  visit("kind", [](auto& h) { return &h.kind; });
  visit("index", [](auto& h) { return &h.index; });
  visit("value", [](auto& h) { return &h.value; });
  if (layout.version >= 2) visit("source", [](auto& h) { return &h.source; });
}

template <class Visit>
void visit_columns(const StateHash*, const Layout&, Visit visit) {
  visit("tick", [](auto& h) { return &h.tick; });
  visit("hash_0", [](auto& h) { return &h.hash[0]; });
  visit("hash_1", [](auto& h) { return &h.hash[1]; });
}

template <class Visit>
void visit_kind(BlockKind kind, Visit visit) {
  switch (kind) {
    case BlockKind::ticks:
      return visit(TickLog::Tick{});
    case BlockKind::events:
      return visit(Event{});
    case BlockKind::hashes:
      return visit(StateHash{});
    case BlockKind::summary:
      return;
  }
}

template <class Row, class Column>
using Value = std::remove_pointer_t<std::invoke_result_t<Column, Row&>>;

/// How many rows of the table make one row of a block.
template <class Row>
std::size_t rows_per_row(const Layout& layout) {
  return std::is_same_v<Row, TickLog::Tick> ? static_cast<std::size_t>(layout.instruments) : 1;
}

std::vector<int> column_widths(BlockKind kind, const Layout& layout) {
  std::vector<int> widths;
  visit_kind(kind, [&]<class Row>(Row) {
    for (std::size_t lane = 0; lane < rows_per_row<Row>(layout); ++lane) {
      visit_columns(
          static_cast<const Row*>(nullptr), layout,
          [&]<class Column>(const char*, Column) { widths.push_back(sizeof(Value<Row, Column>)); });
    }
  });
  return widths;
}

std::uint64_t load(const std::uint8_t* bytes, int width) {
  std::uint64_t value = 0;
  for (int b = 0; b < width; ++b) value |= std::uint64_t{bytes[b]} << (8 * b);
  return value;
}

void store(std::uint64_t value, int width, std::uint8_t* bytes) {
  for (int b = 0; b < width; ++b) bytes[b] = static_cast<std::uint8_t>(value >> (8 * b));
}

template <int width>
using Bits = std::conditional_t<
    width == 8, std::uint64_t,
    std::conditional_t<width == 4, std::uint32_t,
                       std::conditional_t<width == 2, std::uint16_t, std::uint8_t>>>;

template <class T>
void append(T value, Bytes& bytes) {
  const std::uint64_t bits = std::bit_cast<Bits<sizeof(T)>>(value);
  for (std::size_t b = 0; b < sizeof(T); ++b) {
    bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * b)));
  }
}

template <class Row>
Bytes pack_rows(std::span<const Row> rows, const Layout& layout) {
  Bytes bytes;
  bytes.reserve(rows.size() * sizeof(Row));
  const std::size_t lanes = rows_per_row<Row>(layout);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    visit_columns(rows.data(), layout, [&](const char*, auto column) {
      for (std::size_t r = lane; r < rows.size(); r += lanes) append(*column(rows[r]), bytes);
    });
  }
  return bytes;
}

template <class Row>
void unpack_rows(const std::uint8_t* at, std::uint32_t count, const Layout& layout,
                 std::vector<Row>& rows) {
  const std::size_t first = rows.size(), lanes = rows_per_row<Row>(layout);
  rows.resize(first + count * lanes);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    visit_columns(rows.data(), layout, [&]<class Column>(const char*, Column column) {
      using T = Value<Row, Column>;
      for (std::size_t i = 0; i < count; ++i, at += sizeof(T)) {
        *column(rows[first + i * lanes + lane]) =
            std::bit_cast<T>(static_cast<Bits<sizeof(T)>>(load(at, sizeof(T))));
      }
    });
  }
}

template <class Row>
std::string describe(const Layout& layout) {
  std::string text;
  for (std::size_t lane = 0; lane < rows_per_row<Row>(layout); ++lane) {
    const std::string prefix = lane == 0 ? "" : std::to_string(lane) + ".";
    visit_columns(
        static_cast<const Row*>(nullptr), layout, [&]<class Column>(const char* name, Column) {
          using T = Value<Row, Column>;
          const char* type = std::is_floating_point_v<T> ? "f" : std::is_unsigned_v<T> ? "u" : "i";
          text += (text.empty() ? "[\"" : ",[\"") + prefix + name + "\",\"" + type +
                  std::to_string(sizeof(T)) + "\"]";
        });
  }
  return "[" + text + "]";
}

}  // namespace

const char* kind_name(BlockKind kind) {
  constexpr std::array<const char*, 4> names = {"ticks", "events", "hashes", "summary"};
  return names[static_cast<std::size_t>(kind)];
}

Layout choose_layout(int instruments, bool several_bodies) noexcept {
  return {instruments > 1 || several_bodies ? 2u : 1u, instruments};
}

std::size_t preamble_bytes(std::uint32_t version) noexcept {
  return version == 1 ? kPreambleBytes : kPreambleBytes + 4;
}

std::int64_t most_ticks(const Layout& layout) noexcept { return kMostRows / layout.instruments; }

// the format calls events happenings
std::string describe_columns(const Layout& layout) {
  const std::string instruments =
      layout.version == 1 ? "" : ",\"instruments\":" + std::to_string(layout.instruments);
  return "{\"version\":" + std::to_string(layout.version) + instruments +
         ",\"columns\":{\"ticks\":" + describe<TickLog::Tick>(layout) +
         ",\"happenings\":" + describe<Event>(layout) +
         ",\"hashes\":" + describe<StateHash>(layout) + "}}";
}

Bytes pack_u32(std::uint32_t value) {
  Bytes bytes;
  append(value, bytes);
  return bytes;
}

std::uint32_t unpack_u32(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(load(bytes.data(), 4));
}

Bytes pack_preamble(const std::string& header_json, const Layout& layout) {
  Bytes bytes(kMagic.begin(), kMagic.end());
  append(layout.version, bytes);
  append(static_cast<std::uint32_t>(header_json.size()), bytes);
  if (layout.version > 1) append(static_cast<std::uint32_t>(layout.instruments), bytes);
  bytes.insert(bytes.end(), header_json.begin(), header_json.end());
  return bytes;
}

std::array<std::uint8_t, kBlockHeaderBytes> pack_block_header(const BlockHeader& header) {
  std::array<std::uint8_t, kBlockHeaderBytes> bytes{};
  std::memcpy(bytes.data(), kBlockMagics[static_cast<std::size_t>(header.kind)].data(), 4);
  store(header.codec, 4, bytes.data() + 4);
  store(static_cast<std::uint64_t>(header.first_tick), 8, bytes.data() + 8);
  store(header.count, 4, bytes.data() + 16);
  store(header.length, 4, bytes.data() + 20);
  store(header.crc, 4, bytes.data() + 24);
  return bytes;
}

std::optional<BlockHeader> unpack_block_header(std::span<const std::uint8_t> bytes) {
  const auto magic = std::find_if(kBlockMagics.begin(), kBlockMagics.end(), [&](const auto& m) {
    return std::memcmp(m.data(), bytes.data(), 4) == 0;
  });
  if (magic == kBlockMagics.end()) return std::nullopt;
  return BlockHeader{.kind = static_cast<BlockKind>(magic - kBlockMagics.begin()),
                     .codec = unpack_u32(bytes.subspan(4)),
                     .first_tick = static_cast<std::int64_t>(load(bytes.data() + 8, 8)),
                     .count = unpack_u32(bytes.subspan(16)),
                     .length = unpack_u32(bytes.subspan(20)),
                     .crc = unpack_u32(bytes.subspan(24))};
}

Bytes pack_summary(const Summary& summary) {
  Bytes bytes;
  append(summary.ticks, bytes);
  append(summary.events, bytes);
  append(summary.hashes, bytes);
  bytes.insert(bytes.end(), summary.sha256.begin(), summary.sha256.end());
  return bytes;
}

Summary unpack_summary(std::span<const std::uint8_t> bytes) {
  Summary summary{load(bytes.data(), 8), load(bytes.data() + 8, 8), load(bytes.data() + 16, 8), {}};
  std::copy_n(bytes.begin() + 24, summary.sha256.size(), summary.sha256.begin());
  return summary;
}

Bytes pack(std::span<const TickLog::Tick> rows, const Layout& layout) {
  return pack_rows(rows, layout);
}
Bytes pack(std::span<const Event> rows, const Layout& layout) { return pack_rows(rows, layout); }
Bytes pack(std::span<const StateHash> rows, const Layout& layout) {
  return pack_rows(rows, layout);
}

std::size_t row_bytes(BlockKind kind, const Layout& layout) {
  std::size_t sum = 0;
  for (const int width : column_widths(kind, layout)) sum += static_cast<std::size_t>(width);
  return sum;
}

void unpack(std::span<const std::uint8_t> body, const BlockHeader& header, const Layout& layout,
            std::vector<TickLog::Tick>& rows) {
  const std::size_t first = rows.size(), lanes = rows_per_row<TickLog::Tick>(layout);
  unpack_rows(body.data(), header.count, layout, rows);
  for (std::size_t r = first; r < rows.size(); ++r) {
    rows[r].tick = header.first_tick + static_cast<std::int64_t>((r - first) / lanes);
  }
}

void unpack(std::span<const std::uint8_t> body, const BlockHeader& header, const Layout& layout,
            std::vector<Event>& rows) {
  unpack_rows(body.data(), header.count, layout, rows);
}

void unpack(std::span<const std::uint8_t> body, const BlockHeader& header, const Layout& layout,
            std::vector<StateHash>& rows) {
  unpack_rows(body.data(), header.count, layout, rows);
}

Bytes shuffle_differences(BlockKind kind, const Layout& layout, std::uint32_t count,
                          std::span<const std::uint8_t> plain) {
  Bytes shuffled(plain.size());
  std::size_t column = 0;
  for (const int width : column_widths(kind, layout)) {
    std::uint64_t last = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t w = static_cast<std::size_t>(width);
      const std::uint64_t value = load(plain.data() + column + i * w, width);
      const std::uint64_t difference = value - last;
      for (std::size_t b = 0; b < w; ++b) {
        shuffled[column + b * count + i] = static_cast<std::uint8_t>(difference >> (8 * b));
      }
      last = value;
    }
    column += static_cast<std::size_t>(width) * count;
  }
  return shuffled;
}

Bytes unshuffle_differences(BlockKind kind, const Layout& layout, std::uint32_t count,
                            std::span<const std::uint8_t> shuffled) {
  Bytes plain(shuffled.size());
  std::size_t column = 0;
  for (const int width : column_widths(kind, layout)) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t w = static_cast<std::size_t>(width);
      std::uint64_t difference = 0;
      for (std::size_t b = 0; b < w; ++b) {
        difference |= std::uint64_t{shuffled[column + b * count + i]} << (8 * b);
      }
      value += difference;
      store(value, width, plain.data() + column + i * w);
    }
    column += static_cast<std::size_t>(width) * count;
  }
  return plain;
}

}  // namespace palpate::record_layout
