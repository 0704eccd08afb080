// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/read_mesh_child/print_unit.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

#include "palpate/authoring/read_mesh_child/text_file.h"

namespace palpate::authoring {
namespace {

// the root element stands at the beginning
constexpr std::size_t kMostUnpacked = 1 << 16;

constexpr std::string_view kBlanks = " \t\r\n";

/// A file in a zip.
struct Entry {
  std::string name;
  std::size_t method = 0, packed = 0, header = 0;
};

std::size_t read_little(const std::string& bytes, std::size_t at, int count) {
  std::size_t value = 0;
  for (int i = count - 1; i >= 0; --i) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  }
  return value;
}

/// What the directory at the end of a zip lists.
std::vector<Entry> list_entries(const std::string& zip) {
  std::vector<Entry> entries;
  const std::size_t end = zip.rfind(std::string_view("PK\5\6", 4));
  if (end == std::string::npos || zip.size() - end < 22) return entries;
  std::size_t at = read_little(zip, end + 16, 4);
  while (at + 46 <= zip.size() && zip.compare(at, 4, "PK\1\2") == 0) {
    const std::size_t length = read_little(zip, at + 28, 2);
    entries.push_back({zip.substr(at + 46, length), read_little(zip, at + 10, 2),
                       read_little(zip, at + 20, 4), read_little(zip, at + 42, 4)});
    at += 46 + length + read_little(zip, at + 30, 2) + read_little(zip, at + 32, 2);
  }
  return entries;
}

/// The beginning of a file in a zip; empty where it cannot be unpacked.
std::string unpack_head(const std::string& zip, const Entry& entry) {
  if (zip.size() < 30 || entry.header > zip.size() - 30) return {};
  const std::size_t begin = entry.header + 30 + read_little(zip, entry.header + 26, 2) +
                            read_little(zip, entry.header + 28, 2);
  if (begin > zip.size()) return {};
  std::string packed = zip.substr(begin, entry.packed);
  if (entry.method == 0) return packed.substr(0, kMostUnpacked);
  z_stream stream{};
  if (entry.method != 8 || inflateInit2(&stream, -MAX_WBITS) != Z_OK) return {};
  std::string text(kMostUnpacked, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  inflate(&stream, Z_SYNC_FLUSH);
  text.resize(text.size() - stream.avail_out);
  inflateEnd(&stream);
  return text;
}

/// The model that a 3MF shows first: the one that its relationships name.
std::string unpack_model(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string zip{std::istreambuf_iterator<char>(in), {}};
  const std::vector<Entry> entries = list_entries(zip);
  const auto links = std::find_if(entries.begin(), entries.end(),
                                  [](const Entry& e) { return e.name == "_rels/.rels"; });
  if (links == entries.end()) return {};
  const std::string named = unpack_head(zip, *links);
  for (const Entry& entry : entries) {
    if (!entry.name.ends_with(".model")) continue;
    if (named.find(entry.name) != std::string::npos) return unpack_head(zip, entry);
  }
  return {};
}

/// Past the declaration and the comments above the root element.
std::string_view find_root(std::string_view text) {
  for (;;) {
    const std::size_t open = text.find('<');
    if (open == std::string_view::npos) return {};
    text.remove_prefix(open);
    if (!text.starts_with("<?") && !text.starts_with("<!")) break;
    const std::string_view close = text.starts_with("<!--") ? "-->" : ">";
    const std::size_t end = text.find(close);
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + close.size());
  }
  return text.substr(0, text.find('>'));
}

/// The value of the attribute `unit` of an element.
std::string find_unit(std::string_view element) {
  for (;;) {
    const std::size_t equals = element.find('=');
    if (equals == std::string_view::npos) return {};
    std::string_view name = element.substr(0, equals);
    name = name.substr(0, name.find_last_not_of(kBlanks) + 1);
    name.remove_prefix(name.find_last_of(kBlanks) + 1);
    element.remove_prefix(equals + 1);
    const std::size_t open = element.find_first_of("\"'");
    if (open == std::string_view::npos) return {};
    const std::size_t close = element.find(element[open], open + 1);
    if (close == std::string_view::npos) return {};
    if (name == "unit") return std::string(element.substr(open + 1, close - open - 1));
    element.remove_prefix(close + 1);
  }
}

std::string read_amf_head(const std::string& path) {
  TextFile in(path);
  std::string text;
  for (std::string line; text.size() < kMostUnpacked && in.take_line(line);) text += line + '\n';
  return text;
}

}  // namespace

std::string read_print_unit(const std::string& path, const std::string& format) {
  const std::string text = format == "3MF" ? unpack_model(path) : read_amf_head(path);
  const std::string_view root = find_root(text);
  if (root.empty()) return {};
  const std::string unit = find_unit(root);
  return unit.empty() ? "millimeter" : unit;
}

}  // namespace palpate::authoring
