// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/scenario/container.h"

// Not installed: files that are read and written as one piece.

namespace palpate::scenario {

/// Throws FileError for what cannot be read, is no plain file, or has more than `most` bytes.
Bytes read_whole(const std::string& path, std::size_t most);

/// Of a WholeFile. Throws FileError, and then what stood there still does, or NotDurable.
void write_whole(const std::string& path, std::span<const std::uint8_t> bytes);

}  // namespace palpate::scenario
