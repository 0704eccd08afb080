// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "palpate/authoring/read_mesh_child/pictures.h"
#include "palpate/authoring/read_mesh_child/text_line.h"

namespace palpate::authoring {

/// What an OBJ says of colours: of its vertices, its materials and their pictures.
class ObjPaint {
 public:
  explicit ObjPaint(const std::string& path) : path_(path), pictures_(path) {}

  void take_library(const std::string& name);
  int number_material(const std::string& name);

  /// vt: two numbers, or what is none.
  void take_place(TextLine& line);

  /// Three numbers behind the place of the last of so many vertices are a colour, of 0 to 1 or of 0
  /// to 255; one is a weight, and left alone.
  void take_colour(TextLine& line, std::size_t vertices);

  /// Of the corner v/vt/vn the vt, from 0; -1 where there is none, or none of that number. The file
  /// counts them from `base`, below zero back from those `seen` above its line.
  int find_place(std::string_view word, int seen, int base) const;

  /// Colours count where each of so many vertices has one.
  void finish(std::size_t vertices) {
    if (colours_.size() != vertices) colours_.clear();
  }

  /// Triangles with the material and the places of each, -1 for none.
  struct Painted {
    const Vec3Array& vertices;
    const std::vector<Triangle>& triangles;
    const std::vector<int>& materials;
    const std::vector<Triangle>& places;
  };

  /// Paints a part with what there is: colours of corners before a material's picture or colour.
  void paint(const Painted& of, ImportedPart& part);

  void settle(ImportedScene& scene);

 private:
  bool has_places(const Triangle& places) const;

  const std::string& path_;
  Vec3Array colours_;       ///< of the vertices, where all have one
  double brightest_ = 1.0;  ///< what stands for a full channel
  std::vector<std::array<float, 2>> places_;
  std::map<std::string, int> numbers_;  ///< of the materials, by name
  std::map<std::string, Vec3> materials_;
  std::map<std::string, std::string> picture_names_;
  Pictures pictures_;
  std::vector<std::string> missing_;
};

}  // namespace palpate::authoring
