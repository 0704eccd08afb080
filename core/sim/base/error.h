// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace palpate {

/// A file that is refused: which file, where in it, what was found and what was expected.
/// what() is the four joined into one sentence.
class FileError : public std::runtime_error {
 public:
  FileError(std::string file, std::string where, std::string found, std::string expected)
      : std::runtime_error(file + (where.empty() ? "" : ": " + where) + ": found " + found +
                           ", expected " + expected),
        file(std::move(file)),
        where(std::move(where)),
        found(std::move(found)),
        expected(std::move(expected)) {}

  std::string file, where, found, expected;
};

/// A device that cannot be opened or has stopped answering.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace palpate
