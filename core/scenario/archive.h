// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "palpate/scenario/container.h"

// Not installed: the zip archive as such, which knows nothing of manifests and arrays.

struct zip;

namespace palpate::scenario {

/// An archive in memory that is opened, listed, and read entry by entry. Throws FileError
/// for what is no plain archive of plain files; see CONTAINER.md.
class ArchiveReader {
 public:
  /// `bytes` must outlive the reader.
  ArchiveReader(std::span<const std::uint8_t> bytes, std::string file);

  struct Entry {
    std::uint64_t index = 0;
    std::uint64_t size = 0;  ///< [bytes] as the directory claims
  };
  const std::map<std::string, Entry, std::less<>>& entries() const noexcept { return entries_; }

  /// Throws FileError unless the entry gives exactly the bytes it claims, CRC included.
  Bytes read(const std::string& name) const;

 private:
  void list_entries();
  void check_entry(const std::string& name, std::uint64_t index) const;
  [[noreturn]] void refuse(const std::string& where, const std::string& found,
                           const std::string& expected) const;

  struct Discard {
    void operator()(zip* archive) const;
  };
  std::string file_;
  std::unique_ptr<zip, Discard> archive_;
  std::map<std::string, Entry, std::less<>> entries_;
};

/// A file to be stored in an archive; the bytes are borrowed.
struct Stored {
  std::string name;
  std::span<const std::uint8_t> bytes;
};

/// An archive of `files` in their order. Equal files give equal bytes.
Bytes pack_archive(const std::vector<Stored>& files);

}  // namespace palpate::scenario
