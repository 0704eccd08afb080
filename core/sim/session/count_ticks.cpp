// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>
#include <string>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/session/record.h"

namespace palpate {

std::size_t count_ticks(const Record& record) {
  if (record.instruments < 1 || record.instruments > kMostLoggedInstruments) {
    refuse("record: instruments", write_text(record.instruments),
           write_text("1 to ", kMostLoggedInstruments));
  }
  const auto lanes = static_cast<std::size_t>(record.instruments);
  if (record.hand.size() != record.felt.size()) {
    throw std::invalid_argument("record: got " + std::to_string(record.hand.size()) +
                                " hand samples and " + std::to_string(record.felt.size()) +
                                " felt ones, expected as many of both");
  }
  if (record.hand.size() % lanes != 0) {
    refuse("record: hand", write_text(record.hand.size(), " samples"),
           write_text("a multiple of ", lanes, ", one for each instrument in every tick"));
  }
  return record.hand.size() / lanes;
}

}  // namespace palpate
