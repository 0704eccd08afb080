// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/read_mesh_child/gltf_head.h"

#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "palpate/sim/base/error.h"

namespace palpate::authoring {
namespace {

/// How vertices may be stored that assimp 5.2 takes for something else, and does not say so.
constexpr const char* kMisread[] = {"EXT_meshopt_compression", "KHR_mesh_quantization"};

/// The text of the scene: all of a .gltf, the first chunk of a .glb.
std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  char head[20] = {};
  in.read(head, sizeof head);
  if (in.gcount() == sizeof head && std::memcmp(head, "glTF", 4) == 0) {
    std::uint32_t size = 0;
    std::memcpy(&size, head + 12, sizeof size);
    in.seekg(0, std::ios::end);
    const auto left = static_cast<std::uint64_t>(in.tellg()) - sizeof head;
    std::string text(std::min<std::uint64_t>(size, left), '\0');
    in.seekg(sizeof head);
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    return text;
  }
  in.clear();
  in.seekg(0);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

void check_gltf(const std::string& path, std::vector<std::string>& notes) {
  const auto scene = nlohmann::json::parse(read_text(path), nullptr, false);
  if (!scene.is_object()) return;
  const nlohmann::json::json_pointer place("/asset/version");
  const auto version = scene.contains(place) ? scene.at(place) : nlohmann::json();
  if (version.is_string() && version.get<std::string>().starts_with("1.")) {
    throw FileError(path, "asset", "version " + version.get<std::string>(),
                    "2.0: glTF 1 is read by hardly any program; save it as glTF 2.0 or OBJ");
  }
  const auto needed = scene.find("extensionsRequired");
  if (needed != scene.end() && needed->is_array()) {
    for (const char* const name : kMisread) {
      if (std::find(needed->begin(), needed->end(), name) == needed->end()) continue;
      throw FileError(path, "extensionsRequired", name,
                      "vertices as plain numbers: save it without that compression");
    }
  }
  const auto scenes = scene.find("scenes");
  if (scenes != scene.end() && scenes->is_array() && scenes->size() > 1) {
    notes.push_back("of its " + std::to_string(scenes->size()) + " scenes the usual one was read");
  }
}

std::string decode_reference(const std::string& reference) {
  std::string name;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    unsigned letter = 0;
    const char* const digits = reference.data() + i + 1;
    if (reference[i] == '%' && i + 2 < reference.size() &&
        std::from_chars(digits, digits + 2, letter, 16).ptr == digits + 2) {
      name += static_cast<char>(letter);
      i += 2;
    } else {
      name += reference[i];
    }
  }
  return name;
}

}  // namespace palpate::authoring
