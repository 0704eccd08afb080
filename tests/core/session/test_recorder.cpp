// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <random>
#include <thread>

#include "core/session/some_record.h"
#include "palpate/sim/base/error.h"
#include "palpate/sim/session/record.h"
#include "skip.h"

using namespace palpate;
using namespace palpate::testing;

namespace {

/// Pushes what a run of the loop would: every tick, now and then an event, a hash a second.
void push(TickLog& log, std::int64_t i) {
  log.push(some_tick(i));
  if (i % 300 == 7) log.push(Event{i, EventKind::missed_ticks, 1, 0.0});
  if (i % 1000 == 999) log.push(StateHash{i, {static_cast<std::uint64_t>(i), 42}});
}

Record expected_record(int ticks) {
  Record record;
  for (int i = 0; i < ticks; ++i) {
    const TickLog::Tick tick = some_tick(i);
    record.hand.push_back(tick.sample);
    record.felt.push_back(tick.felt);
    if (i % 300 == 7) record.events.push_back({i, EventKind::missed_ticks, 1, 0.0});
    if (i % 1000 == 999) record.hashes.push_back({i, {static_cast<std::uint64_t>(i), 42}});
  }
  return record;
}

}  // namespace

TEST_CASE("what is pushed while the recorder writes is in the file once it has finished") {
  const Folder folder;
  for (const RecordCodec codec : {RecordCodec::none, RecordCodec::deflate}) {
    Recorder recorder(folder.file("run.prec"), "{}", codec);
    for (int i = 0; i < 3300; ++i) {
      push(recorder.log(), i);
      if (i % 1000 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(260));
    }

    recorder.finish();
    recorder.finish();

    const Record back = read_record(folder.file("run.prec"));
    CHECK(is_same(back, expected_record(3300)));
    CHECK(back.complete);
  }
}

TEST_CASE("a recorder that goes away finishes its file") {
  const Folder folder;
  {
    Recorder recorder(folder.file("run.prec"), "{}");
    for (int i = 0; i < 10; ++i) push(recorder.log(), i);
  }

  const Record back = read_record(folder.file("run.prec"));

  CHECK(back.complete);
  CHECK(back.hand.size() == 10);
}

TEST_CASE("a recorder that can write nothing more says so when it finishes") {
  // every write to this device fails as on a full disk
  const int full = ::open("/dev/full", O_WRONLY);
  SKIP_UNLESS(full >= 0, "there is no /dev/full");
  ::close(full);

  CHECK_THROWS_AS(Recorder("/dev/full", "{}"), FileError);
  CHECK_THROWS_AS(Recorder("/no/such/folder/run.prec", "{}"), FileError);
}

TEST_CASE("a writer killed at any moment leaves a readable beginning of what it was given") {
  const Folder folder;
  const Record whole = expected_record(20000);
  std::mt19937 random(5);
  std::size_t seen = 0;
  for (int round = 0; round < 6; ++round) {
    const std::string path = folder.file("killed.prec");
    std::filesystem::remove(path);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      Recorder recorder(path, "{}");
      for (int i = 0; i < 20000; ++i) {
        push(recorder.log(), i);
        if (i % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
      }
      std::this_thread::sleep_for(std::chrono::seconds(60));
      ::_exit(0);
    }
    const int patience = 300 + static_cast<int>(random() % 500);
    std::this_thread::sleep_for(std::chrono::milliseconds(patience));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);

    try {
      const Record back = read_record(path);
      CHECK(is_prefix(back, whole));
      CHECK_FALSE(back.complete);
      seen += back.hand.size();
    } catch (const FileError& error) {
      // killed before it had made the header
      CHECK(error.where.starts_with("header"));
    }
  }
  CHECK(seen > 0);
}
