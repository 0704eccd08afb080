// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/scene_stream.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace palpate::authoring {
namespace {

/// Bytes of the UTF-8 letter that `text` begins with, 0 where that is none.
std::size_t measure_letter(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t size = first < 0x80   ? 1
                           : first < 0xc2 ? 0  // a continuation, or a letter written too long
                           : first < 0xe0 ? 2
                           : first < 0xf0 ? 3
                           : first < 0xf5 ? 4
                                          : 0;
  if (size == 0 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
  const bool surrogate = first == 0xed && byte(1) >= 0xa0;
  const bool beyond = first == 0xf4 && byte(1) >= 0x90;
  return overlong || surrogate || beyond ? 0 : size;
}

/// A name out of a file of any age and alphabet, with a question mark for what is no letter.
std::string make_utf8(std::string_view text) {
  std::string letters;
  while (!text.empty()) {
    const std::size_t size = measure_letter(text);
    if (size == 0) {
      letters += '?';
    } else {
      letters += text.substr(0, size);
    }
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return letters;
}

class Reader {
 public:
  Reader(const std::string& file, std::span<const char> bytes) : file_(file), bytes_(bytes) {}

  template <class T>
  T take() {
    T value;
    std::memcpy(&value, take_bytes(1, sizeof(T)), sizeof(T));
    return value;
  }

  std::string take_text() {
    const auto size = take<std::uint32_t>();
    return make_utf8({take_bytes(size, 1), size});
  }

  template <class T>
  std::vector<T> take_all() {
    const auto count = take<std::uint32_t>();
    const char* from = take_bytes(count, sizeof(T));
    std::vector<T> values(count);
    if (count > 0) std::memcpy(static_cast<void*>(values.data()), from, count * sizeof(T));
    return values;
  }

  std::vector<std::string> take_texts() {
    std::vector<std::string> texts;
    for (auto count = take<std::uint32_t>(); count > 0; --count) texts.push_back(take_text());
    return texts;
  }

  std::optional<std::array<double, 3>> take_colour() {
    const auto channels = take_all<double>();
    if (channels.empty()) return std::nullopt;
    const auto is_wrong = [](double c) { return !(c >= 0.0 && c <= 1.0); };
    if (channels.size() != 3 || std::any_of(channels.begin(), channels.end(), is_wrong)) refuse();
    return std::array{channels[0], channels[1], channels[2]};
  }

  void expect_magic() {
    if (take<std::uint64_t>() != kStreamMagic) refuse();
  }

  void expect_end() const {
    if (!bytes_.empty()) refuse();
  }

 private:
  const char* take_bytes(std::size_t count, std::size_t size) {
    if (count > bytes_.size() / size) refuse();
    const char* from = bytes_.data();
    bytes_ = bytes_.subspan(count * size);
    return from;
  }

  [[noreturn]] void refuse() const {
    throw FileError(file_, "", "a reader that stopped half way", "a mesh file it can read whole");
  }

  const std::string& file_;
  std::span<const char> bytes_;
};

std::optional<std::string> stated(std::string text) {
  if (text.empty()) return std::nullopt;
  return text;
}

}  // namespace

ImportedScene decode_scene(const std::string& file, std::span<const char> bytes) {
  Reader in(file, bytes);
  in.expect_magic();
  if (in.take<std::uint32_t>() != kStreamScene) {
    const std::string where = in.take_text(), got = in.take_text(), expected = in.take_text();
    throw FileError(file, where, got, expected);
  }

  ImportedScene scene;
  scene.file = file;
  scene.unit = stated(in.take_text());
  scene.up = stated(in.take_text());
  scene.notes = in.take_texts();
  for (auto parts = in.take<std::uint32_t>(); parts > 0; --parts) {
    ImportedPart part;
    part.name = in.take_text();
    part.groups = in.take_texts();
    part.colour = in.take_colour();
    part.mesh.vertices = in.take_all<Vec3>();
    part.mesh.triangles = in.take_all<Triangle>();
    part.paint = in.take_all<CornerPaint>();
    part.pictures = in.take_all<int>();
    scene.parts.push_back(std::move(part));
  }
  for (auto pictures = in.take<std::uint32_t>(); pictures > 0; --pictures) {
    const std::string name = in.take_text();
    scene.pictures.push_back({name, in.take_all<char>()});
  }
  scene.filling.vertices = in.take_all<Vec3>();
  scene.filling.tetrahedra = in.take_all<std::array<int, 4>>();
  in.expect_magic();
  in.expect_end();
  return scene;
}

}  // namespace palpate::authoring
