// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/read_mesh_child/pictures.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "palpate/authoring/read_mesh_child/gltf_head.h"

namespace palpate::authoring {
namespace {

// together with the mesh they go through a pipe that has room for 400 MB
constexpr std::size_t kMostBytes = 150'000'000;

std::string make_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 32) c = ' ';
  }
  return text.substr(0, 200);
}

}  // namespace

int Pictures::find(const std::string& reference) {
  const auto known = numbers_.find(reference);
  if (known != numbers_.end()) return known->second;
  std::string plain = reference;
  std::replace(plain.begin(), plain.end(), '\\', '/');
  for (const std::string& name : {plain, decode_reference(plain)}) {
    const std::filesystem::path file = folder_.folder() / name;
    if (!folder_.holds(file)) continue;
    std::error_code problem;
    const auto size = std::filesystem::file_size(file, problem);
    if (problem || size > kMostBytes - bytes_) {
      large_.insert(make_line(name));
      return numbers_[reference] = -1;
    }
    std::ifstream in(file, std::ios::binary);
    std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    return numbers_[reference] = keep(make_line(name), std::move(bytes));
  }
  missing_.insert(make_line(reference));
  return numbers_[reference] = -1;
}

int Pictures::add(const std::string& name, const char* bytes, std::size_t size) {
  const auto known = numbers_.find(name);
  if (known != numbers_.end()) return known->second;
  if (size > kMostBytes - bytes_) {
    large_.insert(make_line(name));
    return numbers_[name] = -1;
  }
  return numbers_[name] = keep(make_line(name), {bytes, bytes + size});
}

int Pictures::keep(const std::string& name, std::vector<char> bytes) {
  bytes_ += bytes.size();
  pictures_.push_back({name, std::move(bytes)});
  return static_cast<int>(pictures_.size()) - 1;
}

void Pictures::settle(ImportedScene& scene) {
  scene.pictures = std::move(pictures_);
  for (const std::string& name : missing_) {
    scene.notes.push_back("the picture " + name + " is not beside it or below its folder");
  }
  for (const std::string& name : large_) {
    scene.notes.push_back("the picture " + name +
                          " is too large: at most 150 MB of them are taken");
  }
}

std::array<float, 3> to_channels(const Vec3& colour) {
  const auto cut = [](double c) { return static_cast<float>(std::clamp(c, 0.0, 1.0)); };
  return {cut(colour[0]), cut(colour[1]), cut(colour[2])};
}

void append_plain(const Vec3& colour, ImportedPart& part) {
  CornerPaint corner;
  corner.colour = to_channels(colour);
  part.paint.insert(part.paint.end(), 3, corner);
  part.pictures.push_back(-1);
}

void drop_plain_paint(ImportedPart& part) {
  const auto has_picture = [](int picture) { return picture >= 0; };
  const auto differs = [&](const CornerPaint& corner) {
    return corner.colour != part.paint.front().colour;
  };
  if (std::any_of(part.pictures.begin(), part.pictures.end(), has_picture)) return;
  if (std::any_of(part.paint.begin(), part.paint.end(), differs)) return;
  part.paint.clear();
  part.pictures.clear();
}

}  // namespace palpate::authoring
