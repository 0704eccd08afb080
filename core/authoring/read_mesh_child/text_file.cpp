// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/read_mesh_child/text_file.h"

#include <fstream>
#include <iterator>

namespace palpate::authoring {
namespace {

/// Of UTF-16 its letters of ASCII, all that numbers and words of these formats are made of.
std::string narrow(const std::string& bytes, bool low_first) {
  std::string text;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const char low = bytes[low_first ? i : i + 1], high = bytes[low_first ? i + 1 : i];
    text += high == 0 && static_cast<unsigned char>(low) < 128 ? low : '?';
  }
  return text;
}

}  // namespace

TextFile::TextFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  bytes_.assign(std::istreambuf_iterator<char>(in), {});
  if (bytes_.starts_with("\xff\xfe")) bytes_ = narrow(bytes_, true);
  if (bytes_.starts_with("\xfe\xff")) bytes_ = narrow(bytes_, false);
}

bool TextFile::take_line(std::string& line) {
  if (at_ >= bytes_.size()) return false;
  const std::size_t end = bytes_.find_first_of("\r\n", at_);
  line.assign(bytes_, at_, end == std::string::npos ? end : end - at_);
  if (end == std::string::npos) {
    at_ = bytes_.size();
  } else {
    at_ = end + (bytes_.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  return true;
}

}  // namespace palpate::authoring
