// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/base/error.h"
#include "palpate/sim/base/private/refuse.h"

using namespace palpate;

TEST_CASE("a file error is one sentence that says which file, where, what and what instead") {
  const FileError error("liver.obj", "line 12", "vertex 900", "1 to 600");

  CHECK(std::string(error.what()) == "liver.obj: line 12: got vertex 900, expected 1 to 600");
  CHECK(error.file == "liver.obj");
  CHECK(error.where == "line 12");
  CHECK(error.got == "vertex 900");
  CHECK(error.expected == "1 to 600");
}

TEST_CASE("a file error about the whole file names no place in it") {
  const FileError error("liver.obj", "", "no triangles", "at least one");

  CHECK(std::string(error.what()) == "liver.obj: got no triangles, expected at least one");
}

TEST_CASE("a refused argument says where, what was found and what was expected") {
  CHECK_THROWS_WITH_AS(refuse("mesh: vertex 3", write_text(-0.5, " kg"), "a positive number"),
                       "mesh: vertex 3: got -0.5 kg, expected a positive number",
                       std::invalid_argument);
}
