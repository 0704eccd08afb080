// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace palpate::authoring {

/// The word for its unit in a 3MF or AMF file, which assimp passes over: millimeter where the file
/// leaves it out, as both formats have it; empty where the file is built in a way unknown here.
std::string read_print_unit(const std::string& path, const std::string& format);

}  // namespace palpate::authoring
