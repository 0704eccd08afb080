// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/sim/session/record.h"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/base/private/whole_file.h"
#include "palpate/sim/session/private/record_writer.h"

namespace palpate {
namespace {

using record_layout::choose_layout;
using record_layout::complete_header;
using record_layout::Descriptor;
using record_layout::File;
using record_layout::Layout;
using record_layout::RecordWriter;

constexpr std::chrono::milliseconds kWriteInterval(250);
constexpr std::chrono::seconds kSyncInterval(1);
constexpr int kLogTicks = 4000;  // 4 s of them

/// The rows of a record with the tick numbers they had: a gap of n before tick t moves t and all
/// after it on by n.
std::vector<TickLog::Tick> number_ticks(const Record& record) {
  std::vector<TickLog::Tick> ticks;
  ticks.reserve(record.hand.size());
  const auto lanes = static_cast<std::size_t>(record.instruments);
  auto event = record.events.begin();
  std::int64_t number = 0;
  for (std::size_t i = 0; i < record.hand.size(); i += lanes, ++number) {
    for (; event != record.events.end(); ++event) {
      if (event->kind != EventKind::record_gap) continue;
      if (event->tick != number + event->index) break;
      number = event->tick;
    }
    for (std::size_t row = i; row < i + lanes; ++row) {
      ticks.push_back({number, record.hand[row], record.felt[row]});
    }
  }
  return ticks;
}

int validated(int instruments, int bodies = 1) {
  if (bodies < 1) refuse("record: bodies", write_text(bodies), "at least 1");
  if (instruments < 1 || instruments > kMostLoggedInstruments) {
    refuse("record: instruments", write_text(instruments),
           write_text("1 to ", kMostLoggedInstruments));
  }
  return instruments;
}

/// What has room for all that a record says.
Layout choose_layout_of(const Record& record) {
  const bool sources =
      std::ranges::any_of(record.events, [](const Event& event) { return event.source != 0; });
  return choose_layout(record.instruments, sources);
}

/// An empty file to record into: a new one, or the plain file that stands under the name.
std::unique_ptr<File> open_to_record(const std::string& path) {
  const int created =
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (created < 0 && errno != EEXIST) {
    throw FileError(path, "", std::strerror(errno), "a file that can be opened");
  }
  if (created >= 0) return std::make_unique<File>(path, Descriptor{created});
  // a pipe without a reader would be waited for
  auto file = std::make_unique<File>(path, O_WRONLY | O_NONBLOCK);
  file->size();  // refuses what is no plain file
  file->empty();
  return file;
}

/// The blocks that follow are of use only where the name of their file survives, too.
void sync_name(const std::string& path) {
  const std::filesystem::path file = path;
  if (const int problem = sync_folder(file.has_parent_path() ? file.parent_path() : ".")) {
    throw FileError(path, "", std::strerror(problem), "a folder that the disk syncs");
  }
}

}  // namespace

struct Recorder::Impl {
  Impl(const std::string& path_in, const std::string& header_json, RecordCodec codec,
       const Layout& layout)
      : path(path_in),
        header(complete_header(header_json, layout)),
        log(kLogTicks, layout.instruments),
        writer(open_to_record(path_in), header, layout, codec) {
    sync_name(path);
    thread = std::thread([this] { work(); });
  }

  void work();
  void empty_log(bool all);

  const std::string path, header;
  TickLog log;
  RecordWriter writer;
  std::vector<TickLog::Tick> ticks;
  std::vector<Event> events;
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
  log.take(ticks, events, hashes);
  try {
    if (!failure) writer.write(ticks, events, hashes, all);
  } catch (...) {
    failure = std::current_exception();
  }
  if (failure) {
    ticks.clear();
    events.clear();
    hashes.clear();
  }
}

Recorder::Recorder(const std::string& path, const std::string& header_json, RecordCodec codec,
                   int instruments, int bodies)
    : impl_(std::make_unique<Impl>(path, header_json, codec,
                                   choose_layout(validated(instruments, bodies), bodies > 1))) {}

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
  count_ticks(record);
  const Layout layout = choose_layout_of(record);
  const std::string header = complete_header(record.header, layout);
  WholeFile file(path);
  const int copy = ::fcntl(file.descriptor(), F_DUPFD_CLOEXEC, 0);
  if (copy < 0) throw FileError(path, "", std::strerror(errno), "a file that can be opened");
  RecordWriter writer(std::make_unique<File>(path, Descriptor{copy}), header, layout, codec);
  std::vector<TickLog::Tick> ticks = number_ticks(record);
  std::vector<Event> events = record.events;
  std::vector<StateHash> hashes = record.hashes;
  writer.write(ticks, events, hashes, true);
  writer.write_summary();
  file.commit();
}

}  // namespace palpate
