// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/session/private/record_file.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <new>

#include "palpate/sim/base/private/whole_file.h"

namespace palpate::record_layout {

File::File(const std::string& path, int flags)
    : path_(path), descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) refuse("", std::strerror(errno), "a file that can be opened");
}

File::~File() { ::close(descriptor_); }

void File::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(descriptor_, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) refuse("", std::strerror(errno), "room to write");
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
}

void File::sync() {
  if (const int problem = sync_file(descriptor_)) {
    refuse("", std::strerror(problem), "a disk that takes what was written");
  }
}

void File::empty() {
  if (::ftruncate(descriptor_, 0) != 0) {
    refuse("", std::strerror(errno), "a file that can be written");
  }
}

std::uint64_t File::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) refuse("", std::strerror(errno), "a readable file");
  if (!S_ISREG(status.st_mode)) refuse("", "something other than a file", "a file");
  return static_cast<std::uint64_t>(status.st_size);
}

Bytes File::read(std::uint64_t offset, std::size_t size) const {
  Bytes bytes(size);
  for (std::size_t have = 0; have < size;) {
    const ssize_t done =
        ::pread(descriptor_, bytes.data() + have, size - have, static_cast<off_t>(offset + have));
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) refuse("", std::strerror(errno), "a readable file");
    if (done == 0) refuse("", "a file that shrinks while it is read", "one that does not");
    have += static_cast<std::size_t>(done);
  }
  return bytes;
}

void File::refuse(const std::string& where, const std::string& found,
                  const std::string& expected) const {
  throw FileError(path_, where, found, expected);
}

Sha256::Sha256() : context_(EVP_MD_CTX_new()) {
  if (!context_ || EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1) {
    throw std::bad_alloc();
  }
}

Sha256::~Sha256() = default;

void Sha256::Free::operator()(evp_md_ctx_st* context) const { EVP_MD_CTX_free(context); }

void Sha256::add(std::span<const std::uint8_t> bytes) {
  EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size());
}

std::array<std::uint8_t, 32> Sha256::finish() {
  std::array<std::uint8_t, 32> digest{};
  EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr);
  return digest;
}

std::uint32_t compute_crc(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, bytes.data(), bytes.size()));
}

std::uint32_t compute_crc(const BlockHeader& header, std::span<const std::uint8_t> body) {
  const auto bytes = pack_block_header(header);
  const uLong crc = crc32_z(0, bytes.data(), bytes.size() - 4);
  // zlib takes a null pointer for a wish to start over
  if (body.empty()) return static_cast<std::uint32_t>(crc);
  return static_cast<std::uint32_t>(crc32_z(crc, body.data(), body.size()));
}

Bytes deflate(std::span<const std::uint8_t> plain) {
  uLongf size = compressBound(plain.size());
  Bytes packed(size);
  if (compress2(packed.data(), &size, plain.data(), plain.size(), 1) != Z_OK) {
    throw std::bad_alloc();  // the only way it can fail with room enough
  }
  packed.resize(size);
  return packed;
}

std::optional<Bytes> inflate(std::span<const std::uint8_t> packed, std::size_t size) {
  Bytes plain(size);
  uLongf have = size;
  uLong used = packed.size();
  if (uncompress2(plain.data(), &have, packed.data(), &used) != Z_OK || have != size ||
      used != packed.size()) {
    return std::nullopt;
  }
  return plain;
}

}  // namespace palpate::record_layout
