// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "arguments.h"
#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/base/types.h"

/// How tables of the library and NumPy arrays become each other.
///
/// What the library owns is seen through views, so writing into the array writes into the table
/// and the array keeps its owner alive. Tables never change their length while Python can see
/// them, so no view is left dangling. Indices are shown read-only: no write from Python can send
/// a kernel out of range. What is only read may be any array-like.
namespace palpate::bindings {

namespace py = pybind11;
using namespace pybind11::literals;

/// What one entry of a table looks like to NumPy: a number, or `width` numbers in a row.
template <class T>
struct Entry {
  using Scalar = T;
  static constexpr py::ssize_t width = 0;
};
template <>
struct Entry<Vec3> {
  using Scalar = double;
  static constexpr py::ssize_t width = 3;
};
template <>
struct Entry<Quaternion> {
  using Scalar = double;
  static constexpr py::ssize_t width = 4;
};
template <>
struct Entry<Eigen::Vector3f> {
  using Scalar = float;
  static constexpr py::ssize_t width = 3;
};
template <class T, std::size_t N>
struct Entry<std::array<T, N>> {
  using Scalar = T;
  static constexpr py::ssize_t width = N;
};
template <class T>
using ArrayOf = py::array_t<typename Entry<T>::Scalar>;

/// `count` entries at `data` as an array that shares their memory and keeps `owner` alive.
template <class T>
ArrayOf<T> view_entries(T* data, std::size_t count, py::handle owner) {
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(count)};
  if (Entry<T>::width > 0) shape.push_back(Entry<T>::width);
  return ArrayOf<T>(shape, reinterpret_cast<const typename Entry<T>::Scalar*>(data), owner);
}

template <class T>
ArrayOf<T> view(std::vector<T>& table, py::handle owner) {
  return view_entries(table.data(), table.size(), owner);
}

/// One vector or quaternion as an array of its numbers.
template <class T>
ArrayOf<T> view_one(T& value, py::handle owner) {
  return ArrayOf<T>({Entry<T>::width}, reinterpret_cast<const typename Entry<T>::Scalar*>(&value),
                    owner);
}

