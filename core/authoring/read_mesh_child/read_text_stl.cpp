// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include "palpate/authoring/read_mesh_child/foreign_formats.h"
#include "palpate/authoring/read_mesh_child/text_file.h"
#include "palpate/authoring/read_mesh_child/text_line.h"
#include "palpate/authoring/read_mesh_child/triangulate.h"
#include "palpate/authoring/read_mesh_child/wrong_faces.h"

namespace palpate::authoring {
namespace {

constexpr const char* kTextEnd = "the end of the file";

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// The words of a file, wherever its lines end.
class Words {
 public:
  explicit Words(const std::string& path) : path_(path), in_(path) {}

  /// The next word as it stands; empty at the end of the file.
  std::string_view take() {
    for (;;) {
      const std::string_view word = rest_.take_word();
      if (!word.empty()) return word;
      if (!in_.take_line(line_)) return {};
      if (++number_ == 1) drop_byte_order_mark(line_);
      // some programs fill the file up with them
      std::replace(line_.begin(), line_.end(), '\0', ' ');
      rest_ = TextLine(line_);
    }
  }

  /// What is left of the line, which is passed over.
  std::string take_line() {
    std::string text(rest_.take_rest());
    rest_ = TextLine("");
    return text;
  }

  double take_number() {
    const std::string_view word = take();
    double value = 0.0;
    if (!TextLine::parse(word, value)) refuse(word, "a vertex of three numbers");
    return value;
  }

  [[noreturn]] void refuse(std::string_view got, const std::string& expected) const {
    throw FileError(path_, "line " + std::to_string(number_),
                    got.empty() ? std::string(kTextEnd) : show_word(got), expected);
  }

 private:
  std::string path_;
  TextFile in_;
  std::string line_;
  TextLine rest_{""};
  int number_ = 0;
};

/// Words in any case, as programs of capital letters write them; a loop may have more than three
/// corners.
class TextStl {
 public:
  explicit TextStl(const std::string& path)
      : words_(path), stem_(std::filesystem::path(path).stem().string()) {}

  ImportedScene read() {
    try {
      take_words();
    } catch (const FileError& refusal) {
      if (refusal.got != kTextEnd) throw;
      wrong_.add(refusal);
    }
    wrong_.settle(facets_, scene_.notes);
    if (is_open_) scene_.notes.emplace_back("ends without endsolid");
    return std::move(scene_);
  }

 private:
  void take_words() {
    for (std::string_view word = words_.take(); !word.empty(); word = words_.take()) {
      take_word(word);
    }
    if (!corners_.empty()) words_.refuse("", "the rest of a facet, and endfacet");
  }

  void take_word(std::string_view word) {
    const std::string said = lower(word);
    if (scene_.parts.empty() && said == "facet") begin_part("");
    if (scene_.parts.empty() && said != "solid") {
      words_.take_line();  // what some programs write above it
    } else if (of_normal_ > 0 && said != "outer") {
      --of_normal_;
    } else if (said == "solid") {
      begin_part(words_.take_line());
    } else if (said == "vertex") {
      take_vertex();
    } else if (said == "endloop" || said == "endfacet") {
      finish_loop();
    } else if (said == "endsolid") {
      words_.take_line();
      is_open_ = false;
    } else if (said == "normal") {
      of_normal_ = 3;
    } else if (said == "color") {
      words_.take_line();
    } else if (said == "outer") {
      of_normal_ = 0;
    } else if (said == "facet") {
      ++facets_;
    } else if (said != "loop") {
      words_.refuse(word, "solid, facet, outer loop, vertex, endloop, endfacet or endsolid");
    }
  }

  void begin_part(std::string name) {
    if (name.empty()) name = stem_;
    const int times = ++seen_[name];
    ImportedPart part;
    part.name = times == 1 ? name : name + " (" + std::to_string(times) + ")";
    scene_.parts.push_back(std::move(part));
    is_open_ = true;
  }

  void take_vertex() {
    if (scene_.parts.empty()) words_.refuse("vertex", "solid before it");
    Vec3Array& vertices = scene_.parts.back().mesh.vertices;
    const double x = words_.take_number(), y = words_.take_number(), z = words_.take_number();
    corners_.push_back(static_cast<int>(vertices.size()));
    vertices.emplace_back(x, y, z);
  }

  void finish_loop() {
    if (corners_.empty()) return;
    SurfaceMesh& mesh = scene_.parts.back().mesh;
    triangulate_polygon(corners_, mesh.vertices, mesh.triangles);
    corners_.clear();
  }

  Words words_;
  std::string stem_;
  ImportedScene scene_{};
  std::vector<int> corners_;  ///< of the loop being taken
  std::map<std::string, int> seen_;
  WrongFaces wrong_;
  long facets_ = 0;
  int of_normal_ = 0;     ///< numbers of it to come; the corners tell it better
  bool is_open_ = false;  ///< no endsolid since the last solid
};

}  // namespace

ImportedScene read_text_stl(const std::string& path) { return TextStl(path).read(); }

}  // namespace palpate::authoring
