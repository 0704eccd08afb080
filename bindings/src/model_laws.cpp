// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"
#include "border.h"
#include "palpate/sim/model/private/law_tables.h"
#include "value.h"

// The tables of laws in Python, class by class, from what the table of laws says of their columns.

namespace palpate::bindings {

namespace {

template <class Column>
struct Bound;

template <class T, std::size_t N>
struct Bound<laws::Corners<T, N>> {
  using Argument = const Integers&;
  static std::vector<std::array<int, N>> copy(const Integers& argument, const char* name) {
    return copy_index_rows<N>(argument, name);
  }
};

template <class T, class Row>
struct Bound<laws::Numbers<T, Row>> {
  using Argument = const Numbers&;
  static std::vector<Row> copy(const Numbers& argument, const char* name) {
    if constexpr (std::is_same_v<Row, double>) {
      return copy_numbers(argument, name);
    } else if constexpr (std::tuple_size_v<Row> == 3) {
      return copy_triples(argument, name);
    } else {
      return copy_quads(argument, name);
    }
  }
};

template <class T>
struct Bound<laws::Scalar<T>> {
  using Argument = double;
  static double copy(double argument, const char*) { return argument; }
};

/// Where a column or number stands in its table.
template <class T, class Column>
auto find_member(const Column& column) {
  if constexpr (requires { column.rows; }) {
    return column.rows;
  } else {
    return column.value;
  }
}

template <class T, class Column>
auto make_argument(const Column& column) {
  if constexpr (requires { column.rows; }) {
    return py::arg(column.name);
  } else {
    return py::arg(column.name) = T().*column.value;
  }
}

/// "[N/m] of that difference, shape (rows, 3); a view."
template <class Row>
std::string write_doc(const std::string& unit, const char* text, const char* end) {
  std::string doc = unit;
  if (*text != 0) doc += (unit.empty() ? "" : " ") + std::string(text);
  if constexpr (std::is_arithmetic_v<Row>) {
    return doc + ", shape (rows,); " + end;
  } else {
    return doc + write_text(", shape (rows, ", std::tuple_size_v<Row>, "); ") + end;
  }
}

constexpr const char* kView = "a view.";
constexpr const char* kReadOnly = "a view, read-only.";

template <class T>
void def_columns(py::class_<T>& cls, const auto& table) {
  laws::for_each_column(
      table,
      laws::Overloaded{
          [&]<std::size_t N>(const laws::Corners<T, N>& column) {
            def_table(cls, column.name, column.rows,
                      write_doc<std::array<int, N>>("", column.doc, kReadOnly).c_str());
          },
          [&]<class Row>(const laws::Numbers<T, Row>& column) {
            def_view(cls, column.name, column.rows,
                     write_doc<Row>(write_text("[", column.unit, "]"), column.doc, kView).c_str());
          },
          [&](const laws::Particles<T>& column) {
            def_table(cls, column.name, column.rows,
                      write_doc<int>("", column.doc, kReadOnly).c_str());
          },
          [&](const laws::Derived<T>& column) {
            def_table(cls, column.name, column.rows,
                      write_text(column.doc, "; a view, read-only.").c_str());
          },
          [&](const laws::Scalar<T>& number) {
            cls.def_readwrite(number.name, number.value,
                              write_text("[", number.unit, "] ", number.doc).c_str());
          }});
}

/// From its columns, where none follows from others.
template <class T, class... Columns>
void def_init(py::class_<T>& cls, const laws::Table<T, Columns...>& table) {
  if constexpr ((requires { typename Bound<Columns>::Argument; } && ...)) {
    std::apply(
        [&](const Columns&... column) {
          cls.def(py::init([=](typename Bound<Columns>::Argument... arguments) {
                    T made;
                    ((made.*find_member<T>(column) = Bound<Columns>::copy(arguments, column.name)),
                     ...);
                    return made;
                  }),
                  make_argument<T>(column)..., "Copies its tables.");
        },
        table.columns);
  }
  cls.def(py::init<>());
}

template <class T, class... Columns>
void bind_table(py::module_& m, const laws::Table<T, Columns...>& table) {
  if (py::hasattr(m, table.type)) return;  // springs and bonds are of one class
  py::class_<T> cls(m, table.type, table.doc);
  def_init(cls, table);
  def_columns(cls, table);
  std::apply([&](const Columns&... column) { def_value(cls, find_member<T>(column)...); },
             table.columns);
  def_summary(cls, [table](const T& self) {
    if constexpr (std::is_same_v<T, Links>) {
      if (self.ends.empty()) return std::string("none");
      const auto [least, most] = std::minmax_element(self.stiffness.begin(), self.stiffness.end());
      return write_text(self.ends.size(), ", ", *least, " to ", *most, " N/m");
    } else {
      if constexpr (laws::is_numbers<laws::Table<T, Columns...>>) {
        return table.words(self);
      } else {
        return write_text((self.*std::get<0>(table.columns).rows).size(), " ", table.row);
      }
    }
  });
}

}  // namespace

void bind_law_tables(py::module_& m) {
  laws::for_each_table([&](const auto& table) { bind_table(m, table); });
}

}  // namespace palpate::bindings
