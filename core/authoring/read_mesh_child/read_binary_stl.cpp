// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "palpate/authoring/file_signature.h"
#include "palpate/authoring/read_mesh_child/foreign_formats.h"
#include "palpate/authoring/read_mesh_child/wrong_faces.h"

namespace palpate::authoring {
namespace {

constexpr std::size_t kHeader = 80, kPreamble = 84, kRecord = 50;

/// A binary file of one triangle or more has a zero among so many bytes.
constexpr std::size_t kLookedAt = 512;
/// Where text has its first word, behind whatever stands above it.
constexpr std::size_t kTextLookedAt = 4096;

/// Some programs begin a binary header with "solid" too, but then bytes that no text has are near.
bool starts_as_text(const std::string& bytes) {
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) return true;
  const std::size_t first = bytes.substr(0, kLookedAt).find('\0');
  // a text may be filled up with them to the end
  return first == std::string::npos ||
         (first > kPreamble && bytes.find_first_not_of('\0', first) == std::string::npos);
}

std::string show_start(const std::string& bytes) {
  std::string shown = bytes.substr(0, std::min(bytes.find_first_of("\r\n"), std::size_t{40}));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
  }
  return "'" + shown + "'";
}

/// Whether another block begins here, of as many triangles as it says.
bool begins_block(const std::string& bytes, std::size_t begin) {
  if (bytes.size() < begin + kPreamble + kRecord) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + begin + kHeader, sizeof count);
  return count > 0 && count <= (bytes.size() - begin - kPreamble) / kRecord;
}

/// What the count says; where it says none, or all that it can, as programs leave it that write
/// while they scan, or the file is whole with more, as many as there are.
std::size_t find_count(const std::string& bytes, std::size_t begin, std::string& note) {
  std::uint32_t stated = 0;
  std::memcpy(&stated, bytes.data() + begin + kHeader, sizeof stated);
  const std::size_t there = (bytes.size() - begin - kPreamble) / kRecord;
  const bool is_left_open = stated == 0 || stated == std::numeric_limits<std::uint32_t>::max();
  const std::size_t end = begin + kPreamble + std::size_t{stated} * kRecord;
  const bool goes_on =
      there > stated && (bytes.size() - end) % kRecord == 0 && !begins_block(bytes, end);
  if ((!is_left_open && !goes_on) || there == 0) return stated;
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

/// The records of one block, which there may be several of. Where fewer are there than are stated,
/// the file ends too soon.
void take_block(const std::string& path, const std::string& bytes, std::size_t begin,
                ImportedScene& scene, std::size_t& end) {
  std::string note;
  const std::size_t count = find_count(bytes, begin, note);
  const std::size_t there = std::min(count, (bytes.size() - begin - kPreamble) / kRecord);
  if (!note.empty()) scene.notes.push_back(note);
  WrongFaces wrong;
  if (there < count) {
    wrong.add({path, "triangle count",
               std::to_string(count) + " triangles in " + std::to_string(bytes.size()) + " bytes",
               std::to_string(begin + kPreamble + count * kRecord) + " bytes for so many"},
              static_cast<long>(count - there));
  }
  wrong.settle(static_cast<long>(count), scene.notes);
  const std::string stem = std::filesystem::path(path).stem().string();
  const std::size_t number = scene.parts.size() + 1;
  scene.parts.push_back({number == 1 ? stem : stem + " (" + std::to_string(number) + ")",
                         read_records(bytes.data() + begin + kPreamble, there)});
  end = begin + kPreamble + there * kRecord;
}

}  // namespace

std::optional<ImportedScene> read_binary_stl(const std::string& path) {
  const std::string bytes = read_bytes(path);
  const std::string wanted = "84 bytes of header, or text that begins with 'solid'";
  if (starts_as_text(bytes)) {
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) return std::nullopt;
    std::string text = bytes.substr(0, kTextLookedAt);
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (text.find("solid") != std::string::npos || text.find("facet") != std::string::npos) {
      return std::nullopt;
    }
    throw FileError(path, "header", show_start(bytes), wanted);
  }
  if (bytes.size() < kPreamble) {
    throw FileError(path, "header", std::to_string(bytes.size()) + " bytes", wanted);
  }
  ImportedScene scene{};
  if (bytes.compare(0, std::strlen(kFileSignature), kFileSignature) == 0) {
    scene.unit = "m";
    scene.up = "z";
  }
  std::size_t end = 0;
  do take_block(path, bytes, end, scene, end);
  while (begins_block(bytes, end));
  if (bytes.size() > end) {
    scene.notes.push_back(std::to_string(bytes.size() - end) +
                          " bytes after the last triangle were left alone");
  }
  return scene;
}

}  // namespace palpate::authoring
