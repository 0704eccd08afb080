// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/session/private/json_object.h"

using namespace palpate;

TEST_CASE("JSON objects are told from text that is none") {
  for (const char* sound : {"{}", " { } \n", R"({"a":1})",
                            R"({"a":[1,-2.5e+3,0,{"b":null}],"c":"\u00e9\n\"","d":true})",
                            R"({"":[],"x":{"y":{}}})", "{\"\xc3\xa9\":0.5E-2}"}) {
    CHECK_MESSAGE(!find_json_problem(sound), sound);
  }
  for (const char* broken : {"",
                             "1",
                             "[]",
                             "{",
                             "}",
                             R"({"a":})",
                             R"({"a" 1})",
                             R"({a:1})",
                             R"({"a":1,})",
                             R"({"a":01})",
                             R"({"a":1.})",
                             R"({"a":+1})",
                             R"({"a":"\x"})",
                             R"({"a":"\u12g4"})",
                             "{\"a\":\"\n\"}",
                             R"({"a":tru})",
                             R"({} {})",
                             R"({"a":"b)",
                             R"({"a":"b\)",
                             R"({"a":[1 2]})",
                             R"({"a":-})"}) {
    CHECK_MESSAGE(find_json_problem(broken).has_value(), broken);
  }
}

TEST_CASE("nesting without end is refused before the stack is used up") {
  std::string deep = "{\"a\":";
  for (int i = 0; i < 1000000; ++i) deep += '[';

  CHECK(find_json_problem(deep).has_value());
}

TEST_CASE("a member of the outermost object is replaced, wherever it stands") {
  CHECK(with_json_member("{}", "p", "2") == R"({"p":2})");
  CHECK(with_json_member(" {\"a\": 1 } ", "p", "2") == " {\"a\": 1,\"p\":2}");
  CHECK(with_json_member(R"({"p":1})", "p", "2") == R"({"p":2})");
  CHECK(with_json_member(R"({"p":1,"a":{"p":3}})", "p", "2") == R"({"a":{"p":3},"p":2})");
  CHECK(with_json_member(R"({"a":3 , "p":1})", "p", "2") == R"({"a":3,"p":2})");
  CHECK(with_json_member(R"({"a":3,"p":{"x":[1]},"b":4})", "p", "2") == R"({"a":3,"b":4,"p":2})");
  CHECK(with_json_member(R"({"p":1,"p":1,"a":0})", "p", "2") == R"({"a":0,"p":2})");
}
