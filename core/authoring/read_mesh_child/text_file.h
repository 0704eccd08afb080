// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace palpate::authoring {

/// The lines of a text, however they end: as on Unix, Windows or old Macs. Text of two bytes a
/// letter is read as text of one, with a question mark for what has no place in that.
class TextFile {
 public:
  explicit TextFile(const std::string& path);

  /// The next line without its end; false where there is none.
  bool take_line(std::string& line);

  bool is_at_end() const { return at_ >= bytes_.size(); }

  /// [byte] Where the next line begins.
  std::size_t tell() const { return at_; }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

}  // namespace palpate::authoring
