// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "palpate/sim/session/private/record_file.h"

namespace palpate::record_layout {

/// The header with the description of the columns. Throws std::invalid_argument for text that is
/// not a JSON object, so that no file is touched for it.
std::string complete_header(const std::string& header_json, const Layout& layout);

/// Appends blocks to a file and remembers what its summary will have to say.
class RecordWriter {
 public:
  /// Writes and syncs the header, of complete_header(), into a file that is open, empty, and closed
  /// with this. Throws FileError.
  RecordWriter(std::unique_ptr<File> file, const std::string& header, const Layout& layout,
               RecordCodec codec);

  /// Writes full blocks of ticks, and the events and hashes whose tick is written, so that
  /// the file is sound wherever it ends; keeps back the rest, unless `all`. What was written is
  /// taken out of the lists. A tick has a row for each instrument.
  void write(std::vector<TickLog::Tick>& ticks, std::vector<Event>& events,
             std::vector<StateHash>& hashes, bool all);

  /// The last block; syncs.
  void write_summary();
  void sync() { file_->sync(); }

 private:
  void write_ticks(std::vector<TickLog::Tick>& rows, bool all);
  template <class Row>
  void write_rows(BlockKind kind, std::vector<Row>& rows, bool all, std::uint64_t& total);
  template <class Row>
  void write_block(BlockKind kind, RecordCodec codec, std::int64_t first_tick, std::size_t count,
                   std::span<const Row> rows);
  void append(std::span<const std::uint8_t> bytes);

  const Layout layout_;
  RecordCodec codec_;
  std::unique_ptr<File> file_;
  Sha256 sha256_;
  Summary summary_;
  std::int64_t last_tick_ = -1;
};

}  // namespace palpate::record_layout
