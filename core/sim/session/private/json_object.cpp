// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/session/private/json_object.h"

#include <cstring>

namespace palpate {
namespace {

constexpr int kDeepest = 64;  // so that a hostile header cannot use up the stack

/// Walks over JSON text by the grammar of [RFC8259] without building anything.
class Walker {
 public:
  explicit Walker(std::string_view text) : text_(text) {}

  /// The whole text is one object. `member`, if not null, is looked for in it by `name`.
  bool walk_document(std::string_view name, std::optional<JsonMember>* member) {
    name_ = name;
    member_ = member;
    skip_space();
    if (!at('{')) return fail("an object");
    if (!walk_value(0)) return false;
    skip_space();
    return at_ == text_.size() || fail("nothing more");
  }

  std::string problem() const {
    return "at byte " + std::to_string(at_) + " expected " + expected_;
  }

 private:
  bool fail(const char* expected) {
    expected_ = expected;
    return false;
  }
  bool at(char c) const { return at_ < text_.size() && text_[at_] == c; }
  bool take(char c) {
    if (!at(c)) return false;
    ++at_;
    return true;
  }
  void skip_space() {
    while (at(' ') || at('\n') || at('\r') || at('\t')) ++at_;
  }

  bool walk_value(int depth) {
    if (depth > kDeepest) return fail("no deeper nesting");
    if (take('{')) return walk_members(depth);
    if (take('[')) return walk_elements(depth);
    if (at('"')) return walk_string();
    for (const char* word : {"true", "false", "null"}) {
      if (text_.substr(at_).starts_with(word)) {
        at_ += std::strlen(word);
        return true;
      }
    }
    return walk_number();
  }

  bool walk_members(int depth) {
    skip_space();
    if (take('}')) return true;
    do {
      skip_space();
      const std::size_t begin = at_;
      if (!at('"')) return fail("the name of a member");
      if (!walk_string()) return false;
      const std::string_view name = text_.substr(begin + 1, at_ - begin - 2);
      skip_space();
      if (!take(':')) return fail("':'");
      skip_space();
      if (!walk_value(depth + 1)) return false;
      if (depth == 0 && member_ && name == name_) *member_ = JsonMember{begin, at_};
      skip_space();
    } while (take(','));
    return take('}') || fail("',' or '}'");
  }

  bool walk_elements(int depth) {
    skip_space();
    if (take(']')) return true;
    do {
      skip_space();
      if (!walk_value(depth + 1)) return false;
      skip_space();
    } while (take(','));
    return take(']') || fail("',' or ']'");
  }

  bool walk_string() {
    ++at_;
    while (at_ < text_.size() && text_[at_] != '"') {
      if (static_cast<unsigned char>(text_[at_]) < 0x20) return fail("no control character");
      if (text_[at_++] == '\\' && !walk_escape()) return fail("an escape");
    }
    return take('"') || fail("the end of the string");
  }

  bool walk_escape() {
    if (at_ >= text_.size()) return false;
    const char kind = text_[at_++];
    if (kind != 'u') return std::strchr("\"\\/bfnrt", kind) != nullptr && kind != '\0';
    for (int digit = 0; digit < 4; ++digit, ++at_) {
      if (at_ >= text_.size() || !is_hexadecimal(text_[at_])) return false;
    }
    return true;
  }

  bool walk_number() {
    take('-');
    if (!take('0') && !walk_digits()) return fail("a value");
    if (take('.') && !walk_digits()) return fail("a digit");
    if (take('e') || take('E')) {
      if (!take('+')) take('-');
      if (!walk_digits()) return fail("a digit");
    }
    return true;
  }

  bool walk_digits() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') ++at_;
    return at_ > begin;
  }

  static bool is_hexadecimal(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
  }

  std::string_view text_, name_;
  std::optional<JsonMember>* member_ = nullptr;
  std::size_t at_ = 0;
  const char* expected_ = "";
};

}  // namespace

std::optional<std::string> find_json_problem(std::string_view text) {
  Walker walker(text);
  if (walker.walk_document({}, nullptr)) return std::nullopt;
  return walker.problem();
}

std::optional<JsonMember> find_json_member(std::string_view text, std::string_view name) {
  std::optional<JsonMember> member;
  Walker(text).walk_document(name, &member);
  return member;
}

std::string with_json_member(std::string_view object, std::string_view name,
                             std::string_view value) {
  constexpr std::string_view kBlank = " \t\r\n";
  std::string text(object.substr(0, object.find_last_of('}')));
  while (const auto member = find_json_member(text + "}", name)) {
    // with it goes the comma before it, or, for the first member, the one after it
    std::size_t begin = text.find_last_not_of(kBlank, member->begin - 1);
    std::size_t end = text.find_first_not_of(kBlank, member->end);
    if (text[begin] != ',') {
      ++begin;
      end = end != std::string::npos && text[end] == ',' ? end + 1 : member->end;
    } else {
      end = member->end;
    }
    text.erase(begin, end - begin);
  }
  text.erase(text.find_last_not_of(kBlank) + 1);
  if (text.back() != '{') text += ',';
  return text.append("\"").append(name).append("\":").append(value).append("}");
}

}  // namespace palpate
