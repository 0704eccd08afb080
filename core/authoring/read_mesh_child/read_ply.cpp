// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "palpate/authoring/read_mesh_child/foreign_formats.h"
#include "palpate/authoring/read_mesh_child/mean_colour.h"
#include "palpate/authoring/read_mesh_child/pictures.h"
#include "palpate/authoring/read_mesh_child/ply_header.h"
#include "palpate/authoring/read_mesh_child/text_line.h"
#include "palpate/authoring/read_mesh_child/triangulate.h"
#include "palpate/authoring/read_mesh_child/wrong_faces.h"

namespace palpate::authoring {
namespace {

constexpr const char* kEnd = "the end of the file";

/// The numbers behind the header, row by row.
class Body {
 public:
  Body(const std::string& path, const std::string& bytes, const PlyHeader& header)
      : path_(path), bytes_(bytes), order_(header.order), at_(header.end), lines_(header.lines) {}

  /// Back to where the numbers begin.
  void rewind(const PlyHeader& header) {
    at_ = header.end;
    lines_ = header.lines;
  }

  /// The row of an element that is taken next: in text it begins a line.
  void begin_row(const PlyElement& element, long row) {
    element_ = &element;
    row_ = row;
    if (order_ != PlyOrder::text || element.properties.empty()) return;
    do {
      if (at_ >= bytes_.size()) refuse(kEnd, say_row());
      const std::size_t end = std::min(bytes_.find_first_of("\r\n", at_), bytes_.size());
      line_ = TextLine(std::string_view(bytes_).substr(at_, end - at_));
      at_ = end + (bytes_.compare(end, 2, "\r\n") == 0 ? 2 : 1);
      ++lines_;
    } while (line_.take_rest().empty());
  }

  double take(const PlyType& type) {
    if (order_ == PlyOrder::text) {
      double value = 0.0;
      const std::string_view word = line_.take_word();
      if (TextLine::parse(word, value)) return value;
      if (word.empty() && at_ >= bytes_.size()) refuse(kEnd, say_row());
      refuse(word.empty() ? "the end of the line" : show_word(word), say_row());
    }
    const auto bytes = static_cast<std::size_t>(type.bytes);
    if (bytes > bytes_.size() - at_) refuse(kEnd, say_row());
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      const std::size_t from = order_ == PlyOrder::big ? i : bytes - 1 - i;
      bits = bits << 8 | static_cast<unsigned char>(bytes_[at_ + from]);
    }
    at_ += bytes;
    return read_bits(bits, type);
  }

  void take_list(const PlyProperty& property, std::vector<double>& values) {
    const double count = take(*property.count);
    if (!(count >= 0.0 && count <= static_cast<double>(bytes_.size()))) {
      refuse("a list of " + std::to_string(count), "as many as the file has");
    }
    values.clear();
    for (long i = 0; i < static_cast<long>(count); ++i) values.push_back(take(property.type));
  }

  FileError make_error(const std::string& got, const std::string& expected) const {
    const std::string place = order_ == PlyOrder::text
                                  ? "line " + std::to_string(lines_)
                                  : element_->name + " " + std::to_string(row_);
    return {path_, place, got, expected};
  }

 private:
  static double read_bits(std::uint64_t bits, const PlyType& type) {
    if (type.is_real && type.bytes == 8) return std::bit_cast<double>(bits);
    if (type.is_real) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (!type.is_signed) return static_cast<double>(bits);
    const int unused = 64 - 8 * type.bytes;
    return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
  }

  std::string say_row() const {
    std::string text = "row " + std::to_string(row_) + " of " + std::to_string(element_->count) +
                       " of " + element_->name + ":";
    for (const PlyProperty& property : element_->properties) text += " " + property.name;
    return text;
  }

  [[noreturn]] void refuse(const std::string& got, const std::string& expected) const {
    throw make_error(got, expected);
  }

