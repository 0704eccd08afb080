// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/archive.h"

#include <zip.h>

#include <algorithm>
#include <cstring>
#include <new>

#include "palpate/sim/base/error.h"

namespace palpate::scenario {
namespace {

/// A directory larger than this has more entries than any container; libzip would read it whole,
/// and takes hours where its millions of names are made to collide.
constexpr std::size_t kMostDirectoryBytes = 64 * 1024;

// the end record [APPNOTE 4.3.16] and the locator of its larger form (4.3.15)
constexpr std::size_t kEndBytes = 22, kLocatorBytes = 20, kMostCommentBytes = 65535;
constexpr std::array<std::uint8_t, 4> kEndMagic = {'P', 'K', 5, 6};
constexpr std::array<std::uint8_t, 4> kLocatorMagic = {'P', 'K', 6, 7};

// of a file's attributes as Unix keeps them (stat.h), in the upper half of zip's
constexpr std::uint32_t kKindOfFile = 0170000, kPlainFile = 0100000, kPlainFileMode = 0100644;

std::uint64_t unpack_u32(const std::uint8_t* at) {
  return at[0] | std::uint64_t{at[1]} << 8 | std::uint64_t{at[2]} << 16 |
         std::uint64_t{at[3]} << 24;
}

struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;

struct Error {
  zip_error_t value{};
  Error() { zip_error_init(&value); }
  ~Error() { zip_error_fini(&value); }
  std::string words() { return zip_error_strerror(&value); }
};

/// libzip fails to write into memory only where memory ends.
void require(bool done) {
  if (!done) throw std::bad_alloc();
}

/// Whether an end record at `end` would send libzip to a directory too large to be read. libzip
/// searches end records wherever a comment could have put one, so each of them counts.
bool has_absurd_directory(std::span<const std::uint8_t> bytes, std::size_t end) {
  const std::uint8_t* at = bytes.data() + end;
  if (end >= kLocatorBytes &&
      std::equal(kLocatorMagic.begin(), kLocatorMagic.end(), at - kLocatorBytes)) {
    return true;
  }
  const std::uint64_t size = unpack_u32(at + 12), offset = unpack_u32(at + 16);
  return offset + size <= end && size > kMostDirectoryBytes;
}

}  // namespace

void ArchiveReader::Discard::operator()(zip* archive) const { zip_discard(archive); }

ArchiveReader::ArchiveReader(std::span<const std::uint8_t> bytes, std::string file)
    : file_(std::move(file)) {
  if (bytes.size() < kEndBytes || bytes[0] != 'P' || bytes[1] != 'K') {
    refuse("", bytes.empty() ? "an empty file" : "something other than a zip archive",
           "a zip archive");
  }
  const std::size_t last = bytes.size() - kEndBytes;
  for (std::size_t end = last - std::min(last, kMostCommentBytes); end <= last; ++end) {
    if (std::equal(kEndMagic.begin(), kEndMagic.end(), bytes.data() + end) &&
        has_absurd_directory(bytes, end)) {
      refuse("", "a directory of too many entries",
             "at most " + std::to_string(kMostArrays + 1) + " entries");
    }
  }
  Error error;
  Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error.value));
  require(source != nullptr);
  archive_.reset(zip_open_from_source(source.get(), ZIP_RDONLY | ZIP_CHECKCONS, &error.value));
  if (!archive_) {
    const bool twice = zip_error_code_zip(&error.value) == ZIP_ER_EXISTS;
    refuse("", twice ? "two entries of one name" : "a damaged zip archive (" + error.words() + ")",
           twice ? "one" : "a whole one");
  }
  source.release();  // the archive owns it now
  list_entries();
}

void ArchiveReader::list_entries() {
  const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
  if (count > static_cast<zip_int64_t>(kMostArrays + 1)) {
    refuse("", std::to_string(count) + " entries", "at most " + std::to_string(kMostArrays + 1));
  }
  std::uint64_t packed = 0;
  for (zip_int64_t i = 0; i < count; ++i) {
    const auto index = static_cast<std::uint64_t>(i);
    zip_stat_t entry;
    zip_stat_init(&entry);
    constexpr zip_uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE;
    if (zip_stat_index(archive_.get(), index, ZIP_FL_ENC_RAW, &entry) != 0 ||
        (entry.valid & kNeeded) != kNeeded) {
      refuse("entry " + std::to_string(i), "no name or size", "both");
    }
    check_entry(entry.name, index);
    if (!entries_.try_emplace(entry.name, Entry{index, entry.size}).second) {
      refuse(entry.name, "two entries of this name", "one");
    }
    // entries that overlap would make a small file a long work
    packed += std::min<std::uint64_t>(entry.comp_size, kMostFileBytes);
    if (packed > kMostFileBytes) refuse("", "entries that share their bytes", "none such");
  }
}

