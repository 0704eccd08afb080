// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "palpate/sim/task/task.h"
#include "palpate/sim/tick/tick.h"
#include "palpate/sim/tick/tick_log.h"

namespace palpate {

/// A whole run in memory: enough to run it again.
struct Record {
  std::string header;  ///< JSON: version, kernel, build, scene hash, device, columns, ...
  std::vector<HapticSample> hand;  ///< per tick, those of all instruments in order
  std::vector<Felt> felt;          ///< likewise
  std::vector<Event> events;
  std::vector<StateHash> hashes;  ///< at 1 Hz
  bool complete = false;          ///< the file has its summary and the summary's SHA-256 holds
  int instruments = 1;            ///< rows of hand and of felt a tick
};

/// Ticks of a record. Throws std::invalid_argument where hand and felt are not as many whole ones,
/// or the instruments not 1 to kMostLoggedInstruments.
std::size_t count_ticks(const Record& record);

/// How a block's body is stored.
enum class RecordCodec { none, deflate };

/// Writes a `.prec` record while it is being made: an append-only file of blocks of 250 ticks,
/// each with its own CRC, readable up to its last whole block at any moment. The layout, and
/// why it is no other, stand in core/sim/session/RECORD.md.
///
/// The haptic thread pushes into log(); a writer thread of this class empties it into the file
/// every 250 ms and syncs every second.
class Recorder {
 public:
  /// `header_json` is one JSON object; the column table and the format version are added to it.
  /// `instruments` and `bodies` are how many the scene has: those of one of each have the first
  /// version of the format. Throws FileError when the file cannot be written,
  /// std::invalid_argument for a bad header or other numbers than 1 to kMostLoggedInstruments
  /// instruments and at least one body.
  Recorder(const std::string& path, const std::string& header_json,
           RecordCodec codec = RecordCodec::deflate, int instruments = 1, int bodies = 1);
  ~Recorder();  ///< finishes if nobody did

  TickLog& log() noexcept;

  /// Writes what is left, then the summary with the SHA-256 of all before it; syncs.
  /// Throws FileError.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Writes a whole record at once, to a temporary name, synced, renamed. Throws FileError.
void write_record(const std::string& path, const Record& record,
                  RecordCodec codec = RecordCodec::deflate);

/// Reads a record; an unfinished file ends at its last good block (complete = false).
/// Throws FileError for anything else that is wrong, naming block and field.
Record read_record(const std::string& path);

/// How a replay compares with what was recorded.
struct ReplayReport {
  long ticks = 0;
  bool equal = false;          ///< every force, every tool position and every hash, bit by bit
  long first_difference = -1;  ///< tick, -1 for none
  double largest_force_difference = 0.0;     ///< [N]
  double largest_position_difference = 0.0;  ///< [m] of the tool
  std::vector<Felt> felt;                    ///< as replayed, rows as in the record
  int instruments = 1;                       ///< rows of felt a tick

  // of a task that was judged
  TaskState task;                    ///< at its end; without steps where there was none
  std::vector<Event> events;         ///< of the task, as judged again
  bool events_equal = true;          ///< the record has the very same
  long first_event_difference = -1;  ///< tick, -1 for none
};

/// Runs the recorded hands through the same tick from a fresh world, and judges a task, of
/// build_task with that scene, where one is given. What the judge leaves undecided came out as the
/// record says: left, a fault of the device, or interrupted, where it does not say. Throws
/// std::invalid_argument for a record that lost ticks, or of another number of instruments than the
/// scene or the task has. It takes as long as the run computed: `stopped`, asked before every tick,
/// ends it there, and the report, of the ticks until then, is not equal.
ReplayReport replay(const Scene& scene, const Record& record, const Task* task = nullptr,
                    const std::function<bool()>& stopped = {});

/// How the task of a recorded run came out: as its last event says, else `interrupted`, also for a
/// record without a task.
Outcome find_outcome(const Record& record) noexcept;

}  // namespace palpate
