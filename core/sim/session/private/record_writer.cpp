// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/session/private/record_writer.h"

#include <algorithm>
#include <stdexcept>

#include "palpate/sim/session/private/json_object.h"

namespace palpate::record_layout {
std::string complete_header(const std::string& header_json) {
  if (const auto problem = find_json_problem(header_json)) {
    throw std::invalid_argument("record header: got text that is not a JSON object: " + *problem);
  }
  std::string text = with_json_member(header_json, "prec", describe_columns());
  if (text.size() > kMostHeaderBytes) {
    throw std::invalid_argument("record header: got " + std::to_string(text.size()) +
                                " bytes, expected at most 1 MiB");
  }
  return text;
}

RecordWriter::RecordWriter(std::unique_ptr<File> file, const std::string& header, RecordCodec codec)
    : header_(header), codec_(codec), file_(std::move(file)) {
  Bytes preamble = pack_preamble(header_);
  const Bytes crc = pack_u32(compute_crc(preamble));
  preamble.insert(preamble.end(), crc.begin(), crc.end());
  append(preamble);
  sync();
}

void RecordWriter::write(std::vector<TickLog::Tick>& ticks, std::vector<Event>& events,
                         std::vector<StateHash>& hashes, bool all) {
  write_ticks(ticks, all);
  write_rows(BlockKind::events, events, all, summary_.events);
  write_rows(BlockKind::hashes, hashes, all, summary_.hashes);
}

void RecordWriter::write_ticks(std::vector<TickLog::Tick>& rows, bool all) {
  std::size_t begin = 0;
  while (begin < rows.size()) {
    std::size_t end = begin + 1;
    while (end < rows.size() && end - begin < kBlockTicks &&
           rows[end].tick == rows[end - 1].tick + 1) {
      ++end;
    }
    if (!all && end == rows.size() && end - begin < kBlockTicks) break;
    summary_.ticks += end - begin;
    if (summary_.ticks > static_cast<std::uint64_t>(kMostRows)) {
      file_->refuse("", "more than 8388608 ticks", "a run of at most 2 h 19 min at 1 kHz");
    }
    write_block(BlockKind::ticks, codec_, rows[begin].tick,
                std::span<const TickLog::Tick>(rows).subspan(begin, end - begin));
    last_tick_ = rows[end - 1].tick;
    begin = end;
  }
  rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(begin));
}

template <class Row>
void RecordWriter::write_rows(BlockKind kind, std::vector<Row>& rows, bool all,
                              std::uint64_t& total) {
  const auto later = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row& row) { return !all && row.tick > last_tick_; });
  const auto count = static_cast<std::size_t>(later - rows.begin());
  total += count;
  if (total > static_cast<std::uint64_t>(kMostRows)) {
    file_->refuse("", std::string("more than 8388608 ") + kind_name(kind), "fewer");
  }
  for (std::size_t begin = 0; begin < count; begin += kMostBlockRows) {
    const std::size_t some = std::min<std::size_t>(count - begin, kMostBlockRows);
    write_block(kind, RecordCodec::none, rows[begin].tick,
                std::span<const Row>(rows).subspan(begin, some));
  }
  rows.erase(rows.begin(), later);
}

template <class Row>
void RecordWriter::write_block(BlockKind kind, RecordCodec codec, std::int64_t first_tick,
                               std::span<const Row> rows) {
  const auto count = static_cast<std::uint32_t>(rows.size());
  Bytes body = pack(rows);
  if (codec == RecordCodec::deflate) body = deflate(shuffle_differences(kind, count, body));
  BlockHeader header{.kind = kind,
                     .codec = static_cast<std::uint32_t>(codec),
                     .first_tick = first_tick,
                     .count = count,
                     .length = static_cast<std::uint32_t>(body.size()),
                     .crc = 0};
  header.crc = compute_crc(header, body);
  append(pack_block_header(header));
  append(body);
}

void RecordWriter::append(std::span<const std::uint8_t> bytes) {
  sha256_.add(bytes);
  file_->write(bytes);
}

void RecordWriter::write_summary() {
  // a disk may keep the summary and lose what was written just before: that would not be a record
  // that was cut off but one that was damaged
  sync();
  summary_.sha256 = sha256_.finish();
  const Bytes body = pack_summary(summary_);
  BlockHeader header{.kind = BlockKind::summary,
                     .codec = 0,
                     .first_tick = last_tick_ + 1,
                     .count = 1,
                     .length = kSummaryBytes,
                     .crc = 0};
  header.crc = compute_crc(header, body);
  file_->write(pack_block_header(header));
  file_->write(body);
  file_->sync();
}

}  // namespace palpate::record_layout