/// That it is a plain file, stored or deflated.
void ArchiveReader::check_entry(const std::string& name, std::uint64_t index) const {
  zip_stat_t entry;
  zip_stat_init(&entry);
  zip_stat_index(archive_.get(), index, ZIP_FL_ENC_RAW, &entry);
  if (entry.encryption_method != ZIP_EM_NONE) refuse(name, "an encrypted entry", "a plain one");
  if (entry.comp_method != ZIP_CM_STORE && entry.comp_method != ZIP_CM_DEFLATE) {
    refuse(name, "compression method " + std::to_string(entry.comp_method), "stored or deflated");
  }
  zip_uint8_t system = 0;
  zip_uint32_t attributes = 0;
  zip_file_get_external_attributes(archive_.get(), index, 0, &system, &attributes);
  const std::uint32_t kind = (attributes >> 16) & kKindOfFile;
  if (kind != 0 && kind != kPlainFile) refuse(name, "a link or a folder", "a plain file");
}

Bytes ArchiveReader::read(const std::string& name) const {
  const Entry& entry = entries_.at(name);
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
      zip_fopen_index(archive_.get(), entry.index, 0), zip_fclose);
  if (!file) refuse(name, "a damaged entry", "one that can be opened");
  // one byte more than claimed shows an entry that goes on, and makes libzip compare the CRC
  Bytes bytes(static_cast<std::size_t>(entry.size) + 1);
  std::size_t have = 0;
  while (have < bytes.size()) {
    const zip_int64_t done = zip_fread(file.get(), bytes.data() + have, bytes.size() - have);
    if (done < 0) refuse(name, "damaged bytes", "the bytes its checksum tells");
    if (done == 0) break;
    have += static_cast<std::size_t>(done);
  }
  if (have != entry.size) {
    refuse(name, have > entry.size ? "more bytes than stated" : std::to_string(have) + " bytes",
           std::to_string(entry.size));
  }
  bytes.pop_back();
  return bytes;
}

void ArchiveReader::refuse(const std::string& where, const std::string& found,
                           const std::string& expected) const {
  throw FileError(file_, where, found, expected);
}

Bytes pack_archive(const std::vector<Stored>& files) {
  constexpr zip_uint16_t kMidnight = 0, kFirstOf1980 = 1 << 5 | 1;
  Error error;
  const Source target(zip_source_buffer_create(nullptr, 0, 0, &error.value));
  require(target != nullptr);
  zip_source_keep(target.get());  // closing the archive would free it
  zip_t* archive = zip_open_from_source(target.get(), ZIP_TRUNCATE, &error.value);
  require(archive != nullptr);
  for (const Stored& file : files) {
    zip_source_t* bytes = zip_source_buffer(archive, file.bytes.data(), file.bytes.size(), 0);
    const zip_int64_t at = zip_file_add(archive, file.name.c_str(), bytes, ZIP_FL_ENC_UTF_8);
    require(at >= 0);
    const auto index = static_cast<zip_uint64_t>(at);
    zip_set_file_compression(archive, index, ZIP_CM_STORE, 0);
    zip_file_set_dostime(archive, index, kMidnight, kFirstOf1980, 0);
    zip_file_set_external_attributes(archive, index, 0, ZIP_OPSYS_UNIX, kPlainFileMode << 16);
  }
  require(zip_close(archive) == 0);
  require(zip_source_open(target.get()) == 0);
  zip_stat_t stat;
  zip_source_stat(target.get(), &stat);
  Bytes packed(static_cast<std::size_t>(stat.size));
  require(zip_source_read(target.get(), packed.data(), packed.size()) ==
          static_cast<zip_int64_t>(packed.size()));
  zip_source_close(target.get());
  return packed;
}

}  // namespace palpate::scenario