  const std::string& path_;
  const std::string& bytes_;
  PlyOrder order_;
  std::size_t at_;
  int lines_;
  TextLine line_{""};
  const PlyElement* element_ = nullptr;
  long row_ = 0;
};

bool equal_letters(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/// In any case, as some programs write them.
bool is_called(const PlyProperty& property, std::string_view name) {
  return std::equal(property.name.begin(), property.name.end(), name.begin(), name.end(),
                    equal_letters);
}

/// Where three properties of these names stand in an element's rows; none where one is missing.
std::optional<std::array<std::size_t, 3>> find_three(const PlyElement& element,
                                                     const std::array<const char*, 3>& names) {
  std::array<std::size_t, 3> places{};
  for (int i = 0; i < 3; ++i) {
    const auto& all = element.properties;
    auto found = std::find_if(all.begin(), all.end(),
                              [&](const PlyProperty& p) { return p.name == names[i] && !p.count; });
    if (found == all.end()) {
      found = std::find_if(all.begin(), all.end(), [&](const PlyProperty& p) {
        return is_called(p, names[i]) && !p.count;
      });
    }
    if (found == all.end()) return std::nullopt;
    places[i] = static_cast<std::size_t>(found - all.begin());
  }
  return places;
}

using Places = std::optional<std::array<std::size_t, 3>>;

Places find_colours(const PlyElement& element) {
  const Places plain = find_three(element, {"red", "green", "blue"});
  return plain ? plain : find_three(element, {"diffuse_red", "diffuse_green", "diffuse_blue"});
}

/// What stands for a full channel.
double find_full(const PlyType& type) {
  return type.is_real ? 1.0 : std::exp2(8 * type.bytes - (type.is_signed ? 1 : 0)) - 1.0;
}

class Ply {
 public:
  Ply(const std::string& path, const std::string& bytes)
      : path_(path), header_(read_ply_header(path, bytes)), body_(path, bytes, header_) {}

  ImportedScene read() {
    if (has_faces_first()) {
      take_elements(true, false);
      body_.rewind(header_);
      take_elements(false, true);
    } else {
      take_elements(true, true);
    }
    ImportedScene scene{};
    if (short_ > 0) {
      scene.notes.push_back(std::to_string(short_) +
                            " faces of fewer than three corners were left out");
    }
    wrong_.settle(faces_, scene.notes);
    if (mesh_.triangles.empty()) {
      throw FileError(path_, "", "no faces", "a surface made of triangles or polygons");
    }
    if (header_.has_texture) scene.notes.emplace_back("pictures of PLY files stay behind");
    ImportedPart part{std::filesystem::path(path_).stem().string(), std::move(mesh_)};
    if (painted_.pictures.size() == part.mesh.triangles.size()) {
      part.paint = std::move(painted_.paint);
      part.pictures = std::move(painted_.pictures);
    }
    drop_plain_paint(part);
    part.colour = colour_.find(false);
    scene.parts.push_back(std::move(part));
    return scene;
  }

 private:
  static bool has_faces(const PlyElement& element) {
    return element.name == "face" || element.name == "tristrips";
  }

  /// Whether faces stand before the vertices that they name.
  bool has_faces_first() const {
    const auto& all = header_.elements;
    const auto faces = std::find_if(all.begin(), all.end(), has_faces);
    return std::any_of(faces, all.end(), [](const PlyElement& e) { return e.name == "vertex"; });
  }

  void take_elements(bool vertices, bool faces) {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex" && vertices) {
        take_vertices(element);
      } else if (has_faces(element) && faces) {
        take_faces(element);
      } else {
        for (long row = 0; row < element.count; ++row) take_row(element, row, nullptr);
      }
    }
  }

