// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "palpate/sim/base/error.h"
#include "palpate/sim/session/record_file.h"

namespace palpate::scenario {
namespace {

using record_layout::File;

/// Where the file itself is or shall be, so that a link to it stays a link.
std::filesystem::path follow(std::filesystem::path path) {
  constexpr int kMostLinks = 40;  // as many as the system follows
  std::error_code nothing_there;
  for (int link = 0; link < kMostLinks && is_symlink(path, nothing_there); ++link) {
    path = path.parent_path() / std::filesystem::read_symlink(path);
  }
  return path;
}

std::filesystem::path make_part_name(const std::filesystem::path& target) {
  static std::atomic<int> next{0};
  return target.parent_path() /
         ("." + target.filename().string() + ".part-" + std::to_string(::getpid()) + "-" +
          std::to_string(next.fetch_add(1)));
}

}  // namespace

Bytes read_whole(const std::string& path, std::size_t most) {
  // a pipe without a writer would be waited for
  const File file(path, O_RDONLY | O_NONBLOCK);
  const std::uint64_t size = file.size();
  if (size > most) {
    file.refuse("", std::to_string(size) + " bytes", "at most " + std::to_string(most));
  }
  return file.read(0, static_cast<std::size_t>(size));
}

void write_whole(const std::string& path, std::span<const std::uint8_t> bytes) {
  const std::filesystem::path target = follow(path), part = make_part_name(target);
  try {
    File file(part.string(), O_WRONLY | O_CREAT | O_TRUNC);
    file.write(bytes);
    file.sync();
    if (std::rename(part.c_str(), target.c_str()) != 0) {
      throw FileError(path, "", std::strerror(errno), "a file that can be written");
    }
  } catch (const FileError& problem) {
    ::unlink(part.c_str());
    throw FileError(path, problem.where, problem.found, problem.expected);
  }
  const auto folder = target.has_parent_path() ? target.parent_path() : ".";
  File(folder.string(), O_RDONLY | O_DIRECTORY).sync();
}

}  // namespace palpate::scenario
