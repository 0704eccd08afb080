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
inline constexpr std::uint32_t kVersion = 1;
inline constexpr std::size_t kPreambleBytes = 16;  ///< magic, version, length of the JSON
inline constexpr std::size_t kMostHeaderBytes = 1 << 20;
inline constexpr std::uint32_t kBlockTicks = 250;      ///< of a full block as written
inline constexpr std::uint32_t kMostBlockRows = 4096;  ///< of any block as read
inline constexpr std::int64_t kMostRows = 1 << 23;     ///< of each kind in a file: 2 h 20 min
inline constexpr std::size_t kBlockHeaderBytes = 28;
inline constexpr std::size_t kSummaryBytes = 56;

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
std::string describe_columns();

Bytes pack_preamble(const std::string& header_json);
std::array<std::uint8_t, kBlockHeaderBytes> pack_block_header(const BlockHeader& header);
/// None for a magic that is not of any kind of block.
std::optional<BlockHeader> unpack_block_header(std::span<const std::uint8_t> bytes);
std::uint32_t unpack_u32(std::span<const std::uint8_t> bytes);
Bytes pack_u32(std::uint32_t value);
Bytes pack_summary(const Summary& summary);
Summary unpack_summary(std::span<const std::uint8_t> bytes);

/// Plain bodies: column after column, `count` values each.
Bytes pack(std::span<const TickLog::Tick> rows);
Bytes pack(std::span<const Event> rows);
Bytes pack(std::span<const StateHash> rows);
std::size_t row_bytes(BlockKind kind);

/// Append the rows of a plain body of row_bytes(kind) * count bytes.
void unpack(std::span<const std::uint8_t> body, const BlockHeader& header,
            std::vector<TickLog::Tick>& rows);
void unpack(std::span<const std::uint8_t> body, const BlockHeader& header,
            std::vector<Event>& rows);
void unpack(std::span<const std::uint8_t> body, const BlockHeader& header,
            std::vector<StateHash>& rows);

/// Makes a plain body easy to deflate and back: in every column each value becomes its
/// difference from the one before, as unsigned integers that wrap around, and then the lowest
/// bytes of all values come first, the next higher ones after them, and so on.
Bytes shuffle_differences(BlockKind kind, std::uint32_t count, std::span<const std::uint8_t> plain);
Bytes unshuffle_differences(BlockKind kind, std::uint32_t count,
                            std::span<const std::uint8_t> shuffled);

}  // namespace palpate::record_layout
