// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace palpate::authoring {

/// How one number of a PLY is stored.
struct PlyType {
  int bytes = 0;
  bool is_real = false, is_signed = false;
};

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count = {};  ///< of a list, how its length is stored
};

struct PlyElement {
  std::string name;
  long count = 0;
  std::vector<PlyProperty> properties = {};
};

enum class PlyOrder { text, little, big };

/// What stands up to end_header.
struct PlyHeader {
  PlyOrder order = PlyOrder::text;
  std::vector<PlyElement> elements;
  bool has_texture = false;
  std::size_t end = 0;  ///< [byte] where the body begins
  int lines = 0;        ///< of the header
};

/// Throws FileError with the line.
PlyHeader read_ply_header(const std::string& path, const std::string& bytes);

}  // namespace palpate::authoring
