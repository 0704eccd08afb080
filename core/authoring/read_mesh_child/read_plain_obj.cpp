// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "palpate/authoring/file_signature.h"
#include "palpate/authoring/read_mesh_child/foreign_formats.h"

namespace palpate::authoring {
namespace {

/// Takes words and numbers off the front of a line.
class Line {
 public:
  explicit Line(std::string_view text) : rest_(text) {}

  std::string_view take_word() {
    skip_blanks();
    const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r"));
    rest_.remove_prefix(word.size());
    return word;
  }

  std::string_view take_rest() {
    skip_blanks();
    return rest_.substr(0, rest_.find_last_not_of(" \t\r") + 1);
  }

  bool at_end() {
    skip_blanks();
    return rest_.empty();
  }

 private:
  void skip_blanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r"), rest_.size()));
  }

  std::string_view rest_;
};

template <class Number>
bool parse(std::string_view word, Number& value) {
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  return problem == std::errc() && end == word.data() + word.size();
}

/// An OBJ file read line by line. Every take_ returns false where the file is not plain.
class PlainObj {
 public:
  explicit PlainObj(std::string name) : part_names_{std::move(name)}, parts_(1) {}

  bool take_line(std::string_view text) {
    Line line(text);
    const std::string_view word = line.take_word();
    if (word.empty()) return true;
    if (word[0] == '#') return take_comment(text);
    if (word == "v") return take_vertex(line);
    if (word == "f") return take_face(line);
    if (word == "o" || word == "g") return take_part(line);
    return word == "vn" || word == "vt" || word == "s" || word == "usemtl" || word == "mtllib";
  }

  std::optional<ImportedScene> finish() const {
    ImportedScene scene{};
    if (marked_) {
      scene.unit = "m";
      scene.up = "z";
    }
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (!parts_[p].empty()) scene.parts.push_back({part_names_[p], cut_out(parts_[p])});
    }
    if (scene.parts.empty()) return std::nullopt;
    return scene;
  }

 private:
  bool take_comment(std::string_view text) {
    marked_ = marked_ || text.find(kFileSignature) != std::string_view::npos;
    return true;
  }

  bool take_vertex(Line& line) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      if (!parse(line.take_word(), p[i])) return false;
    }
    vertices_.push_back(p);
    return line.at_end();
  }

  bool take_face(Line& line) {
    Triangle t;
    for (int& corner : t) {
      const std::string_view word = line.take_word();
      if (!parse(word.substr(0, word.find('/')), corner)) return false;
      if (corner < 1 || corner > static_cast<int>(vertices_.size())) return false;
      --corner;
    }
    parts_.back().push_back(t);
    return line.at_end();
  }

  bool take_part(Line& line) {
    part_names_.emplace_back(line.take_rest());
    parts_.emplace_back();
    return true;
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

  bool marked_ = false;
  Vec3Array vertices_;
  std::vector<std::string> part_names_;
  std::vector<std::vector<Triangle>> parts_;
};

}  // namespace

std::optional<ImportedScene> read_plain_obj(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  PlainObj obj(std::filesystem::path(path).stem().string());
  for (std::string line; std::getline(in, line);) {
    // a line continued on the next, or one that is not text
    if (line.find('\\') != std::string::npos || line.find('\0') != std::string::npos) {
      return std::nullopt;
    }
    if (!obj.take_line(line)) return std::nullopt;
  }
  return obj.finish();
}

}  // namespace palpate::authoring
