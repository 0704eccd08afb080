// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace palpate::authoring {

/// What assimp would misread of a glTF is refused, and what it leaves out is noted. What is no JSON
/// is left to assimp to refuse. Throws FileError.
void check_gltf(const std::string& path, std::vector<std::string>& notes);

/// A reference as glTF writes it, %20 for a blank, as the name of a file.
std::string decode_reference(const std::string& reference);

}  // namespace palpate::authoring