  /// The numbers of a row; lists are passed over, but for `list`, which is kept in corners_.
  void take_row(const PlyElement& element, long row, const PlyProperty* list) {
    body_.begin_row(element, row);
    row_.assign(element.properties.size(), 0.0);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (!property.count) {
        row_[i] = body_.take(property.type);
      } else {
        body_.take_list(property, &property == list ? corners_ : passed_over_);
      }
    }
  }

  void take_vertices(const PlyElement& element) {
    const Places axes = find_three(element, {"x", "y", "z"});
    if (!axes) throw FileError(path_, "header", "vertices without x, y, z", "three coordinates");
    const Places colours = find_colours(element);
    for (long row = 0; row < element.count; ++row) {
      take_row(element, row, nullptr);
      mesh_.vertices.emplace_back(row_[(*axes)[0]], row_[(*axes)[1]], row_[(*axes)[2]]);
      if (colours) colours_.push_back(take_colour(element, *colours));
    }
  }

  Vec3 take_colour(const PlyElement& element, const std::array<std::size_t, 3>& places) const {
    const double full = find_full(element.properties[places[0]].type);
    return Vec3(row_[places[0]], row_[places[1]], row_[places[2]]) / full;
  }

  void take_faces(const PlyElement& element) {
    const PlyProperty* list = nullptr;
    for (const PlyProperty& property : element.properties) {
      const bool is_named =
          is_called(property, "vertex_indices") || is_called(property, "vertex_index");
      if (property.count && (list == nullptr || is_named)) list = &property;
    }
    if (list == nullptr) throw FileError(path_, "header", "faces without a list", "their corners");
    const Places colours = find_colours(element);
    for (long row = 0; row < element.count; ++row) {
      if (!take_face_row(element, row, list)) return;
      const std::size_t first = mesh_.triangles.size();
      if (element.name == "face") {
        take_polygon(corners_);
      } else {
        take_strips();
      }
      add_colours(first, colours ? std::optional(take_colour(element, *colours)) : std::nullopt);
    }
  }

  /// False where the file ends before the row does, and what is left is a few faces.
  bool take_face_row(const PlyElement& element, long row, const PlyProperty* list) {
    try {
      take_row(element, row, list);
    } catch (const FileError& refusal) {
      if (refusal.got != kEnd || element.name != "face") throw;
      wrong_.add(refusal, element.count - row);
      faces_ += element.count - row;
      return false;
    }
    return true;
  }

  void take_polygon(std::span<const double> corners) {
    ++faces_;
    polygon_.clear();
    for (const double corner : corners) {
      if (!(corner >= 0.0 && corner < static_cast<double>(mesh_.vertices.size()))) {
        wrong_.add(body_.make_error("vertex " + std::to_string(static_cast<long>(corner)),
                                    "an index below " + std::to_string(mesh_.vertices.size())));
        return;
      }
      polygon_.push_back(static_cast<int>(corner));
    }
    short_ += polygon_.size() < 3;
    triangulate_polygon(polygon_, mesh_.vertices, mesh_.triangles);
  }

  /// Each three that follow one another are a triangle, every other one turned; -1 ends a strip.
  void take_strips() {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (corners_[i] == -1.0) begin = i + 1;
      if (i < begin + 2) continue;
      const bool turned = (i - begin) % 2 == 1;
      const std::array three = {corners_[turned ? i - 1 : i - 2], corners_[turned ? i - 2 : i - 1],
                                corners_[i]};
      take_polygon(three);
    }
  }

  /// Of the triangles from `first` on: their own where faces have some, else that of the corners.
  void add_colours(std::size_t first, const std::optional<Vec3>& own) {
    if (!own && colours_.empty()) return;
    for (std::size_t t = first; t < mesh_.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      const Vec3 &x = mesh_.vertices[a], &y = mesh_.vertices[b], &z = mesh_.vertices[c];
      const Vec3 colour = own ? *own : Vec3((colours_[a] + colours_[b] + colours_[c]) / 3.0);
      colour_.add(colour, 0.5 * (y - x).cross(z - x).norm());
      append_plain(colour, painted_);
      CornerPaint* const corner = &*(painted_.paint.end() - 3);
      for (int k = 0; k < 3 && !own; ++k)
        corner[k].colour = to_channels(colours_[mesh_.triangles[t][k]]);
    }
  }

  const std::string& path_;
  PlyHeader header_;
  Body body_;
  SurfaceMesh mesh_;
  Vec3Array colours_;  ///< of the vertices, where they have some
  MeanColour colour_;
  ImportedPart painted_;  ///< paint alone, of the triangles so far
  WrongFaces wrong_;
  int short_ = 0;
  long faces_ = 0;
  std::vector<double> row_, corners_, passed_over_;
  std::vector<int> polygon_;
};

}  // namespace

ImportedScene read_ply(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return Ply(path, bytes).read();
}

}  // namespace palpate::authoring
