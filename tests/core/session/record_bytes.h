// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/session/some_record.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/session/record.h"

namespace palpate::testing {

inline constexpr RecordCodec kCodecs[] = {RecordCodec::none, RecordCodec::deflate};

/// The bytes of `record` as a file.
inline std::vector<char> bytes_of(const Folder& folder, const Record& record, RecordCodec codec) {
  write_record(folder.file("whole.prec"), record, codec);
  return read_bytes(folder.file("whole.prec"));
}

/// What the reader makes of these bytes; none if it refuses them.
inline std::optional<Record> read_back(const Folder& folder, const std::vector<char>& bytes) {
  write_bytes(folder.file("other.prec"), bytes);
  try {
    return read_record(folder.file("other.prec"));
  } catch (const FileError&) {
    return std::nullopt;
  }
}

inline std::string refusal(const Folder& folder, const std::vector<char>& bytes) {
  write_bytes(folder.file("other.prec"), bytes);
  try {
    read_record(folder.file("other.prec"));
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

inline constexpr std::size_t kSummaryBlock = 84;

inline std::span<const std::uint8_t> as_bytes(const std::vector<char>& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

}  // namespace palpate::testing
