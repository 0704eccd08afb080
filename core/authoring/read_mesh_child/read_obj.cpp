// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <map>

#include "palpate/authoring/file_signature.h"
#include "palpate/authoring/read_mesh_child/foreign_formats.h"
#include "palpate/authoring/read_mesh_child/mean_colour.h"
#include "palpate/authoring/read_mesh_child/read_materials.h"
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
      : path_(path), part_names_{std::filesystem::path(path).stem().string()}, parts_(1), of_(1) {}

  void take_line(std::string_view text, int number) {
    number_ = number;
    TextLine line(text);
    const std::string_view word = line.take_word();
    if (word.starts_with('#')) {
      marked_ = marked_ || text.find(kFileSignature) != std::string_view::npos;
    } else if (word == "v") {
      take_vertex(line);
    } else if (word == "f" || word == "fo") {
      take_face(line);
    } else if (word == "o" || word == "g") {
      part_names_.emplace_back(line.take_rest());
      parts_.emplace_back();
      of_.emplace_back();
    } else if (word == "usemtl") {
      const std::string name(line.take_rest());
      const auto next = static_cast<int>(material_numbers_.size());
      material_ = material_numbers_.try_emplace(name, next).first->second;
    } else if (word == "mtllib") {
      take_library(std::string(line.take_rest()));
    } else if (word == "curv" || word == "curv2" || word == "surf") {
      ++skipped_.curves;
    }
  }

  ImportedScene finish() {
    ImportedScene scene{};
    if (colours_.size() != vertices_.size()) colours_.clear();  // only some have one
    if (marked_) {
      scene.unit = "m";
      scene.up = "z";
    }
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (parts_[p].empty()) continue;
      ImportedPart part;
      part.name = part_names_[p];
      part.mesh = cut_out(parts_[p]);
      part.colour = find_colour(p);
      scene.parts.push_back(std::move(part));
    }
    const auto note = [&](int count, const char* what) {
      if (count > 0) scene.notes.push_back(std::to_string(count) + what);
    };
    wrong_.settle(faces_, scene.notes);
    note(skipped_.short_faces, " faces of fewer than three corners were left out");
    note(skipped_.curves, " free-form curves or surfaces were left out");
    if (has_textures_) scene.notes.emplace_back(kTexturesStay);
    for (const std::string& library : missing_) {
      scene.notes.push_back("the materials in " + library + " are not there to be read");
    }
    return scene;
  }

 private:
  FileError make_error(std::string_view got, const std::string& expected) const {
    return {path_, "line " + std::to_string(number_), std::string(got), expected};
  }

  [[noreturn]] void refuse(std::string_view got, const std::string& expected) const {
    throw make_error(got, expected);
  }

  void take_library(const std::string& name) {
    Materials read = read_materials(path_, name);
    if (!read.is_there) missing_.push_back(one_line(name));
    has_textures_ = has_textures_ || read.has_textures;
    materials_.merge(read.colours);
  }

  static std::string one_line(std::string text) {
    for (char& c : text) {
      if (static_cast<unsigned char>(c) < 32) c = ' ';
    }
    return text.substr(0, 200);
  }

  /// Of what has one: its corners' before its material's.
  std::optional<std::array<double, 3>> find_colour(std::size_t p) const {
    std::vector<const Vec3*> colour(material_numbers_.size(), nullptr);
    for (const auto& [name, number] : material_numbers_) {
      const auto found = materials_.find(name);
      if (found != materials_.end()) colour[number] = &found->second;
    }
    MeanColour mean;
    for (std::size_t t = 0; t < parts_[p].size(); ++t) {
      const auto& [a, b, c] = parts_[p][t];
      const Vec3 &x = vertices_[a], &y = vertices_[b], &z = vertices_[c];
      const double area = 0.5 * (y - x).cross(z - x).norm();
      if (!colours_.empty()) {
        mean.add((colours_[a] + colours_[b] + colours_[c]) / (3.0 * brightest_), area);
      } else if (of_[p][t] >= 0 && colour[of_[p][t]] != nullptr) {
        mean.add(*colour[of_[p][t]], area);
      }
    }
    return mean.find(false);
  }

  /// Three numbers behind the place are a colour, of 0 to 1 or of 0 to 255; one is a weight, and
  /// left alone.
  void take_colour(TextLine& line) {
    Vec3 colour;
    const bool has_one = line.take(colour[0]) && line.take(colour[1]) && line.take(colour[2]);
    if (has_one && colour.allFinite() && colours_.size() + 1 == vertices_.size()) {
      colours_.push_back(colour);
      if (colour.maxCoeff() > 1.0) brightest_ = 255.0;
    }
  }

  void take_vertex(TextLine& line) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = line.take_word();
      if (!TextLine::parse(word, p[i])) {
        refuse(word.empty() ? "a vertex of " + std::to_string(i) + " numbers"
                            : "'" + std::string(word.substr(0, 40)) + "'",
               "three numbers");
      }
    }
    vertices_.push_back(p);
    take_colour(line);
  }

  void take_face(TextLine& line) {
    ++faces_;
    corners_.clear();
    for (std::string_view word = line.take_word(); !word.empty(); word = line.take_word()) {
      if (word.starts_with('#')) break;
      const int vertex = find_vertex(word);
      if (vertex < 0) return;
      corners_.push_back(vertex);
    }
    if (corners_.size() < 3) {
      ++skipped_.short_faces;
      return;
    }
    triangulate_polygon(corners_, vertices_, parts_.back());
    of_.back().resize(parts_.back().size(), material_);
  }

  /// Of the corner v/vt/vn only v is asked; below zero it counts back from the last vertex. -1
  /// where there is none, which is remembered.
  int find_vertex(std::string_view word) {
    const int count = static_cast<int>(vertices_.size());
    int index = 0;
    if (!TextLine::parse(word.substr(0, word.find('/')), index)) {
      refuse("'" + std::string(word.substr(0, 40)) + "'", "the number of a vertex");
    }
    const int vertex = index < 0 ? count + index : index - 1;
    if (vertex < 0 || vertex >= count) {
      wrong_.add(make_error("vertex " + std::to_string(index), "1 to " + std::to_string(count)));
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
  Skipped skipped_;
  WrongFaces wrong_;
  long faces_ = 0;
  Vec3Array vertices_;
  std::vector<int> corners_;  // of the face being taken
  std::vector<std::string> part_names_;
  std::vector<std::vector<Triangle>> parts_;

  Vec3Array colours_;       // of the vertices, where all have one
  double brightest_ = 1.0;  // what stands for a full channel
  std::map<std::string, Vec3> materials_;
  std::map<std::string, int> material_numbers_;
  int material_ = -1;                 // of the faces being taken; -1 for none
  std::vector<std::vector<int>> of_;  // the material of each triangle, as parts_
  std::vector<std::string> missing_;
  bool has_textures_ = false;
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

}  // namespace

std::optional<ImportedScene> read_obj(const std::string& path) {
  TextFile in(path);
  Obj obj(path);
  int number = 1;
  for (std::string line; in.take_line(line);) {
    if (number == 1) drop_byte_order_mark(line);
    const int taken = take_whole_line(in, line);
    if (line.find('\0') != std::string::npos) return std::nullopt;
    obj.take_line(line, number);
    number += taken;
  }
  return obj.finish();
}

}  // namespace palpate::authoring
