// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/base/private/whole_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>

namespace palpate {
namespace {

constexpr int kMostTries = 100;

/// Where the file itself is or shall be, so that a link to it stays a link.
std::filesystem::path follow(std::filesystem::path path) {
  constexpr int kMostLinks = 40;  // as many as the system follows
  std::error_code nothing_there;
  for (int link = 0; link < kMostLinks && is_symlink(path, nothing_there); ++link) {
    path = path.parent_path() / std::filesystem::read_symlink(path);
  }
  return path;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

/// What all names of new files beside `target` begin with; a long name leaves room for the rest.
std::string begin_part_name(const std::filesystem::path& target) {
  constexpr std::size_t kMostNameBytes = 200;
  return "." + target.filename().string().substr(0, kMostNameBytes) + ".part-";
}

std::string draw_digits() {
  std::random_device random;
  char digits[32];
  std::snprintf(digits, sizeof digits, "%08x%08x", random(), random());
  return digits;
}

/// Removes `part` if it is a plain file of ours that no living writer holds.
void remove_if_left(const std::filesystem::path& part) noexcept {
  const int file = ::open(part.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return;
  struct stat status {};
  if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid() &&
      ::flock(file, LOCK_EX | LOCK_NB) == 0) {
    ::unlink(part.c_str());
  }
  ::close(file);
}

/// Removes what writers of `target` left that were killed: a living one holds a lock on its file.
void remove_leftovers(const std::filesystem::path& target) {
  const std::string begin = begin_part_name(target);
  std::error_code problem;  // one may write in a folder that one may not read
  std::filesystem::directory_iterator entry(folder_of(target), problem), end;
  for (; !problem && entry != end; entry.increment(problem)) {
    if (entry->path().filename().string().starts_with(begin)) remove_if_left(entry->path());
  }
}

}  // namespace

WholeFile::WholeFile(const std::string& path) : path_(path), target_(follow(path)) {
  struct stat status {};
  if (::stat(target_.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    refuse("something other than a file");
  }
  remove_leftovers(target_);
  create();
}

WholeFile::~WholeFile() {
  if (!committed_) ::unlink(part_.c_str());
  ::close(descriptor_);
}

/// Another writer's remove_leftovers() may take the file before it is locked; then there is no
/// name for it any more, and another is drawn.
void WholeFile::create() {
  for (int tries = 0; tries < kMostTries; ++tries) {
    part_ = folder_of(target_) / (begin_part_name(target_) + draw_digits());
    descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno == EEXIST) continue;
    if (descriptor_ < 0) refuse(std::strerror(errno));
    // where there are no locks nothing is removed either
    while (::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
    }
    struct stat status {};
    if (::fstat(descriptor_, &status) == 0 && status.st_nlink > 0) return;
    ::close(descriptor_);
  }
  refuse("a folder in which every new file is taken away");
}

void WholeFile::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(descriptor_, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) refuse(std::strerror(errno));
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
}

void WholeFile::commit() {
  if (const int problem = sync_file(descriptor_)) refuse(std::strerror(problem));
  if (std::rename(part_.c_str(), target_.c_str()) != 0) refuse(std::strerror(errno));
  committed_ = true;
  if (const int problem = sync_folder(folder_of(target_))) {
    throw NotDurable(
        path_, "",
        std::string("a folder that the disk does not sync (") + std::strerror(problem) + ")",
        "one that it does: the file is saved, but a loss of power may bring back "
        "what stood there before");
  }
}

void WholeFile::refuse(const char* found) const {
  throw FileError(path_, "", found, "a file that can be written");
}

int sync_file(int descriptor) noexcept {
  while (::fsync(descriptor) != 0) {
    if (errno != EINTR) return errno == EINVAL ? 0 : errno;
  }
  return 0;
}

int sync_folder(const std::filesystem::path& folder) noexcept {
  const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // one may write in a folder that one may not read
  if (handle < 0) return errno == EACCES ? 0 : errno;
  const int problem = sync_file(handle);
  ::close(handle);
  return problem == ENOTSUP || problem == EBADF ? 0 : problem;
}

}  // namespace palpate
