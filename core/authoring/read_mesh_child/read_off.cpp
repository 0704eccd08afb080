// SPDX-License-Identifier: GPL-3.0-or-later
#include <cctype>
#include <filesystem>

#include "palpate/authoring/read_mesh_child/foreign_formats.h"
#include "palpate/authoring/read_mesh_child/mean_colour.h"
#include "palpate/authoring/read_mesh_child/pictures.h"
#include "palpate/authoring/read_mesh_child/text_file.h"
#include "palpate/authoring/read_mesh_child/text_line.h"
#include "palpate/authoring/read_mesh_child/triangulate.h"
#include "palpate/authoring/read_mesh_child/wrong_faces.h"

namespace palpate::authoring {
namespace {

/// The lines of a file that have something in them, comments taken off.
class Lines {
 public:
  explicit Lines(const std::string& path) : path_(path), in_(path) {}

  /// The next line. Refuses the end of the file, where `missing` is still expected.
  TextLine take(const std::string& missing) {
    if (find()) return TextLine(line_);
    throw make_error("the end of the file", missing);
  }

  /// Whether there is another line, which text() is then.
  bool find() {
    while (in_.take_line(line_)) {
      if (++number_ == 1) drop_byte_order_mark(line_);
      drop_comment();
      if (line_.find_first_not_of(" \t\r") != std::string::npos) return true;
    }
    return false;
  }

  FileError make_error(const std::string& got, const std::string& expected) const {
    return {path_, "line " + std::to_string(number_), got, expected};
  }

  [[noreturn]] void refuse(const std::string& got, const std::string& expected) const {
    throw make_error(got, expected);
  }

  const std::string& text() const { return line_; }
  bool is_last() const { return in_.is_at_end(); }

  /// [byte] Where the next line begins.
  std::size_t tell() const { return in_.tell(); }

 private:
  /// It begins with a word: 1.#IND is a number, though none that is anywhere.
  void drop_comment() {
    for (std::size_t at = line_.find('#'); at != std::string::npos; at = line_.find('#', at + 1)) {
      if (at > 0 && line_[at - 1] != ' ' && line_[at - 1] != '\t') continue;
      line_.resize(at);
      return;
    }
  }

  std::string path_;
  TextFile in_;
  std::string line_;
  int number_ = 0;
};

/// The head of an OFF: [ST][C][N][4]OFF; the dimension of its vertices is 4 or 3.
struct Head {
  OffKind kind;
  bool binary = false;  ///< then the counts are not read yet
  long vertices = 0, faces = 0;
};

bool take_prefix(std::string_view& word, std::string_view prefix) {
  if (!word.starts_with(prefix)) return false;
  word.remove_prefix(prefix.size());
  return true;
}

void take_counts(Lines& lines, TextLine line, Head& head) {
  if (!line.take(head.vertices) || !line.take(head.faces) || head.vertices < 0 || head.faces < 0) {
    lines.refuse("'" + lines.text().substr(0, 40) + "'", "how many vertices and faces there are");
  }
}

/// The word may be missing, and the counts may stand behind it on its line.
Head take_head(Lines& lines) {
  Head head;
  TextLine line = lines.take("OFF, and the counts of vertices and faces");
  TextLine first = line;
  std::string_view word = first.take_word();
  double number = 0.0;
  if (TextLine::parse(word, number)) {
    take_counts(lines, line, head);
    return head;
  }
  const std::string said(word);
  std::string large = said;
  for (char& c : large) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  word = large;
  head.kind.texture = take_prefix(word, "ST");
  head.kind.colours = take_prefix(word, "C");
  head.kind.normals = take_prefix(word, "N");
  head.kind.weighted = take_prefix(word, "4");
  if (word != "OFF") {
    lines.refuse("'" + said.substr(0, 40) + "'", "OFF, COFF, NOFF, STOFF or 4OFF");
  }
  const std::string rest(first.take_rest());
  head.binary = rest.starts_with("BINARY");
  if (head.binary) return head;
  if (rest.empty()) {
    take_counts(lines, lines.take("the counts of vertices and faces"), head);
  } else {
    take_counts(lines, TextLine(rest), head);
  }
  return head;
}

/// Colours of all vertices, of 0 to 1 or of 0 to 255; none once one of them has none.
class Colours {
 public:
  /// Behind the place of a vertex: its normal, where the head says so, and three numbers.
  void take(TextLine& line, const OffKind& kind) {
    Vec3 normal, colour;
    const bool is_there = (!kind.normals || take_three(line, normal)) && take_three(line, colour);
    has_all_ = has_all_ && is_there && colour.allFinite();
    if (has_all_) brightest_ = std::max(brightest_, colour.maxCoeff() > 1.0 ? 255.0 : 1.0);
    colours_.push_back(colour);
  }

