// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "palpate/authoring/read_mesh_child/foreign_formats.h"
#include "palpate/authoring/read_mesh_child/triangulate.h"

namespace palpate::authoring {
namespace {

/// What follows the first line: numbers of four bytes each, the highest byte first, as Geomview
/// writes them.
class Numbers {
 public:
  Numbers(const std::string& path, std::size_t begin) : path_(path) {
    std::ifstream in(path, std::ios::binary);
    in.seekg(static_cast<std::streamoff>(begin));
    bytes_.assign(std::istreambuf_iterator<char>(in), {});
  }

  std::size_t left() const { return (bytes_.size() - at_) / 4; }

  std::int32_t take_int(const char* what) { return std::bit_cast<std::int32_t>(take(what)); }
  double take_float(const char* what) { return std::bit_cast<float>(take(what)); }

  void skip(std::size_t count, const char* what) {
    require(count, what);
    at_ += 4 * count;
  }

  [[noreturn]] void refuse(const std::string& got, const std::string& expected) const {
    throw FileError(path_, "number " + std::to_string(at_ / 4) + " after the first line", got,
                    expected);
  }

 private:
  void require(std::size_t count, const char* what) const {
    if (count > left()) refuse("the end of the file", what);
  }

  std::uint32_t take(const char* what) {
    require(1, what);
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes_[at_ + i]);
    at_ += 4;
    return value;
  }

  std::string path_;
  std::vector<char> bytes_;
  std::size_t at_ = 0;
};

void take_vertices(Numbers& numbers, const OffKind& kind, std::int32_t count, Vec3Array& to) {
  // one at a time: a count is only believed as far as the file goes
  for (std::int32_t v = 0; v < count; ++v) {
    const double x = numbers.take_float("a vertex"), y = numbers.take_float("a vertex"),
                 z = numbers.take_float("a vertex");
    const double weight = kind.weighted ? numbers.take_float("a vertex's weight") : 1.0;
    numbers.skip((kind.normals ? 3 : 0) + (kind.colours ? 4 : 0) + (kind.texture ? 2 : 0),
                 "what belongs to a vertex");
    to.push_back(Vec3(x, y, z) / weight);
  }
}

/// The corners of a face, and past its colours, which some writers leave out behind the last.
void take_face(Numbers& numbers, std::int32_t vertices, bool last, std::vector<int>& corners) {
  const std::int32_t count = numbers.take_int("a face");
  if (count < 0 || static_cast<std::size_t>(count) > numbers.left()) {
    numbers.refuse(std::to_string(count) + " corners", "as many as the file has");
  }
  corners.clear();
  for (std::int32_t c = 0; c < count; ++c) {
    corners.push_back(numbers.take_int("a corner"));
    if (corners.back() >= 0 && corners.back() < vertices) continue;
    numbers.refuse("vertex " + std::to_string(corners.back()),
                   "an index below " + std::to_string(vertices));
  }
  if (last && numbers.left() == 0) return;
  const std::int32_t colours = numbers.take_int("how many numbers a colour has");
  if (colours < 0 || colours > 4) {
    numbers.refuse(std::to_string(colours) + " numbers of a colour", "0 to 4");
  }
  numbers.skip(static_cast<std::size_t>(colours), "a colour");
}

}  // namespace

SurfaceMesh read_binary_off(const std::string& path, const OffKind& kind, std::size_t begin,
                            int& left_out) {
  Numbers numbers(path, begin);
  const std::int32_t vertices = numbers.take_int("how many vertices there are"),
                     faces = numbers.take_int("how many faces there are");
  numbers.skip(1, "how many edges there are");
  if (vertices < 0 || faces < 0) {
    numbers.refuse(std::to_string(std::min(vertices, faces)), "counts of vertices and faces");
  }
  SurfaceMesh mesh;
  take_vertices(numbers, kind, vertices, mesh.vertices);
  std::vector<int> corners;
  for (std::int32_t f = 0; f < faces; ++f) {
    take_face(numbers, vertices, f == faces - 1, corners);
    left_out += corners.size() < 3;
    triangulate_polygon(corners, mesh.vertices, mesh.triangles);
  }
  return mesh;
}

}  // namespace palpate::authoring
