// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "palpate/sim/model/private/law_tables.h"

// What validate() checks of every law by its entry in the table of laws: as many rows in each
// column, particles that there are, numbers within their limits.

namespace palpate::laws {

inline const char* describe(Limit limit) noexcept {
  switch (limit) {
    case Limit::finite:
      return "a finite number";
    case Limit::not_negative:
      return "0 or a positive number";
    case Limit::positive:
      return "a positive number";
    case Limit::within_one:
      return "between -1 and 1";
    case Limit::share:
      return "0 to 1";
  }
  return "";
}

inline bool holds(Limit limit, double number) noexcept {
  switch (limit) {
    case Limit::finite:
      return std::isfinite(number);
    case Limit::not_negative:
      return std::isfinite(number) && number >= 0.0;
    case Limit::positive:
      return std::isfinite(number) && number > 0.0;
    case Limit::within_one:
      return std::abs(number) < 1.0;
    case Limit::share:
      return number >= 0.0 && number <= 1.0;
  }
  return false;
}

inline std::string name_column(const char* table, const char* column) {
  return write_text("model: ", table, ".", column);
}

inline std::string name_row(const char* table, const char* column, std::size_t row) {
  return write_text(name_column(table, column), ": row ", row);
}

/// "3.5 N/m"; a bare number where the unit is "-".
inline std::string write_number(double number, const char* unit) {
  return *unit == '-' ? write_text(number) : write_text(number, " ", unit);
}

inline void check_size(const std::string& where, std::size_t got, std::size_t expected) {
  if (got != expected) refuse(where, write_text(got, " rows"), write_text(expected));
}

/// Two particles ascend, more are all different.
template <std::size_t N>
void check_corners(const char* table, const char* column,
                   const std::vector<std::array<int, N>>& rows, int particles) {
  constexpr std::array kExpected = {"",
                                    "",
                                    "two ascending particles, 0 to ",
                                    "three different particles, 0 to ",
                                    "four different particles, 0 to ",
                                    "five different particles, 0 to ",
                                    "six different particles, 0 to "};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    std::array<int, N> ids = rows[row];
    const bool ascends = std::ranges::is_sorted(ids);
    std::ranges::sort(ids);
    const bool different = std::ranges::adjacent_find(ids) == ids.end();
    if (ids.front() >= 0 && ids.back() < particles && different && (N > 2 || ascends)) continue;
    std::string got;
    for (const int id : rows[row]) got += write_text(got.empty() ? "" : ", ", id);
    refuse(name_row(table, column, row), got, write_text(kExpected[N], particles - 1));
  }
}

inline void check_ascending(const char* table, const char* column, const std::vector<int>& rows,
                            int particles) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const bool ascends = row == 0 || rows[row] > rows[row - 1];
    if (rows[row] >= 0 && rows[row] < particles && ascends) continue;
    refuse(name_row(table, column, row), write_text("particle ", rows[row]),
           write_text("ascending particles, 0 to ", particles - 1));
  }
}

template <class T, class Row>
void check_numbers(const char* table, const Numbers<T, Row>& column, const std::vector<Row>& rows) {
  const auto check = [&](std::size_t row, double number) {
    if (holds(column.limit, number)) return;
    refuse(name_row(table, column.name, row), write_number(number, column.unit),
           describe(column.limit));
  };
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if constexpr (std::is_same_v<Row, double>) {
      check(row, rows[row]);
    } else {
      for (const double number : rows[row]) check(row, number);
    }
  }
}

/// Throws std::invalid_argument, naming table, column and row.
template <class SomeTable>
void check_table(const TissueModel& model, const SomeTable& table) {
  using T = typename SomeTable::Rows;
  const T& rows = model.*table.of;
  const std::size_t count = count_rows(model, table);
  const int particles = particle_count(model);
  for_each_column(table, Overloaded{[&]<class Row>(const Numbers<T, Row>& column) {
                                      check_size(name_column(table.name, column.name),
                                                 (rows.*column.rows).size(), count);
                                    },
                                    [](const auto&) {}});
  for_each_column(
      table, Overloaded{[&]<std::size_t N>(const Corners<T, N>& column) {
                          check_corners(table.name, column.name, rows.*column.rows, particles);
                        },
                        [&](const Particles<T>& column) {
                          check_ascending(table.name, column.name, rows.*column.rows, particles);
                        },
                        [&]<class Row>(const Numbers<T, Row>& column) {
                          check_numbers(table.name, column, rows.*column.rows);
                        },
                        [&](const Scalar<T>& scalar) {
                          if (holds(scalar.limit, rows.*scalar.value)) return;
                          refuse(name_column(table.name, scalar.name),
                                 write_number(rows.*scalar.value, scalar.unit),
                                 describe(scalar.limit));
                        },
                        [](const Derived<T>&) {}});
}

}  // namespace palpate::laws
