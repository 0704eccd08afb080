// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/session/record.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "palpate/sim/base/error.h"
#include "palpate/sim/session/record_writer.h"

namespace palpate {
namespace {

using record_layout::File;
using record_layout::RecordWriter;

constexpr std::chrono::milliseconds kWriteInterval(250);
constexpr std::chrono::seconds kSyncInterval(1);

/// The rows of a record with the tick numbers they had: a gap of n before tick t moves t and all
/// after it on by n.
std::vector<TickLog::Tick> number_ticks(const Record& record) {
  std::vector<TickLog::Tick> ticks;
  ticks.reserve(record.hand.size());
  auto happening = record.happenings.begin();
  std::int64_t number = 0;
  for (std::size_t i = 0; i < record.hand.size(); ++i, ++number) {
    for (; happening != record.happenings.end(); ++happening) {
      if (happening->kind != HappeningKind::record_gap) continue;
      if (happening->tick != number + happening->index) break;
      number = happening->tick;
    }
    ticks.push_back({number, record.hand[i], record.felt[i]});
  }
  return ticks;
}

void validate(const Record& record) {
  if (record.hand.size() != record.felt.size()) {
    throw std::invalid_argument("record: got " + std::to_string(record.hand.size()) +
                                " hand samples and " + std::to_string(record.felt.size()) +
                                " felt ones, expected as many of both");
  }
}

/// Makes a rename survive a loss of power.
void sync_folder(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  File(folder.string(), O_RDONLY | O_DIRECTORY).sync();
}

}  // namespace

struct Recorder::Impl {
  Impl(const std::string& path_in, const std::string& header_json, RecordCodec codec)
      : path(path_in),
        writer(path_in, O_WRONLY | O_TRUNC, header_json, codec),
        thread([this] { work(); }) {}

  void work();
  void empty_log(bool all);

  const std::string path;
  TickLog log;
  RecordWriter writer;
  std::vector<TickLog::Tick> ticks;
  std::vector<Happening> happenings;
  std::vector<StateHash> hashes;
  std::exception_ptr failure;

  std::mutex mutex;
  std::condition_variable wake;
  bool stopping = false;
  bool finished = false;
  std::thread thread;
};

void Recorder::Impl::work() {
  auto synced = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex);
  while (!wake.wait_for(lock, kWriteInterval, [this] { return stopping; })) {
    lock.unlock();
    empty_log(false);
    if (const auto now = std::chrono::steady_clock::now(); now - synced >= kSyncInterval) {
      try {
        if (!failure) writer.sync();
      } catch (...) {
        failure = std::current_exception();
      }
      synced = now;
    }
    lock.lock();
  }
}

/// After a failure the log is still emptied: the run goes on, and finish() will tell.
void Recorder::Impl::empty_log(bool all) {
  log.take(ticks, happenings, hashes);
  try {
    if (!failure) writer.write(ticks, happenings, hashes, all);
  } catch (...) {
    failure = std::current_exception();
  }
  if (failure) {
    ticks.clear();
    happenings.clear();
    hashes.clear();
  }
}

Recorder::Recorder(const std::string& path, const std::string& header_json, RecordCodec codec)
    : impl_(std::make_unique<Impl>(path, header_json, codec)) {}

Recorder::~Recorder() {
  try {
    finish();
  } catch (const std::exception&) {
    // a destructor has nobody to tell; the file ends at its last whole block
  }
}

TickLog& Recorder::log() noexcept { return impl_->log; }

void Recorder::finish() {
  if (impl_->finished) return;
  impl_->finished = true;
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->stopping = true;
  }
  impl_->wake.notify_all();
  impl_->thread.join();
  impl_->empty_log(true);
  if (impl_->failure) std::rethrow_exception(impl_->failure);
  impl_->writer.write_summary();
}

void write_record(const std::string& path, const Record& record, RecordCodec codec) {
  validate(record);
  static std::atomic<int> next{0};
  const std::string part =
      path + ".part-" + std::to_string(::getpid()) + "-" + std::to_string(next.fetch_add(1));
  try {
    RecordWriter writer(part, O_WRONLY | O_EXCL, record.header, codec);
    std::vector<TickLog::Tick> ticks = number_ticks(record);
    std::vector<Happening> happenings = record.happenings;
    std::vector<StateHash> hashes = record.hashes;
    writer.write(ticks, happenings, hashes, true);
    writer.write_summary();
    if (std::rename(part.c_str(), path.c_str()) != 0) {
      throw FileError(path, "", std::strerror(errno), "a file that can be written");
    }
  } catch (...) {
    ::unlink(part.c_str());
    throw;
  }
  sync_folder(path);
}

}  // namespace palpate
