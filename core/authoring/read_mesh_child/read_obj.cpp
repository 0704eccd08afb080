// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <limits>

#include "palpate/authoring/file_signature.h"
#include "palpate/authoring/read_mesh_child/foreign_formats.h"
#include "palpate/authoring/read_mesh_child/obj_paint.h"
#include "palpate/authoring/read_mesh_child/text_file.h"
#include "palpate/authoring/read_mesh_child/text_line.h"
#include "palpate/authoring/read_mesh_child/triangulate.h"
#include "palpate/authoring/read_mesh_child/wrong_faces.h"

namespace palpate::authoring {
namespace {

/// What is counted rather than refused.
struct Skipped {
  int short_faces = 0;  ///< of fewer than three corners
  int curves = 0;       ///< free-form curves and surfaces
};

/// An OBJ file taken line by line.
class Obj {
 public:
  explicit Obj(const std::string& path)
      : path_(path),
        part_names_{std::filesystem::path(path).stem().string()},
        parts_(1),
        paint_(path),
        of_(1),
        places_of_(1) {}

  /// To be read once more, with all vertices known before the faces, which count them from `base`.
  void begin_again(int base) {
    is_again_ = true;
    base_ = base;
  }

  /// The vertices and the places in pictures alone, of a file that is read once more.
  void take_points(std::string_view text, int number) {
    number_ = number;
    TextLine line(text);
    const std::string_view word = line.take_word();
    if (word == "v") take_vertex(line);
    if (word == "vt") paint_.take_place(line);
  }

  /// Whether faces count from 0: the last vertex is never named, and 0 is.
  bool counts_from_zero() const {
    return names_zero_ && !counts_back_ && most_ < static_cast<int>(vertices_.size());
  }

  /// Whether vertices follow the faces that name them.
  bool names_later_ones() const { return least_later_ <= static_cast<int>(vertices_.size()); }

  void take_line(std::string_view text, int number) {
    number_ = number;
    TextLine line(text);
    const std::string_view word = line.take_word();
    if (word.starts_with('#')) {
      marked_ = marked_ || text.find(kFileSignature) != std::string_view::npos;
    } else if (word == "v") {
      if (!is_again_) take_vertex(line);
      ++seen_;
    } else if (word == "vt") {
      if (!is_again_) paint_.take_place(line);
      ++seen_places_;
    } else if (word == "f" || word == "fo") {
      take_face(line);
    } else if (word == "o" || word == "g") {
      part_names_.emplace_back(line.take_rest());
      parts_.emplace_back();
      of_.emplace_back();
      places_of_.emplace_back();
    } else if (word == "usemtl") {
      material_ = paint_.number_material(std::string(line.take_rest()));
    } else if (word == "mtllib") {
      paint_.take_library(std::string(line.take_rest()));
    } else if (word == "curv" || word == "curv2" || word == "surf") {
      ++skipped_.curves;
    }
  }

  ImportedScene finish() {
    ImportedScene scene{};
    paint_.finish(vertices_.size());
    if (marked_) {
      scene.unit = "m";
      scene.up = "z";
    }
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (parts_[p].empty()) continue;
      ImportedPart part;
      part.name = part_names_[p];
      part.mesh = cut_out(parts_[p]);
      paint_.paint({vertices_, parts_[p], of_[p], places_of_[p]}, part);
      scene.parts.push_back(std::move(part));
    }
    const auto note = [&](int count, const char* what) {
      if (count > 0) scene.notes.push_back(std::to_string(count) + what);
    };
    if (base_ == 0) scene.notes.emplace_back("its faces count vertices from 0 and were read so");
    wrong_.settle(faces_, scene.notes);
    note(skipped_.short_faces, " faces of fewer than three corners were left out");
    note(skipped_.curves, " free-form curves or surfaces were left out");
    paint_.settle(scene);
    return scene;
  }

 private:
  FileError make_error(std::string_view got, const std::string& expected) const {
    return {path_, "line " + std::to_string(number_), std::string(got), expected};
  }

  [[noreturn]] void refuse(std::string_view got, const std::string& expected) const {
    throw make_error(got, expected);
  }

