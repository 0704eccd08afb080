// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "array.h"
#include "palpate/sim/contact/tool.h"
#include "palpate/sim/model/load.h"
#include "palpate/sim/tick/tick_log.h"
#include "palpate/sim/tree/aabb_tree.h"

namespace palpate::bindings {

/// The NumPy dtype of one row of a table of structs, written once per struct below its class:
/// names and memory offsets of its fields, so structured arrays share memory with the table.
template <class T>
class RowType {
 public:
  template <class M>
  RowType& field(const char* name, M T::*member) {
    return field(name, member, py::dtype::of<typename Entry<M>::Scalar>(), Entry<M>::width);
  }

  /// An enum, shown as the integer it is stored as.
  template <class M>
  RowType& integer(const char* name, M T::*member) {
    return field(name, member, py::dtype::of<std::underlying_type_t<M>>(), 0);
  }

  /// A struct within the struct.
  template <class M>
  RowType& nested(const char* name, M T::*member, const py::dtype& type) {
    return field(name, member, type, 0);
  }

  py::dtype dtype() const { return py::dtype(names_, formats_, offsets_, sizeof(T)); }

 private:
  template <class M>
  RowType& field(const char* name, M T::*member, const py::dtype& type, py::ssize_t width) {
    names_.append(name);
    formats_.append(width == 0 ? py::object(type)
                               : py::object(py::make_tuple(type, py::make_tuple(width))));
    offsets_.append(reinterpret_cast<const char*>(&(example_.*member)) -
                    reinterpret_cast<const char*>(&example_));
    return *this;
  }

  T example_{};
  py::list names_, formats_, offsets_;
};

/// True for every struct that Python sees in structured arrays.
template <class T>
inline constexpr bool is_row = false;
template <>
inline constexpr bool is_row<Push> = true;
template <>
inline constexpr bool is_row<ToolState::Hold> = true;
template <>
inline constexpr bool is_row<ToolState::PatchPoint> = true;
template <>
inline constexpr bool is_row<HapticSample> = true;
template <>
inline constexpr bool is_row<Felt> = true;
template <>
inline constexpr bool is_row<Event> = true;
template <>
inline constexpr bool is_row<StateHash> = true;

/// One for every struct that Python sees in structured arrays.
template <class T>
py::dtype row_dtype();
template <>
py::dtype row_dtype<Push>();
template <>
py::dtype row_dtype<AabbTree::Node>();
template <>
py::dtype row_dtype<ToolState::Hold>();
template <>
py::dtype row_dtype<ToolState::PatchPoint>();
template <>
py::dtype row_dtype<HapticSample>();
template <>
py::dtype row_dtype<Felt>();
template <>
py::dtype row_dtype<Event>();
template <>
py::dtype row_dtype<StateHash>();
template <>
py::dtype row_dtype<TickLog::Tick>();

/// `count` structs at `data` as a structured array that shares memory and keeps `owner` alive: of
/// shape (count,), or with more than one column (count / columns, columns).
template <class T>
py::array view_rows(const T* data, std::size_t count, py::handle owner, int columns = 1) {
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(count) / columns};
  std::vector<py::ssize_t> strides = {static_cast<py::ssize_t>(sizeof(T)) * columns};
  if (columns > 1) {
    shape.push_back(columns);
    strides.push_back(static_cast<py::ssize_t>(sizeof(T)));
  }
  return py::array(row_dtype<T>(), shape, strides, data, owner);
}

template <class T>
py::array own_rows(std::vector<T> table, int columns = 1) {
  auto kept = std::make_unique<std::vector<T>>(std::move(table));
  const std::vector<T>& rows = *kept;
  const py::capsule owner(kept.release(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return view_rows(rows.data(), rows.size(), owner, columns);
}

/// Copies a structured array, or a sequence of bound structs, into a table. Where `columns` is
/// asked for, an array may have two dimensions, and its second is told there, else 1.
template <class T>
std::vector<T> copy_rows(const py::object& source, const char* name, int* columns = nullptr) {
  if (columns) *columns = 1;
  if (!py::isinstance<py::array>(source)) return source.cast<std::vector<T>>();

  const py::dtype type = row_dtype<T>();
  // NumPy matches the fields of structured types by place, not by name
  if (!source.attr("dtype").attr("names").equal(type.attr("names"))) {
    refuse(name, "fields " + py::str(source.attr("dtype").attr("names")).cast<std::string>(),
           py::str(type.attr("names")).cast<std::string>());
  }
  const py::array exact = py::module_::import("numpy").attr("ascontiguousarray")(source, type);
  const bool wide = columns && exact.ndim() == 2 && exact.shape(1) > 0;
  if (exact.ndim() != 1 && !wide) {
    refuse(name, "shape " + shape_of(exact), columns ? "(n,) or (n, k)" : "(n,)");
  }
  if (wide) *columns = static_cast<int>(exact.shape(1));
  std::vector<T> rows(static_cast<std::size_t>(exact.size()));
  const auto* bytes = static_cast<const char*>(exact.data());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::memcpy(static_cast<void*>(&rows[r]), bytes + r * sizeof(T), sizeof(T));
  }
  return rows;
}

/// A property that is a structured array sharing memory with a table of structs.
template <class Class, class T, class Of>
void def_rows(Class& cls, const char* name, std::vector<T> Of::*member, const char* doc) {
  cls.def_property_readonly(
      name,
      [member](const py::object& self) {
        const std::vector<T>& rows = self.cast<typename Class::type&>().*member;
        return view_rows(rows.data(), rows.size(), self);
      },
      doc);
}

/// The same, in a column for each instrument where there are several.
template <class Class, class T, class Of>
void def_rows(Class& cls, const char* name, std::vector<T> Of::*member, int Of::*columns,
              const char* doc) {
  cls.def_property_readonly(
      name,
      [member, columns](const py::object& self) {
        const auto& value = self.cast<typename Class::type&>();
        const std::vector<T>& rows = value.*member;
        return view_rows(rows.data(), rows.size(), self, value.*columns);
      },
      doc);
}

/// The same for rows that hold indices and must stay as they are.
template <class Class, class T, class Of>
void def_fixed_rows(Class& cls, const char* name, std::vector<T> Of::*member, const char* doc) {
  cls.def_property_readonly(
      name,
      [member](const py::object& self) {
        const std::vector<T>& rows = self.cast<typename Class::type&>().*member;
        return read_only(view_rows(rows.data(), rows.size(), self));
      },
      doc);
}

}  // namespace palpate::bindings
