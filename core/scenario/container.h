// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

/// Files that hold a JSON document and arrays: `.palpate`, what a designer publishes, and `.organ`,
/// what a designer works on. CONTAINER.md describes the bytes.
namespace palpate::scenario {

using Bytes = std::vector<std::uint8_t>;

// What a reader accepts at most, whatever a file says of itself. Organs that tick a thousand times
// a second need a hundredth of it.
inline constexpr std::size_t kMostFileBytes = std::size_t{128} << 20;
inline constexpr std::size_t kMostArrayBytes = std::size_t{128} << 20;  ///< of all arrays together
inline constexpr std::size_t kMostManifestBytes = std::size_t{4} << 20;
inline constexpr std::size_t kMostArrays = 1024;
inline constexpr std::size_t kMostDimensions = 4;
inline constexpr std::size_t kMostNameBytes = 100;
inline constexpr int kMostDepth = 64;  ///< of lists and objects within each other in the JSON

/// What one number of an array is, named as in NumPy.
enum class Dtype { u1, i4, i8, f4, f8 };

/// Bytes of one number.
std::size_t width_of(Dtype dtype) noexcept;

/// A block of numbers. Floats are finite.
struct Array {
  Dtype dtype = Dtype::u1;
  std::vector<std::int64_t> shape = {0};
  Bytes bytes;  ///< little-endian, the last index fastest

  bool operator==(const Array&) const = default;
};

/// By name: parts of small letters, digits, `_`, `-` and `.`, joined by `/`.
using Arrays = std::map<std::string, Array, std::less<>>;

/// All that a file holds.
struct Container {
  std::string format;          ///< "palpate" or "organ"
  int version = 1;             ///< of the format
  std::string content = "{}";  ///< JSON: one object
  Arrays arrays;
  std::string written_by;  ///< filled by the reader: which program and version wrote the file
};

/// Reads a file of `format` whose version is `newest_version` or older; older ones come as they
/// are. Throws FileError for everything else and for everything that is wrong.
Container read_container(const std::string& path, const std::string& format, int newest_version);

/// Writes to a temporary name beside `path`, syncs, renames, syncs the folder: whatever happens,
/// `path` is what it was or all of the new file. Equal containers give equal bytes.
/// Throws std::invalid_argument for what a reader would refuse, FileError where the disk refuses.
void write_container(const std::string& path, const Container& container);

/// The same without a disk; `file` is what refusals call it.
Container unpack_container(std::span<const std::uint8_t> bytes, const std::string& file,
                           const std::string& format, int newest_version);
Bytes pack_container(const Container& container);

}  // namespace palpate::scenario
