// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpate/authoring/read_mesh.h"

namespace palpate::authoring {

/// Runs the reader of `options` on a file and returns all it wrote. The child limits its own memory
/// and processor time; this side stops it when `options.time_limit` is over or it writes too much.
/// Throws FileError naming the file when the child did not end well, or naming the reader when
/// there is no such program.
std::vector<char> run_reader(const std::filesystem::path& path, const std::string& format,
                             const ReadOptions& options);

}  // namespace palpate::authoring
