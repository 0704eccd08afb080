// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/container.h"

#include <stdexcept>

#include "palpate/scenario/archive.h"
#include "palpate/scenario/manifest.h"
#include "palpate/scenario/whole_file.h"
#include "palpate/sim/base/error.h"

namespace palpate::scenario {
namespace {

/// The first number of an array of floats that is not finite [IEEE 754: all exponent bits set].
std::optional<std::size_t> find_not_finite(const Array& array) noexcept {
  if (array.dtype != Dtype::f4 && array.dtype != Dtype::f8) return std::nullopt;
  const std::size_t width = width_of(array.dtype);
  const int low_bits = array.dtype == Dtype::f8 ? 0xf0 : 0x80;
  for (std::size_t at = width; at <= array.bytes.size(); at += width) {
    const std::uint8_t high = array.bytes[at - 1], low = array.bytes[at - 2];
    if ((high & 0x7f) == 0x7f && (low & low_bits) == low_bits) return at / width - 1;
  }
  return std::nullopt;
}

Array read_array(const ArchiveReader& archive, const std::string& name, const ArrayEntry& entry,
                 const std::string& file) {
  const auto at = archive.entries().find(name);
  if (at == archive.entries().end()) {
    throw FileError(file, name, "no such array", "the one the manifest names");
  }
  const std::size_t size = *size_of(entry.dtype, entry.shape);
  if (at->second.size != size) {
    throw FileError(file, name, std::to_string(at->second.size) + " bytes",
                    std::to_string(size) + ", which its shape needs");
  }
  Array array{entry.dtype, entry.shape, archive.read(name)};
  const std::string sha256 = compute_sha256(array.bytes);
  if (sha256 != entry.sha256) {
    throw FileError(file, name, "SHA-256 " + sha256.substr(0, 12) + "...",
                    entry.sha256.substr(0, 12) + "..., as the manifest says");
  }
  if (const auto number = find_not_finite(array)) {
    throw FileError(file, name,
                    "number " + std::to_string(*number) + " that is infinite or not a number",
                    "finite numbers");
  }
  return array;
}

void check_array(const std::string& name, const Array& array) {
  const auto size = size_of(array.dtype, array.shape);
  if (!size || *size != array.bytes.size()) {
    throw std::invalid_argument("container: " + name + ": got " +
                                std::to_string(array.bytes.size()) + " bytes, expected " +
                                (size ? std::to_string(*size) : "a smaller shape"));
  }
  if (const auto number = find_not_finite(array)) {
    throw std::invalid_argument("container: " + name + ": got number " + std::to_string(*number) +
                                " that is infinite or not a number, expected finite numbers");
  }
}

}  // namespace

Container unpack_container(std::span<const std::uint8_t> bytes, const std::string& file,
                           const std::string& format, int newest_version) {
  const ArchiveReader archive(bytes, file);
  const auto at = archive.entries().find(kManifestName);
  if (at == archive.entries().end()) throw FileError(file, "", "no manifest.json", "one");
  if (at->second.size > kMostManifestBytes) {
    throw FileError(file, kManifestName, std::to_string(at->second.size) + " bytes",
                    "at most " + std::to_string(kMostManifestBytes));
  }
  const Bytes text = archive.read(kManifestName);
  Manifest manifest = parse_manifest({reinterpret_cast<const char*>(text.data()), text.size()},
                                     file, format, newest_version);
  for (const auto& [name, entry] : archive.entries()) {
    if (name == kManifestName || manifest.arrays.contains(name)) continue;
    throw FileError(file, "", "an entry that the manifest does not name", "none such");
  }
  Container container{manifest.format,
                      manifest.version,
                      std::move(manifest.content),
                      {},
                      std::move(manifest.written_by)};
  for (const auto& [name, entry] : manifest.arrays) {
    container.arrays.emplace(name, read_array(archive, name, entry, file));
  }
  return container;
}

Bytes pack_container(const Container& container) {
  Manifest manifest{
      container.format, container.version, "palpate " PALPATE_VERSION, container.content, {}};
  std::vector<Stored> files(1);
  for (const auto& [name, array] : container.arrays) {
    check_array(name, array);
    manifest.arrays[name] = {array.dtype, array.shape, compute_sha256(array.bytes)};
    files.push_back({name, array.bytes});
  }
  const std::string text = print_manifest(manifest);
  files[0] = {kManifestName, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}};
  return pack_archive(files);
}

Container read_container(const std::string& path, const std::string& format, int newest_version) {
  return unpack_container(read_whole(path, kMostFileBytes), path, format, newest_version);
}

void write_container(const std::string& path, const Container& container) {
  write_whole(path, pack_container(container));
}

}  // namespace palpate::scenario