  void take_vertex(TextLine& line) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = line.take_word();
      if (!TextLine::parse(word, p[i])) {
        refuse(word.empty() ? "a vertex of " + std::to_string(i) + " numbers" : show_word(word),
               "three numbers");
      }
    }
    vertices_.push_back(p);
    paint_.take_colour(line, vertices_.size());
  }

  void take_face(TextLine& line) {
    ++faces_;
    corners_.clear();
    corner_places_.clear();
    for (std::string_view word = line.take_word(); !word.empty(); word = line.take_word()) {
      if (word.starts_with('#')) break;
      const int vertex = find_vertex(word);
      if (vertex < 0) return;
      corners_.push_back(vertex);
      corner_places_.push_back(paint_.find_place(word, seen_places_, base_));
    }
    if (corners_.size() < 3) {
      ++skipped_.short_faces;
      return;
    }
    const std::size_t first = parts_.back().size();
    triangulate_polygon(corners_, vertices_, parts_.back());
    of_.back().resize(parts_.back().size(), material_);
    for (std::size_t t = first; t < parts_.back().size(); ++t) {
      Triangle places{};
      for (int c = 0; c < 3; ++c) {
        const auto at = std::find(corners_.begin(), corners_.end(), parts_.back()[t][c]);
        places[c] = corner_places_[static_cast<std::size_t>(at - corners_.begin())];
      }
      places_of_.back().push_back(places);
    }
  }

  /// Of the corner v/vt/vn only v is asked; below zero it counts back from the last vertex. -1
  /// where there is none, which is remembered.
  int find_vertex(std::string_view word) {
    const int count = static_cast<int>(vertices_.size());
    int index = 0;
    if (!TextLine::parse(word.substr(0, word.find('/')), index)) {
      refuse(show_word(word), "the number of a vertex");
    }
    const int vertex = index < 0 ? seen_ + index : index - base_;
    names_zero_ = names_zero_ || index == 0;
    counts_back_ = counts_back_ || index < 0;
    most_ = std::max(most_, index);
    if (vertex < 0 || vertex >= count) {
      if (index > count) least_later_ = std::min(least_later_, index);
      wrong_.add(make_error(
          "vertex " + std::to_string(index),
          count == 0 ? std::string("vertices that faces can name")
                     : std::to_string(base_) + " to " + std::to_string(count - 1 + base_)));
      return -1;
    }
    return vertex;
  }

  /// The vertices some triangles use, in the order of the file.
  SurfaceMesh cut_out(const std::vector<Triangle>& triangles) const {
    SurfaceMesh mesh;
    std::vector<int> place(vertices_.size(), -1);
    for (const Triangle& t : triangles) {
      for (const int corner : t) place[corner] = 0;
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (place[i] < 0) continue;
      place[i] = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back(vertices_[i]);
    }
    for (const Triangle& t : triangles) {
      mesh.triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
    }
    return mesh;
  }

  const std::string& path_;
  int number_ = 0;
  bool marked_ = false;
  bool is_again_ = false;
  int base_ = 1;                    // of the numbers of vertices
  int seen_ = 0, seen_places_ = 0;  // above the line being taken
  bool names_zero_ = false, counts_back_ = false;
  int most_ = 0;                                       // the highest that a face names
  int least_later_ = std::numeric_limits<int>::max();  // that was not there yet
  Skipped skipped_;
  WrongFaces wrong_;
  long faces_ = 0;
  Vec3Array vertices_;
  std::vector<int> corners_;  // of the face being taken
  std::vector<std::string> part_names_;
  std::vector<std::vector<Triangle>> parts_;

  ObjPaint paint_;
  int material_ = -1;                             // of the faces being taken; -1 for none
  std::vector<int> corner_places_;                // of the face being taken
  std::vector<std::vector<int>> of_;              // the material of each triangle, as parts_
  std::vector<std::vector<Triangle>> places_of_;  // of its corners, as parts_
};

/// Joins a line that ends in a backslash with those that follow it; how many there were.
int take_whole_line(TextFile& in, std::string& line) {
  int taken = 1;
  while (line.ends_with('\\')) {
    line.back() = ' ';
    std::string next;
    if (!in.take_line(next)) break;
    line += next;
    ++taken;
  }
  return taken;
}

/// Hands each line and its number to `take`; false once one is no text.
template <class Take>
bool take_lines(const std::string& path, Take take) {
  TextFile in(path);
  int number = 1;
  for (std::string line; in.take_line(line);) {
    if (number == 1) drop_byte_order_mark(line);
    const int taken = take_whole_line(in, line);
    if (line.find('\0') != std::string::npos) return false;
    take(line, number);
    number += taken;
  }
  return true;
}

}  // namespace

std::optional<ImportedScene> read_obj(const std::string& path) {
  Obj obj(path);
  const auto take_line = [](Obj& to) {
    return [&to](const std::string& line, int number) { to.take_line(line, number); };
  };
  if (!take_lines(path, take_line(obj))) return std::nullopt;
  if (!obj.counts_from_zero() && !obj.names_later_ones()) return obj.finish();
  Obj again(path);
  again.begin_again(obj.counts_from_zero() ? 0 : 1);
  take_lines(path, [&](const std::string& line, int number) { again.take_points(line, number); });
  take_lines(path, take_line(again));
  return again.finish();
}

}  // namespace palpate::authoring