template <class Array>
Array read_only(Array array) {
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// Hands a table over to NumPy without copying its entries.
template <class T>
ArrayOf<T> own(std::vector<T> table) {
  auto kept = std::make_unique<std::vector<T>>(std::move(table));
  std::vector<T>& entries = *kept;
  const py::capsule owner(kept.release(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return view(entries, owner);
}

inline std::string shape_of(const py::array& array) {
  return py::str(array.attr("shape")).cast<std::string>();
}

inline void require_count(const char* name, std::size_t found, std::size_t expected) {
  if (found != expected) {
    refuse(name, std::to_string(found) + " entries", std::to_string(expected));
  }
}

/// An argument of shape (n, columns), or (n,) for no columns; checked.
template <class Argument>
auto read_table(const Argument& argument, const char* name, py::ssize_t columns = 0) {
  const std::string shape = columns > 0 ? "(n, " + std::to_string(columns) + ")" : "(n,)";
  const auto table = argument.read(name, shape);
  const bool fits =
      columns > 0 ? table.ndim() == 2 && table.shape(1) == columns : table.ndim() == 1;
  if (!fits) argument.refuse_shape(name, shape);
  return table;
}

/// Points of an array that must outlive the span.
inline std::span<const Vec3> points(const Numbers& argument, const char* name) {
  const auto table = read_table(argument, name, 3);
  return {reinterpret_cast<const Vec3*>(table.data()), static_cast<std::size_t>(table.shape(0))};
}

inline std::span<Vec3> points_out(const NumbersOut& argument, const char* name) {
  auto table = read_table(argument, name, 3);
  return {reinterpret_cast<Vec3*>(table.mutable_data()), static_cast<std::size_t>(table.shape(0))};
}

inline Vec3Array copy_points(const Numbers& argument, const char* name) {
  const auto all = points(argument, name);
  return {all.begin(), all.end()};
}

inline Quaternion to_quaternion(const Eigen::Vector4d& xyzw) {
  return Quaternion(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
}

inline std::span<const double> numbers(const Numbers& argument, const char* name) {
  const auto table = read_table(argument, name);
  return {table.data(), static_cast<std::size_t>(table.shape(0))};
}

template <class Scalar>
std::span<Scalar> entries_out(const Written<Scalar>& argument, const char* name) {
  auto table = read_table(argument, name);
  return {table.mutable_data(), static_cast<std::size_t>(table.shape(0))};
}

inline std::vector<double> copy_numbers(const Numbers& argument, const char* name) {
  const auto all = numbers(argument, name);
  return {all.begin(), all.end()};
}

inline int to_index(std::int64_t value, const char* name) {
  if (value < 0 || value > INT32_MAX) refuse(name, std::to_string(value), "an index of 0 or more");
  return static_cast<int>(value);
}

/// Room for more than any surface has would only take the machine's memory.
inline int to_count(std::int64_t value, const char* name) {
  constexpr std::int64_t kMost = 10'000'000;
  if (value < 0 || value > kMost) {
    refuse(name, std::to_string(value), "0 to " + std::to_string(kMost));
  }
  return static_cast<int>(value);
}

/// Indices, or where `count` says how many there are to choose from, a mask of so many booleans.
inline std::vector<int> copy_indices(const Integers& argument, const char* name,
                                     std::optional<std::size_t> count = {}) {
  if (const auto size = argument.mask_size(name); size && count) {
    if (*size != *count) {
      refuse(name, "a mask of " + std::to_string(*size) + " booleans",
             "indices, or a mask of " + std::to_string(*count));
    }
    return copy_indices(argument.find_true(), name);
  }
  const auto table = read_table(argument, name);
  std::vector<int> indices;
  indices.reserve(static_cast<std::size_t>(table.size()));
  for (py::ssize_t i = 0; i < table.size(); ++i) indices.push_back(to_index(table.data()[i], name));
  return indices;
}

/// Rows of N entries, as of the tables of links and angles; an empty array of any shape has none.
template <class T, std::size_t N, class Argument, class Convert>
std::vector<std::array<T, N>> copy_rows(const Argument& argument, const char* name,
                                        Convert convert) {
  const std::string shape = "(n, " + std::to_string(N) + ")";
  const auto table = argument.read(name, shape);
  if (table.size() == 0) return {};
  if (table.ndim() != 2 || table.shape(1) != static_cast<py::ssize_t>(N)) {
    argument.refuse_shape(name, shape);
  }
  std::vector<std::array<T, N>> rows(static_cast<std::size_t>(table.shape(0)));
  const auto* next = table.data();
  for (auto& row : rows) {
    for (T& entry : row) entry = convert(*next++);
  }
  return rows;
}

template <std::size_t N>
std::vector<std::array<int, N>> copy_index_rows(const Integers& argument, const char* name) {
  return copy_rows<int, N>(argument, name, [name](std::int64_t i) { return to_index(i, name); });
}

inline std::vector<std::array<double, 3>> copy_triples(const Numbers& argument, const char* name) {
  return copy_rows<double, 3>(argument, name, [](double value) { return value; });
}

inline std::vector<std::array<double, 4>> copy_quads(const Numbers& argument, const char* name) {
  return copy_rows<double, 4>(argument, name, [](double value) { return value; });
}

inline std::vector<std::array<double, 6>> copy_tensors(const Numbers& argument, const char* name) {
  return copy_rows<double, 6>(argument, name, [](double value) { return value; });
}

/// A property that is a view of a table: its numbers may be written, its length may not change.
template <class Class, class T, class Of>
void def_view(Class& cls, const char* name, std::vector<T> Of::*member, const char* doc) {
  cls.def_property_readonly(
      name,
      [member](const py::object& self) {
        return view(self.cast<typename Class::type&>().*member, self);
      },
      doc);
}

/// The same for tables that must stay as they are.
template <class Class, class T, class Of>
void def_table(Class& cls, const char* name, std::vector<T> Of::*member, const char* doc) {
  cls.def_property_readonly(
      name,
      [member](const py::object& self) {
        return read_only(view(self.cast<typename Class::type&>().*member, self));
      },
      doc);
}

/// A vector: reading gives a view of its three numbers, assigning copies three numbers in.
template <class Class, class Of>
void def_vector(Class& cls, const char* name, Vec3 Of::*member, const char* doc) {
  cls.def_property(
      name,
      [member](const py::object& self) {
        return view_one(self.cast<typename Class::type&>().*member, self);
      },
      [member](typename Class::type& self, const Vec3& value) { self.*member = value; },
      (std::string(doc) + (std::string(doc).back() == '.' ? " S" : "; s") + "hape (3,), a view.")
          .c_str());
}

}  // namespace palpate::bindings
