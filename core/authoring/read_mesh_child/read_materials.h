// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "palpate/sim/base/types.h"

namespace palpate::authoring {

/// What an OBJ's material library says of colours.
struct Materials {
  std::map<std::string, Vec3> colours;          ///< by name: Kd, as it stands there
  std::map<std::string, std::string> pictures;  ///< by name: the file of map_Kd
  bool is_there = false;                        ///< the file could be opened
};

/// Reads the library `name` of the mesh at `path`: a file beside it or below its folder. What is
/// wrong in it is passed over, as colours are all that is wanted.
Materials read_materials(const std::string& path, const std::string& name);

}  // namespace palpate::authoring
