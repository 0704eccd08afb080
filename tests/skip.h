// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <doctest/doctest.h>

#include <cstdio>

namespace palpate::testing {

/// Says that the running test case cannot run here, in the words that summarise.py counts.
inline void report_skipped(const char* reason) {
  std::printf("SKIPPED: %s (%s)\n", reason, doctest::getContextOptions()->currentTest->m_name);
}

}  // namespace palpate::testing

/// Ends a test case that cannot run here, counted as skipped. Its first statement.
#define SKIP_UNLESS(condition, reason)          \
  do {                                          \
    if (!(condition)) {                         \
      palpate::testing::report_skipped(reason); \
      return;                                   \
    }                                           \
  } while (false)
