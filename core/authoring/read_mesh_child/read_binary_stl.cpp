// SPDX-License-Identifier: GPL-3.0-or-later
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "palpate/authoring/file_signature.h"
#include "palpate/authoring/read_mesh_child/foreign_formats.h"

namespace palpate::authoring {
namespace {

constexpr std::size_t kHeader = 80, kPreamble = 84, kRecord = 50;

// seen in the wild: some dozens; a megabyte more would be another kind of file
constexpr std::size_t kMostTrailing = 4096;

/// A binary file of one triangle or more has a zero among so many bytes.
constexpr std::size_t kLookedAt = 512;

/// Text begins with "solid"; some programs begin a binary header so too, but then bytes that no
/// text has are near.
bool starts_as_text(const std::string& bytes) {
  const std::size_t begin = bytes.starts_with("\xef\xbb\xbf") ? 3 : 0;  // of text in UTF-8
  const std::size_t word = bytes.find_first_not_of(" \t\r\n", begin);
  if (word == std::string::npos) return false;
  std::string first = bytes.substr(word, 5);
  for (char& c : first) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return first == "solid" && bytes.substr(0, kLookedAt).find('\0') == std::string::npos;
}

/// What the count says; where it says none, or all that it can, as programs leave it that write
/// while they scan, as many as there are.
std::size_t find_count(const std::string& bytes, std::string& note) {
  std::uint32_t stated = 0;
  std::memcpy(&stated, bytes.data() + kHeader, sizeof stated);
  const std::size_t there = (bytes.size() - kPreamble) / kRecord;
  const bool is_left_open = stated == 0 || stated == std::numeric_limits<std::uint32_t>::max();
  if (!is_left_open || there == 0) return stated;
  note = "states " + std::to_string(stated) + " triangles, and " + std::to_string(there) +
         " were read";
  return there;
}

std::string read_bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes(std::filesystem::file_size(path), '\0');
  if (!in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    throw FileError(path, "", "a file that cannot be read", "a readable STL file");
  }
  return bytes;
}

SurfaceMesh read_records(const char* from, std::size_t count) {
  SurfaceMesh mesh;
  for (std::size_t t = 0; t < count; ++t) {
    float numbers[12];  // a normal, which the corners tell better, and three corners
    std::memcpy(numbers, from + t * kRecord, sizeof numbers);
    const int first = static_cast<int>(3 * t);
    for (int c = 1; c <= 3; ++c) {
      mesh.vertices.emplace_back(numbers[3 * c], numbers[3 * c + 1], numbers[3 * c + 2]);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

}  // namespace

std::optional<ImportedScene> read_binary_stl(const std::string& path) {
  const std::string bytes = read_bytes(path);
  if (bytes.size() < kPreamble) {
    if (starts_as_text(bytes)) return std::nullopt;
    throw FileError(path, "header", std::to_string(bytes.size()) + " bytes",
                    "84 bytes of header, or text that begins with 'solid'");
  }
  std::string note;
  const std::size_t count = find_count(bytes, note);
  const std::size_t wanted = kPreamble + count * kRecord;
  if (bytes.size() != wanted && starts_as_text(bytes)) return std::nullopt;
  if (bytes.size() < wanted || bytes.size() > wanted + kMostTrailing) {
    throw FileError(
        path, "triangle count",
        std::to_string(count) + " triangles in " + std::to_string(bytes.size()) + " bytes",
        std::to_string(wanted) + " bytes for so many");
  }

  ImportedScene scene{};
  if (bytes.compare(0, std::strlen(kFileSignature), kFileSignature) == 0) {
    scene.unit = "m";
    scene.up = "z";
  }
  if (!note.empty()) scene.notes.push_back(note);
  if (bytes.size() > wanted) {
    scene.notes.push_back(std::to_string(bytes.size() - wanted) +
                          " bytes after the last triangle were left alone");
  }
  scene.parts.push_back(
      {std::filesystem::path(path).stem().string(), read_records(bytes.data() + kPreamble, count)});
  return scene;
}

}  // namespace palpate::authoring
