// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "palpate/sim/session/private/record_layout.h"

struct evp_md_ctx_st;

/// What reading and writing a record need of the machine: the file, checksums, compression.
namespace palpate::record_layout {

/// What open(2) gives.
struct Descriptor {
  int number;
};

/// An open file that closes itself; whatever fails is a FileError.
class File {
 public:
  File(const std::string& path, int flags);
  /// Of a file that is open already; closes it too.
  File(std::string path, Descriptor open) noexcept
      : path_(std::move(path)), descriptor_(open.number) {}
  ~File();
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  void write(std::span<const std::uint8_t> bytes);
  void sync();
  void empty();
  std::uint64_t size() const;  ///< [bytes] refuses what is not a regular file
  /// Exactly `size` bytes from `offset`; the caller knows the file is that long.
  Bytes read(std::uint64_t offset, std::size_t size) const;

  [[noreturn]] void refuse(const std::string& where, const std::string& found,
                           const std::string& expected) const;

 private:
  std::string path_;
  int descriptor_;
};

class Sha256 {
 public:
  Sha256();
  ~Sha256();
  void add(std::span<const std::uint8_t> bytes);
  std::array<std::uint8_t, 32> finish();

 private:
  struct Free {
    void operator()(evp_md_ctx_st* context) const;
  };
  std::unique_ptr<evp_md_ctx_st, Free> context_;
};

/// CRC32 as in zlib, PNG and Ethernet.
std::uint32_t compute_crc(std::span<const std::uint8_t> bytes);

/// Of a block: its header up to the CRC itself, then the stored body.
std::uint32_t compute_crc(const BlockHeader& header, std::span<const std::uint8_t> body);

/// A zlib stream of level 1, and back; none unless it gives exactly `size` bytes.
Bytes deflate(std::span<const std::uint8_t> plain);
std::optional<Bytes> inflate(std::span<const std::uint8_t> packed, std::size_t size);

}  // namespace palpate::record_layout
