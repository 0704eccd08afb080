// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "palpate/sim/session/record.h"

/// The bytes of a `.prec` file (RECORD.md): packing and unpacking, nothing that touches a file.
/// Everything is little-endian, whatever the machine.
namespace palpate::record_layout {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 'P', 'R', 'E', 'C', '\r', '\n', 0x1a};
inline constexpr std::uint32_t kNewestVersion = 2;
inline constexpr std::size_t kPreambleBytes = 16;  ///< magic, version, length of the JSON
inline constexpr std::size_t kMostHeaderBytes = 1 << 20;
inline constexpr std::uint32_t kBlockTicks = 250;      ///< of a full block as written
inline constexpr std::uint32_t kMostBlockRows = 4096;  ///< of any block as read
/// Of each kind in a file, a tick having one for each instrument: 2 h 20 min of one.
inline constexpr std::int64_t kMostRows = 1 << 23;
inline constexpr std::size_t kBlockHeaderBytes = 28;
inline constexpr std::size_t kSummaryBytes = 56;

/// What decides the columns. Version 1 is of one instrument and one body; version 2 has columns for
/// each instrument, and of an event which instrument or body it is of.
struct Layout {
  std::uint32_t version = 1;
  int instruments = 1;
};

/// The oldest that has room for all of them.
Layout choose_layout(int instruments, bool several_bodies) noexcept;

/// What stands before the JSON: in version 2 the number of instruments too.
std::size_t preamble_bytes(std::uint32_t version) noexcept;

/// Ticks of a file at most.
std::int64_t most_ticks(const Layout& layout) noexcept;

enum class BlockKind { ticks, events, hashes, summary };

struct BlockHeader {
  BlockKind kind = BlockKind::ticks;
  std::uint32_t codec = 0;
  std::int64_t first_tick = 0;
  std::uint32_t count = 0;   ///< rows
  std::uint32_t length = 0;  ///< bytes of the body as stored
  std::uint32_t crc = 0;     ///< CRC32 of the 24 header bytes before it and the stored body
};

struct Summary {
  std::uint64_t ticks = 0, events = 0, hashes = 0;
  std::array<std::uint8_t, 32> sha256{};  ///< of all bytes before the summary block
};

const char* kind_name(BlockKind kind);

/// The member "prec" of the JSON header: format version and columns.
std::string describe_columns(const Layout& layout);

Bytes pack_preamble(const std::string& header_json, const Layout& layout);
std::array<std::uint8_t, kBlockHeaderBytes> pack_block_header(const BlockHeader& header);
/// None for a magic that is not of any kind of block.
std::optional<BlockHeader> unpack_block_header(std::span<const std::uint8_t> bytes);
std::uint32_t unpack_u32(std::span<const std::uint8_t> bytes);
Bytes pack_u32(std::uint32_t value);
Bytes pack_summary(const Summary& summary);
Summary unpack_summary(std::span<const std::uint8_t> bytes);

/// Plain bodies: column after column, one value for each row of a block. A row of ticks is one of
/// each instrument here.
Bytes pack(std::span<const TickLog::Tick> rows, const Layout& layout);
Bytes pack(std::span<const Event> rows, const Layout& layout);
Bytes pack(std::span<const StateHash> rows, const Layout& layout);
std::size_t row_bytes(BlockKind kind, const Layout& layout = {});

/// Append the rows of a plain body of row_bytes(kind) * count bytes.
void unpack(std::span<const std::uint8_t> body, const BlockHeader& header, const Layout& layout,
            std::vector<TickLog::Tick>& rows);
void unpack(std::span<const std::uint8_t> body, const BlockHeader& header, const Layout& layout,
            std::vector<Event>& rows);
void unpack(std::span<const std::uint8_t> body, const BlockHeader& header, const Layout& layout,
            std::vector<StateHash>& rows);

/// Makes a plain body easy to deflate and back: in every column each value becomes its
/// difference from the one before, as unsigned integers that wrap around, and then the lowest
/// bytes of all values come first, the next higher ones after them, and so on.
Bytes shuffle_differences(BlockKind kind, const Layout& layout, std::uint32_t count,
                          std::span<const std::uint8_t> plain);
Bytes unshuffle_differences(BlockKind kind, const Layout& layout, std::uint32_t count,
                            std::span<const std::uint8_t> shuffled);

}  // namespace palpate::record_layout
