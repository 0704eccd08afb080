// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

#include "palpate/scenario/container.h"
#include "palpate/sim/base/types.h"

// Not installed: tables of the library as arrays of a file, and back.

namespace palpate::scenario {

/// What one row of a table is: one number, or `columns` of them.
template <class Row>
struct RowOf {
  using Number = Row;
  static constexpr std::int64_t columns = 0;
};
template <>
struct RowOf<Vec3> {
  using Number = double;
  static constexpr std::int64_t columns = 3;
};
template <class T, std::size_t N>
struct RowOf<std::array<T, N>> {
  using Number = T;
  static constexpr std::int64_t columns = N;
};

template <class Row>
constexpr Dtype dtype_of() {
  using Number = typename RowOf<Row>::Number;
  static_assert(std::is_same_v<Number, double> ||
                (std::is_same_v<Number, int> && sizeof(int) == 4));
  return std::is_same_v<Number, double> ? Dtype::f8 : Dtype::i4;
}

/// Turns every `width` bytes round where the machine is big-endian.
inline void swap_if_big_endian(std::span<std::uint8_t> bytes, std::size_t width) {
  if constexpr (std::endian::native == std::endian::big) {
    for (std::size_t at = 0; at < bytes.size(); at += width) {
      std::reverse(bytes.begin() + at, bytes.begin() + at + width);
    }
  }
}

template <class Row>
Array to_array(const std::vector<Row>& table) {
  static_assert(sizeof(Row) % sizeof(typename RowOf<Row>::Number) == 0);
  Array array{dtype_of<Row>(), {static_cast<std::int64_t>(table.size())}, {}};
  if (RowOf<Row>::columns > 0) array.shape.push_back(RowOf<Row>::columns);
  array.bytes.resize(table.size() * sizeof(Row));
  if (!table.empty()) std::memcpy(array.bytes.data(), table.data(), array.bytes.size());
  swap_if_big_endian(array.bytes, width_of(array.dtype));
  return array;
}

/// Whether the array has the dtype and the columns of the table.
template <class Row>
bool is_table(const Array& array) {
  constexpr bool wide = RowOf<Row>::columns > 0;
  return array.dtype == dtype_of<Row>() && array.shape.size() == (wide ? 2 : 1) &&
         (!wide || array.shape[1] == RowOf<Row>::columns);
}

/// The array must be a table of these rows.
template <class Row>
std::vector<Row> to_table(Array array) {
  swap_if_big_endian(array.bytes, width_of(array.dtype));
  std::vector<Row> table(array.bytes.size() / sizeof(Row));
  if (!table.empty()) {
    std::memcpy(static_cast<void*>(table.data()), array.bytes.data(), array.bytes.size());
  }
  return table;
}

}  // namespace palpate::scenario
