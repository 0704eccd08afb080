// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "palpate/scenario/container.h"

// Not installed: manifest.json, what a container says of itself.

namespace palpate::scenario {

inline constexpr const char* kManifestName = "manifest.json";

/// An array as the manifest knows it.
struct ArrayEntry {
  Dtype dtype = Dtype::u1;
  std::vector<std::int64_t> shape;
  std::string sha256;  ///< 64 hexadecimal digits
};

struct Manifest {
  std::string format;
  int version = 1;
  std::string written_by;
  std::string content;
  std::map<std::string, ArrayEntry, std::less<>> arrays;
};

/// Throws FileError for anything but a sound manifest of `format`, `newest_version` or older, whose
/// arrays are within the limits.
Manifest parse_manifest(std::string_view text, const std::string& file, const std::string& format,
                        int newest_version);

/// Throws std::invalid_argument for what parse_manifest would refuse.
std::string print_manifest(const Manifest& manifest);

/// Bytes of an array of this shape, none for a negative extent or more than kMostArrayBytes.
std::optional<std::size_t> size_of(Dtype dtype, const std::vector<std::int64_t>& shape) noexcept;

/// What is wrong with the name of an array, or none.
std::optional<std::string> find_name_problem(std::string_view name);

/// 64 hexadecimal digits.
std::string compute_sha256(std::span<const std::uint8_t> bytes);

}  // namespace palpate::scenario
