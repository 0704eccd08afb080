// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "palpate/sim/base/error.h"

namespace palpate {

/// The file is in place under its name, whole, but the disk has not confirmed the name: a loss of
/// power now may bring back what stood there before.
class NotDurable : public FileError {
 public:
  using FileError::FileError;
};

/// A file that appears under its name whole or not at all: until commit() it is a new file beside
/// the name, which no other program can foresee or be writing to. Follows a link, as open() does.
///
/// A reader, a full disk, a kill or a loss of power never meets half a file. What a killed writer
/// left beside the name is removed by the next one.
class WholeFile {
 public:
  /// Throws FileError, as all of these do.
  explicit WholeFile(const std::string& path);
  ~WholeFile();  ///< leaves nothing behind unless it was committed
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(std::span<const std::uint8_t> bytes);
  /// Syncs, renames, syncs the folder. Throws NotDurable where only the last could not be done.
  void commit();

  int descriptor() const noexcept { return descriptor_; }  ///< for who writes by himself

 private:
  void create();
  [[noreturn]] void refuse(const char* found) const;

  std::string path_;  ///< as asked for
  std::filesystem::path target_, part_;
  int descriptor_ = -1;
  bool committed_ = false;
};

/// fsync of a file, begun again where a signal broke it off. Returns 0 or errno; what has nothing
/// to sync, as a pipe, is in sync.
int sync_file(int descriptor) noexcept;

/// Makes the names in a folder survive a loss of power. Returns 0 or errno; where the file system
/// cannot be asked it is 0.
int sync_folder(const std::filesystem::path& folder) noexcept;

}  // namespace palpate
