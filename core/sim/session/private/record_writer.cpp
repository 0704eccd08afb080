// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/session/private/record_writer.h"

#include <algorithm>
#include <stdexcept>

#include "palpate/sim/session/private/json_object.h"

namespace palpate::record_layout {
std::string complete_header(const std::string& header_json, const Layout& layout) {
  if (const auto problem = find_json_problem(header_json)) {
    throw std::invalid_argument("record header: got text that is not a JSON object: " + *problem);
  }
  std::string text = with_json_member(header_json, "prec", describe_columns(layout));
  if (text.size() > kMostHeaderBytes) {
    throw std::invalid_argument("record header: got " + std::to_string(text.size()) +
                                " bytes, expected at most 1 MiB");
  }
  return text;
}

RecordWriter::RecordWriter(std::unique_ptr<File> file, const std::string& header,
                           const Layout& layout, RecordCodec codec)
    : layout_(layout), codec_(codec), file_(std::move(file)) {
  Bytes preamble = pack_preamble(header, layout_);
  const Bytes crc = pack_u32(compute_crc(preamble));
  preamble.insert(preamble.end(), crc.begin(), crc.end());
  append(preamble);
  sync();
}

void RecordWriter::write(std::vector<TickLog::Tick>& ticks, std::vector<Event>& events,
                         std::vector<StateHash>& hashes, bool all) {
  write_ticks(ticks, all);
  if (layout_.version == 1) {
    // of one body: it would seem to be of the first, and no force depends on it
    std::erase_if(events, [](const Event& event) {
      return event.kind == EventKind::tree_exchanged && event.source != 0;
    });
  }
  write_rows(BlockKind::events, events, all, summary_.events);
  write_rows(BlockKind::hashes, hashes, all, summary_.hashes);
}

void RecordWriter::write_ticks(std::vector<TickLog::Tick>& rows, bool all) {
  const auto lanes = static_cast<std::size_t>(layout_.instruments);
  const std::size_t count = rows.size() / lanes;  // ticks
  const auto number = [&](std::size_t tick) { return rows[tick * lanes].tick; };
  std::size_t begin = 0;
  while (begin < count) {
    std::size_t end = begin + 1;
    while (end < count && end - begin < kBlockTicks && number(end) == number(end - 1) + 1) ++end;
    if (!all && end == count && end - begin < kBlockTicks) break;
    summary_.ticks += end - begin;
    if (const std::int64_t most = most_ticks(layout_);
        summary_.ticks > static_cast<std::uint64_t>(most)) {
      file_->refuse("", "more than " + std::to_string(most) + " ticks",
                    "a run of at most 2 h 19 min at 1 kHz, shared between the instruments");
    }
    write_block(BlockKind::ticks, codec_, number(begin), end - begin,
                std::span<const TickLog::Tick>(rows).subspan(begin * lanes, (end - begin) * lanes));
    last_tick_ = number(end - 1);
    begin = end;
  }
  rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(begin * lanes));
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
    write_block(kind, RecordCodec::none, rows[begin].tick, some,
                std::span<const Row>(rows).subspan(begin, some));
  }
  rows.erase(rows.begin(), later);
}

template <class Row>
void RecordWriter::write_block(BlockKind kind, RecordCodec codec, std::int64_t first_tick,
                               std::size_t count, std::span<const Row> rows) {
  BlockHeader header{.kind = kind,
                     .codec = static_cast<std::uint32_t>(codec),
                     .first_tick = first_tick,
                     .count = static_cast<std::uint32_t>(count),
                     .length = 0,
                     .crc = 0};
  Bytes body = pack(rows, layout_);
  if (codec == RecordCodec::deflate) {
    body = deflate(shuffle_differences(kind, layout_, header.count, body));
  }
  header.length = static_cast<std::uint32_t>(body.size());
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
