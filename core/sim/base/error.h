// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace palpate {

/// A file that is refused: which file, where in it, what it got and what it expected.
/// what() is the four joined into one sentence.
class FileError : public std::runtime_error {
 public:
  FileError(std::string in_file, std::string at, std::string actual, std::string wanted)
      : std::runtime_error(in_file + (at.empty() ? "" : ": " + at) + ": got " + actual +
                           ", expected " + wanted),
        file(std::move(in_file)),
        where(std::move(at)),
        got(std::move(actual)),
        expected(std::move(wanted)) {}

  std::string file, where, got, expected;
};

/// A device that cannot be opened or has stopped answering.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace palpate
