// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "palpate/sim/base/private/realtime.h"
#include "palpate/sim/loop/private/pace.h"

using namespace palpate;

namespace {

constexpr std::int64_t kPeriod = 1000000;  // [ns]

/// Reports at once, or never, and remembers how long it would have been waited for.
struct ReportingDevice : HapticDevice {
  HapticSample read(double) noexcept override { return {}; }
  void write(const HapticCommand&) noexcept override {}
  std::string name() const override { return "reporting"; }
  double report_rate() const noexcept override { return rate; }
  bool wait_for_report(std::int64_t until) noexcept override {
    latest = until;
    ++waits;
    if (stopped > 0) wait_until(until + stopped, 0);
    return reports;
  }

  double rate = 1000.0;
  bool reports = true;
  std::int64_t latest = 0;  // [ns]
  int waits = 0;
  std::int64_t stopped = 0;  // [ns] that the process is stopped for, beyond what it would wait
};

}  // namespace

TEST_CASE("a tick begins with its report, and the next is expected a period after that") {
  ReportingDevice device;
  Pace pace(device, 1000.0, 0);
  pace.begin(0);

  std::int64_t due = pace.wait(0);
  CHECK(due <= read_clock());  // not when our clock would have had it
  for (int k = 1; k < 5; ++k) {
    // equal where the thread does not stand still between the report and its tick
    CHECK(pace.due(k) >= due + kPeriod);
    const std::int64_t latest = pace.due(k) + kPeriod / 2, before = due;
    due = pace.wait(k);
    CHECK(device.latest == latest);
    CHECK(due >= before);
    CHECK(due <= latest);
  }
  CHECK(pace.unpaced() == 0);
}

TEST_CASE("where reports stop our own clock counts, at the ticks' rate, until they come again") {
  ReportingDevice device;
  Pace pace(device, 1000.0, 0);
  pace.begin(0);
  const std::int64_t first = pace.wait(0);

  device.reports = false;
  for (int k = 1; k < 5; ++k) CHECK(pace.wait(k) == first + k * kPeriod + kPeriod / 2);
  CHECK(pace.unpaced() == 4);

  device.reports = true;
  const std::int64_t due = pace.wait(5);
  CHECK(due <= read_clock());
  CHECK(pace.unpaced() == 4);
}

TEST_CASE("ticks missed by a host that was stopped are late, whether a report lies ready or not") {
  constexpr std::int64_t kStop = 40 * kPeriod;
  for (bool reports : {true, false}) {
    ReportingDevice device;
    Pace pace(device, 1000.0, 0);
    pace.begin(0);
    pace.wait(0);
    const std::int64_t expected = pace.due(1);

    device.reports = reports;
    device.stopped = kStop;
    const std::int64_t due = pace.wait(1);

    CHECK(due <= expected + kPeriod / 2);
    CHECK(read_clock() - due >= kStop);
    CHECK(pace.due(2) == expected + kPeriod);  // so all that were due meanwhile count as missed
  }
}

TEST_CASE("after a stop the next report sets the pace again") {
  ReportingDevice device;
  Pace pace(device, 1000.0, 0);
  pace.begin(0);
  pace.wait(0);
  device.stopped = 5 * kPeriod;
  pace.wait(1);

  device.stopped = 0;
  constexpr int kFar = 10000;  // ten seconds from now by our clock, but its report lies ready
  const std::int64_t before = pace.due(kFar);
  const std::int64_t due = pace.wait(kFar);

  CHECK(due < before);
  CHECK(pace.due(kFar + 1) == due + kPeriod);
}

TEST_CASE("a device of another rate, or without a clock of its own, does not set the pace") {
  ReportingDevice device;
  for (double rate : {0.0, 500.0, 2000.0}) {
    device.rate = rate;
    Pace pace(device, 1000.0, 0);
    pace.begin(7);
    const std::int64_t due = pace.due(7);
    CHECK(pace.wait(7) == due);
    CHECK(read_clock() >= due);
  }
  CHECK(device.waits == 0);
}

TEST_CASE("of several devices the first that reports at the ticks' rate and has not failed paces") {
  struct FailingDevice : ReportingDevice {
    bool failed() const noexcept override { return gone; }
    bool gone = false;
  };
  ReportingDevice silent;
  FailingDevice first, second;
  silent.rate = 0.0;
  Pace pace({&silent, &first, &second}, 1000.0, 0);
  pace.begin(0);

  pace.wait(0);
  CHECK((silent.waits == 0 && first.waits == 1 && second.waits == 0));
  first.gone = true;
  pace.wait(1);
  CHECK((first.waits == 1 && second.waits == 1));
  second.gone = true;  // as one alone does: it is asked, and our clock counts where it is mute
  pace.wait(2);
  CHECK((first.waits == 2 && second.waits == 1));
  CHECK(silent.waits == 0);
}
