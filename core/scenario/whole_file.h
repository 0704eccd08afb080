// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/scenario/container.h"

// Not installed: files that are read and written as one piece.

namespace palpate::scenario {

/// Throws FileError for what cannot be read, is no plain file, or has more than `most` bytes.
Bytes read_whole(const std::string& path, std::size_t most);

/// A reader, a full disk, a kill or a loss of power never meets half a file. Follows a link, as
/// open() does. Throws FileError, and leaves nothing behind.
void write_whole(const std::string& path, std::span<const std::uint8_t> bytes);

}  // namespace palpate::scenario
