// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/read_mesh_child/read_materials.h"

#include <fstream>

#include "palpate/authoring/read_mesh_child/confine.h"
#include "palpate/authoring/read_mesh_child/text_line.h"

namespace palpate::authoring {
namespace {

/// The name behind options such as -s 1 1 1 and -blendu on; it may have blanks.
std::string take_picture(TextLine line) {
  std::string_view rest = line.take_rest();
  while (rest.starts_with('-')) {
    TextLine words(rest);
    words.take_word();
    double number = 0.0;
    TextLine behind = words;
    int numbers = 0;
    for (; behind.take(number); ++numbers) words = behind;
    if (numbers == 0) words.take_word();
    rest = words.take_rest();
  }
  return std::string(rest);
}

}  // namespace

Materials read_materials(const std::string& path, const std::string& name) {
  Materials found;
  const MeshFolder folder(path);
  const std::filesystem::path library = folder.folder() / name;
  if (!folder.holds(library)) return found;
  std::ifstream in(library, std::ios::binary);
  found.is_there = in.good();
  std::string material;
  for (std::string text; std::getline(in, text);) {
    TextLine line(text);
    const std::string_view word = line.take_word();
    if (word == "newmtl") {
      material = line.take_rest();
    } else if (word == "map_Kd") {
      found.pictures.insert_or_assign(material, take_picture(line));
    } else if (word == "Kd") {
      Vec3 colour;
      if (line.take(colour[0]) && line.take(colour[1]) && line.take(colour[2])) {
        found.colours.insert_or_assign(material, colour);
      }
    }
  }
  return found;
}

}  // namespace palpate::authoring
