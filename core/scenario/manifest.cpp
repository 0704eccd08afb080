// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/manifest.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "palpate/scenario/json_fields.h"
#include "palpate/sim/session/private/record_file.h"

namespace palpate::scenario {
namespace {

constexpr std::size_t kMostWordBytes = 100;  ///< of a format's name and of `written_by`
constexpr std::size_t kDigestDigits = 64;

/// As in NumPy, in the order of Dtype.
constexpr std::array<const char*, 5> kDtypeNames = {"|u1", "<i4", "<i8", "<f4", "<f8"};

std::vector<std::int64_t> read_shape(Fields& entry) {
  const Json& list = entry.any("shape");
  if (!list.is_array() || list.empty() || list.size() > kMostDimensions) {
    entry.refuse("shape", describe(list),
                 "a list of 1 to " + std::to_string(kMostDimensions) + " whole numbers");
  }
  std::vector<std::int64_t> shape;
  for (const Json& extent : list) {
    const bool whole = extent.is_number_unsigned() && extent.get<std::uint64_t>() <= INT64_MAX;
    if (!whole) entry.refuse("shape", describe(extent), "a whole number, 0 or more");
    shape.push_back(extent.get<std::int64_t>());
  }
  return shape;
}

ArrayEntry read_array_entry(Fields entry) {
  ArrayEntry array;
  array.dtype = static_cast<Dtype>(entry.choice(
      "dtype", {kDtypeNames[0], kDtypeNames[1], kDtypeNames[2], kDtypeNames[3], kDtypeNames[4]}));
  array.shape = read_shape(entry);
  array.sha256 = entry.text("sha256", kDigestDigits);
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  if (array.sha256.size() != kDigestDigits ||
      !std::all_of(array.sha256.begin(), array.sha256.end(), is_digit)) {
    entry.refuse("sha256", describe(Json(array.sha256)), "64 hexadecimal digits");
  }
  entry.finish();
  return array;
}

void read_arrays(Fields& fields, const std::string& file, Manifest& manifest) {
  const Json& arrays = fields.any("arrays");
  if (!arrays.is_object()) fields.refuse("arrays", describe(arrays), "an object");
  if (arrays.size() > kMostArrays) {
    fields.refuse("arrays", std::to_string(arrays.size()) + " arrays",
                  "at most " + std::to_string(kMostArrays));
  }
  std::size_t bytes = 0;
  for (const auto& [name, entry] : arrays.items()) {
    if (const auto problem = find_name_problem(name)) {
      fields.refuse("arrays", "the name " + describe(Json(name)) + ", " + *problem,
                    "small letters, digits, _ - and ., in parts joined by /");
    }
    ArrayEntry array =
        read_array_entry(Fields(entry, file, std::string(kManifestName) + ": arrays." + name));
    const auto size = size_of(array.dtype, array.shape);
    if (!size || (bytes += *size) > kMostArrayBytes) {
      fields.refuse("arrays", "arrays of more than " + std::to_string(kMostArrayBytes) + " bytes",
                    "fewer");
    }
    manifest.arrays.emplace(name, std::move(array));
  }
}

}  // namespace

std::size_t width_of(Dtype dtype) noexcept {
  constexpr std::array<std::size_t, 5> widths = {1, 4, 8, 4, 8};
  return widths[static_cast<std::size_t>(dtype)];
}

std::optional<std::size_t> size_of(Dtype dtype, const std::vector<std::int64_t>& shape) noexcept {
  std::size_t size = width_of(dtype);
  for (const std::int64_t extent : shape) {
    // no overflow: both factors are at most 2^27 when they are multiplied
    if (extent < 0 || extent > static_cast<std::int64_t>(kMostArrayBytes)) return std::nullopt;
    size *= static_cast<std::size_t>(extent);
    if (size > kMostArrayBytes) return std::nullopt;
  }
  return size;
}

std::optional<std::string> find_name_problem(std::string_view name) {
  if (name.empty() || name.size() > kMostNameBytes) return "which is empty or too long";
  if (name == kManifestName) return "which is the manifest's own";
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.' ||
           c == '/';
  };
  if (!std::all_of(name.begin(), name.end(), is_allowed)) return "with other characters";
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string_view part = name.substr(begin, end - begin);
    if (part.empty() || part.front() == '.') return "which leads out of the file";
    begin = end + 1;
  }
  return std::nullopt;
}

std::string compute_sha256(std::span<const std::uint8_t> bytes) {
  record_layout::Sha256 sha256;
  sha256.add(bytes);
  std::string digits;
  for (const std::uint8_t byte : sha256.finish()) {
    digits += "0123456789abcdef"[byte >> 4];
    digits += "0123456789abcdef"[byte & 15];
  }
  return digits;
}

Manifest parse_manifest(std::string_view text, const std::string& file, const std::string& format,
                        int newest_version) {
  const Json parsed = parse_object(text, file, kManifestName);
  Fields fields(parsed, file, kManifestName);
  Manifest manifest;
  manifest.format = fields.text("format", kMostWordBytes);
  if (manifest.format != format) {
    fields.refuse("format", describe(Json(manifest.format)), describe(Json(format)));
  }
  manifest.version = static_cast<int>(fields.whole("version", 1, std::numeric_limits<int>::max()));
  // before anything else is checked: a newer file may differ in all the rest
  if (manifest.version > newest_version) {
    fields.refuse(
        "version", std::to_string(manifest.version),
        std::to_string(newest_version) +
            " or older; the file was made by a newer program, which is needed to open it");
  }
  manifest.written_by = fields.text("written_by", kMostWordBytes);
  read_arrays(fields, file, manifest);
  const Json& content = fields.any("content");
  if (!content.is_object()) fields.refuse("content", describe(content), "an object");
  manifest.content = content.dump();
  fields.finish();
  return manifest;
}

std::string print_manifest(const Manifest& manifest) {
  Json arrays = Json::object();
  for (const auto& [name, array] : manifest.arrays) {
    arrays[name] = {{"dtype", kDtypeNames[static_cast<std::size_t>(array.dtype)]},
                    {"shape", array.shape},
                    {"sha256", array.sha256}};
  }
  try {
    const std::string text = print({{"format", manifest.format},
                                    {"version", manifest.version},
                                    {"written_by", manifest.written_by},
                                    {"arrays", std::move(arrays)},
                                    {"content", parse_object(manifest.content, "", "content")}},
                                   "container");
    if (text.size() > kMostManifestBytes) {
      throw FileError("", kManifestName, std::to_string(text.size()) + " bytes",
                      "at most " + std::to_string(kMostManifestBytes));
    }
    parse_manifest(text, "", manifest.format, manifest.version);
    return text;
  } catch (const FileError& problem) {
    throw std::invalid_argument("container: " + problem.where + ": got " + problem.got +
                                ", expected " + problem.expected);
  }
}

}  // namespace palpate::scenario
