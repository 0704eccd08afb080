// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/read_mesh_child/ply_header.h"

#include "palpate/authoring/read_mesh_child/text_line.h"
#include "palpate/sim/base/error.h"

namespace palpate::authoring {
namespace {

std::optional<PlyType> find_type(std::string_view word) {
  struct Row {
    const char *old_name, *name;
    PlyType type;
  };
  constexpr Row rows[] = {
      {"char", "int8", {1, false, true}},    {"uchar", "uint8", {1, false, false}},
      {"short", "int16", {2, false, true}},  {"ushort", "uint16", {2, false, false}},
      {"int", "int32", {4, false, true}},    {"uint", "uint32", {4, false, false}},
      {"float", "float32", {4, true, true}}, {"double", "float64", {8, true, true}},
      {"long", "int64", {8, false, true}},   {"ulong", "uint64", {8, false, false}},
  };  // the last row is of some programs only
  for (const Row& row : rows) {
    if (word == row.old_name || word == row.name) return row.type;
  }
  return std::nullopt;
}

/// One line of the header after the other.
class Header {
 public:
  Header(const std::string& path, const std::string& bytes) : path_(path), bytes_(bytes) {}

  PlyHeader read() {
    bool is_first = true;
    while (take_line()) {
      if (is_first && line_ != "ply") refuse("ply");
      is_first = false;
      if (line_ == "end_header") {
        if (!has_format_) refuse("format ascii, binary_little_endian or binary_big_endian before");
        header_.end = at_;
        return header_;
      }
      take_words(TextLine(line_));
    }
    line_ = "the end of the file";
    refuse("end_header");
  }

 private:
  /// Lines end as on Unix, Windows or, where no other end is near, old Macs.
  bool take_line() {
    if (at_ >= bytes_.size()) return false;
    ++header_.lines;
    const std::size_t end = bytes_.find_first_of("\r\n", at_);
    line_ = bytes_.substr(at_, end - at_);
    line_.resize(line_.find_last_not_of(" \t") + 1);
    if (end == std::string::npos) {
      at_ = bytes_.size();
    } else {
      at_ = end + (bytes_.compare(end, 2, "\r\n") == 0 ? 2 : 1);
    }
    return true;
  }

  void take_words(TextLine line) {
    const std::string_view word = line.take_word();
    if (word == "format") {
      take_format(line.take_word());
    } else if (word == "element") {
      PlyElement element{std::string(line.take_word())};
      if (!line.take(element.count) || element.count < 0) refuse("element NAME COUNT");
      header_.elements.push_back(std::move(element));
    } else if (word == "property") {
      take_property(line);
    } else if (word == "comment") {
      header_.has_texture = header_.has_texture || line.take_word() == "TextureFile";
    } else if (!word.empty() && word != "ply" && word != "obj_info") {
      refuse("format, element, property, comment or end_header");
    }
  }

  void take_format(std::string_view word) {
    has_format_ = true;
    if (word == "binary_little_endian") {
      header_.order = PlyOrder::little;
    } else if (word == "binary_big_endian") {
      header_.order = PlyOrder::big;
    } else if (word != "ascii") {
      refuse("format ascii, binary_little_endian or binary_big_endian");
    }
  }

  void take_property(TextLine line) {
    std::string_view word = line.take_word();
    PlyProperty property;
    if (word == "list") {
      property.count = find_type(line.take_word());
      if (!property.count || property.count->is_real) refuse("a type of whole numbers after list");
      word = line.take_word();
    }
    const auto type = find_type(word);
    if (!type || header_.elements.empty()) refuse("a property of a known type, of an element");
    property.type = *type;
    property.name = line.take_word();
    header_.elements.back().properties.push_back(std::move(property));
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    std::string shown = line_.substr(0, 40);
    for (char& c : shown) {
      if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
    }
    throw FileError(path_, "line " + std::to_string(header_.lines), "'" + shown + "'", expected);
  }

  const std::string& path_;
  const std::string& bytes_;
  std::size_t at_ = 0;
  std::string line_;
  bool has_format_ = false;
  PlyHeader header_;
};

}  // namespace

PlyHeader read_ply_header(const std::string& path, const std::string& bytes) {
  return Header(path, bytes).read();
}

}  // namespace palpate::authoring
