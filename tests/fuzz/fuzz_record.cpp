// SPDX-License-Identifier: BSD-3-Clause
// Whatever the bytes, the reader gives a record that can be written again and replayed, or a
// FileError. Checksums that random bytes do not get past are made right where the input says so.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/tick/press_scene.h"
#include "insist.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/session/private/record_file.h"
#include "palpate/sim/session/private/record_layout.h"
#include "palpate/sim/session/record.h"

using namespace palpate;
using namespace palpate::record_layout;
using palpate::fuzz::insist;

namespace {

/// A file without a place on a disk.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("fuzzed.prec", MFD_CLOEXEC)) {}
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }
  void write(std::span<const std::uint8_t> bytes) const {
    const bool written =
        ::ftruncate(descriptor_, 0) == 0 &&
        ::pwrite(descriptor_, bytes.data(), bytes.size(), 0) == std::int64_t(bytes.size());
    insist(written, "memory takes a file");
  }

 private:
  int descriptor_;
};

void put_crc(std::span<std::uint8_t> at, std::uint32_t crc) {
  const Bytes bytes = pack_u32(crc);
  std::copy(bytes.begin(), bytes.end(), at.begin());
}

/// Makes every checksum right that the lengths in the bytes lead to.
Bytes seal(Bytes bytes) {
  const std::span<std::uint8_t> all(bytes);
  if (all.size() < kPreambleBytes + 8) return bytes;
  const std::size_t begin = preamble_bytes(unpack_u32(all.subspan(8)));
  const std::size_t json = unpack_u32(all.subspan(12));
  if (json > all.size() - begin - 4) return bytes;
  std::size_t at = begin + json;
  put_crc(all.subspan(at), compute_crc(all.first(at)));
  for (at += 4; all.size() - at >= kBlockHeaderBytes;) {
    const auto header = unpack_block_header(all.subspan(at));
    if (!header || header->length > all.size() - at - kBlockHeaderBytes) return bytes;
    const auto body = all.subspan(at + kBlockHeaderBytes, header->length);
    if (header->kind == BlockKind::summary && body.size() == kSummaryBytes) {
      Sha256 sha256;
      sha256.add(all.first(at));
      const auto digest = sha256.finish();
      std::copy(digest.begin(), digest.end(), body.end() - 32);
    }
    put_crc(all.subspan(at + kBlockHeaderBytes - 4), compute_crc(*header, body));
    at += kBlockHeaderBytes + header->length;
  }
  return bytes;
}

Scene with_two_instruments() {
  Scene scene = testing::press_scene();
  scene.instruments.resize(2);
  return build_scene(std::move(scene));
}

/// What was read is run again, or refused in words.
void use_record(const Record& record) {
  static const Scene one = testing::press_scene(), two = with_two_instruments();
  constexpr std::size_t kFewTicks = 60;
  insist(record.hand.size() == record.felt.size(), "every hand has what it felt");
  const std::size_t ticks = count_ticks(record);
  if (ticks > kFewTicks) return;
  const Scene& scene = record.instruments == 2 ? two : one;
  try {
    const ReplayReport report = replay(scene, record);
    insist(report.ticks == static_cast<long>(ticks), "every tick is run again");
  } catch (const std::invalid_argument&) {
    // a run that nobody made
  }
}

}  // namespace

// The first byte says whether checksums are made right.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const MemoryFile file;
  if (size == 0) return 0;
  Bytes bytes(data + 1, data + size);
  file.write(data[0] % 4 ? seal(std::move(bytes)) : bytes);
  try {
    use_record(read_record(file.path()));
  } catch (const FileError&) {
    // the one thing a reader may throw; anything else ends the process
  }
  return 0;
}