  void paint(ImportedPart& part) const {
    if (!has_all_) return;
    MeanColour mean;
    const Vec3Array& x = part.mesh.vertices;
    for (const Triangle& t : part.mesh.triangles) {
      append_plain(Vec3::Ones(), part);
      CornerPaint* const corner = &*(part.paint.end() - 3);
      Vec3 middle = Vec3::Zero();
      for (int c = 0; c < 3; ++c) {
        const Vec3 colour = colours_[t[c]] / brightest_;
        corner[c].colour = to_channels(colour);
        middle += colour / 3.0;
      }
      mean.add(middle, 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm());
    }
    part.colour = mean.find(false);
    drop_plain_paint(part);
  }

 private:
  static bool take_three(TextLine& line, Vec3& three) {
    return line.take(three[0]) && line.take(three[1]) && line.take(three[2]);
  }

  Vec3Array colours_;
  bool has_all_ = true;
  double brightest_ = 1.0;
};

Vec3 take_vertex(Lines& lines, const Head& head, std::size_t taken, Colours& colours) {
  TextLine line =
      lines.take("vertex " + std::to_string(taken) + " of " + std::to_string(head.vertices));
  Vec3 p;
  double weight = 1.0;
  const bool whole = line.take(p.x()) && line.take(p.y()) && line.take(p.z()) &&
                     (!head.kind.weighted || line.take(weight));
  if (!whole) {
    lines.refuse("'" + lines.text().substr(0, 40) + "'",
                 head.kind.weighted ? "a vertex of four numbers" : "a vertex of three numbers");
  }
  if (head.kind.colours) colours.take(line, head.kind);
  return p / weight;
}

/// The corners of one face; what follows them on its line is a colour. False where one of them is
/// no vertex, which is remembered.
bool take_face(const Lines& lines, const Head& head, std::vector<int>& corners, WrongFaces& wrong) {
  TextLine line(lines.text());
  const auto refuse = [&](const std::string& expected) {
    lines.refuse("'" + lines.text().substr(0, 40) + "'", expected);
  };
  long count = 0;
  if (!line.take(count) || count < 0) refuse("how many corners a face has");
  corners.clear();
  for (long c = 0; c < count; ++c) {
    int corner = 0;
    if (!line.take(corner)) {
      if (!lines.is_last()) refuse(std::to_string(count) + " corners");
      wrong.add(lines.make_error("'" + lines.text().substr(0, 40) + "'",
                                 std::to_string(count) + " corners"));
      return false;
    }
    if (corner < 0 || corner >= head.vertices) {
      wrong.add(lines.make_error("vertex " + std::to_string(corner),
                                 "an index below " + std::to_string(head.vertices)));
      return false;
    }
    corners.push_back(corner);
  }
  return true;
}

SurfaceMesh take_text(Lines& lines, const Head& head, int& left_out, Colours& colours,
                      std::vector<std::string>& notes) {
  SurfaceMesh mesh;
  // one at a time: a count is only believed as far as the lines go
  while (static_cast<long>(mesh.vertices.size()) < head.vertices) {
    mesh.vertices.push_back(take_vertex(lines, head, mesh.vertices.size(), colours));
  }
  WrongFaces wrong;
  std::vector<int> corners;
  for (long f = 0; f < head.faces; ++f) {
    if (!lines.find()) {
      const std::string missing = "face " + std::to_string(f) + " of " + std::to_string(head.faces);
      wrong.add(lines.make_error("the end of the file", missing), head.faces - f);
      break;
    }
    if (!take_face(lines, head, corners, wrong)) continue;
    left_out += corners.size() < 3;
    triangulate_polygon(corners, mesh.vertices, mesh.triangles);
  }
  wrong.settle(head.faces, notes);
  return mesh;
}

}  // namespace

ImportedScene read_off(const std::string& path) {
  Lines lines(path);
  const Head head = take_head(lines);
  int left_out = 0;
  ImportedScene scene{};
  Colours colours;
  SurfaceMesh mesh = head.binary ? read_binary_off(path, head.kind, lines.tell(), left_out)
                                 : take_text(lines, head, left_out, colours, scene.notes);
  if (left_out > 0) {
    scene.notes.push_back(std::to_string(left_out) +
                          " faces of fewer than three corners were left out");
  }
  ImportedPart part{std::filesystem::path(path).stem().string(), std::move(mesh)};
  if (head.kind.colours && !head.binary) colours.paint(part);
  if (head.kind.colours && head.binary) {
    scene.notes.emplace_back(
        "the colours of its vertices stay behind: a binary OFF's are not read");
  }
  scene.parts.push_back(std::move(part));
  return scene;
}

}  // namespace palpate::authoring
