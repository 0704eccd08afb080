// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "palpate/authoring/read_mesh.h"
#include "palpate/authoring/read_mesh_child/confine.h"

namespace palpate::authoring {

/// The pictures that the surfaces of a file are painted with, each once, as their files have them.
class Pictures {
 public:
  explicit Pictures(const std::string& mesh) : folder_(mesh) {}

  /// The number of the picture in a file beside the mesh or below its folder; -1 for one that is
  /// not there, or too large, which is noted.
  int find(const std::string& reference);

  /// The number of one that stands within the mesh file itself.
  int add(const std::string& name, const char* bytes, std::size_t size);

  /// Gives them, and what is to be noted, to the scene.
  void settle(ImportedScene& scene);

 private:
  int keep(const std::string& name, std::vector<char> bytes);

  MeshFolder folder_;
  std::map<std::string, int> numbers_;
  std::vector<Picture> pictures_;
  std::size_t bytes_ = 0;
  std::set<std::string> missing_, large_;
};

/// As CornerPaint has it, cut to 0 to 1.
std::array<float, 3> to_channels(const Vec3& colour);

/// Appends the paint of a triangle whose corners are all of one colour.
void append_plain(const Vec3& colour, ImportedPart& part);

/// Takes the paint off a part that has one colour all over and no picture.
void drop_plain_paint(ImportedPart& part);

}  // namespace palpate::authoring
