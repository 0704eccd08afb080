// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>

#include "array.h"
#include "palpate/sim/arm/plant.h"
#include "palpate/sim/dynamics/state.h"
#include "rows.h"

namespace palpate::bindings {

/// What every bound struct can do in Python: copy.copy, copy.deepcopy.
template <class Class>
void def_copy(Class& cls) {
  using T = typename Class::type;
  cls.def(
      "__copy__", [](const T& self) { return T(self); }, "A copy of its own.");
  cls.def(
      "__deepcopy__", [](const T& self, const py::dict&) { return T(self); }, "memo"_a,
      "A copy of its own.");
}

/// Rows that Python sees as an array, of numbers or of structs.
template <class T>
inline constexpr bool is_table = false;
template <class E>
inline constexpr bool is_table<std::vector<E>> = is_row<E> ||
                                                 (std::is_arithmetic_v<typename Entry<E>::Scalar> &&
                                                  !std::is_same_v<E, bool>);

/// A member of a struct as pickle keeps it.
template <class M>
py::object pack_member(const M& member) {
  if constexpr (std::is_same_v<M, Quaternion>) {
    return py::cast(Eigen::Vector4d(member.coeffs()));
  } else if constexpr (is_table<M>) {
    if constexpr (is_row<typename M::value_type>) {
      return own_rows(M(member));
    } else {
      return own(M(member));
    }
  } else {
    return py::cast(member);
  }
}

template <class M>
M unpack_member(const py::object& packed) {
  if constexpr (std::is_same_v<M, Quaternion>) {
    return Quaternion(packed.cast<Eigen::Vector4d>().data());
  } else if constexpr (is_table<M>) {
    using E = typename M::value_type;
    if constexpr (is_row<E>) {
      return copy_rows<E>(packed, "pickle");
    } else {
      using Scalar = typename Entry<E>::Scalar;
      const auto table = packed.cast<py::array_t<Scalar, py::array::c_style>>();
      M member(static_cast<std::size_t>(table.ndim() == 0 ? 0 : table.shape(0)));
      if (static_cast<std::size_t>(table.nbytes()) != member.size() * sizeof(E)) {
        refuse("pickle", "a table of shape " + shape_of(table), "rows as this version has them");
      }
      std::memcpy(static_cast<void*>(member.data()), table.data(), member.size() * sizeof(E));
      return member;
    }
  } else {
    return packed.cast<M>();
  }
}

/// A value whose members are still to come.
template <class T>
T make_blank() {
  return T{};
}
template <>
inline PlantState make_blank<PlantState>() {
  return PlantState(Plant());
}

/// What is left to do once the members are there: work space that is no part of the value.
template <class T>
void complete(T&) {}
template <>
inline void complete<State>(State& state) {
  const Vec3Array still(state.position.size(), Vec3::Zero());
  state.scratch = {still, still, still, still};
}

/// copy and pickle of a struct that is the sum of these members.
template <class Class, class... Members>
void def_value(Class& cls, Members... members) {
  using T = typename Class::type;
  def_copy(cls);
  cls.def(py::pickle(
      [=](const T& self) { return py::make_tuple(pack_member(self.*members)...); },
      [=](const py::tuple& packed) {
        if (packed.size() != sizeof...(Members)) {
          refuse("pickle", std::to_string(packed.size()) + " members",
                 std::to_string(sizeof...(Members)) + ", as this version has");
        }
        T made = make_blank<T>();
        std::size_t next = 0;
        ((made.*members = unpack_member<std::decay_t<decltype(made.*members)>>(packed[next++])),
         ...);
        complete(made);
        return made;
      }));
}

/// The call that would make a value, on one line: named fields, arrays in short.
std::string write_call(const py::object& self, const std::vector<const char*>& fields);

/// The elements of a vector whose length never changes, as a tuple of what lives as long as `self`.
template <class Owner, class T>
py::tuple show_elements(const py::object& self, std::vector<T> Owner::*member) {
  std::vector<T>& elements = self.cast<Owner&>().*member;
  py::tuple shown(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    shown[i] = py::cast(&elements[i], py::return_value_policy::reference_internal, self);
  }
  return shown;
}

template <class Class, class Owner, class T>
void def_elements(Class& cls, const char* name, std::vector<T> Owner::*member, const char* doc) {
  cls.def_property_readonly(
      name, [member](const py::object& self) { return show_elements(self, member); }, doc);
}

/// A repr that shows the named fields.
template <class Class>
void def_repr(Class& cls, std::initializer_list<const char*> fields) {
  const std::vector<const char*> names(fields);
  cls.def(
      "__repr__", [names](const py::object& self) { return write_call(self, names); },
      "The value on one line.");
}

/// A repr in words: "<Links: 120>".
template <class Class, class Describe>
void def_summary(Class& cls, Describe describe) {
  const std::string name = py::str(cls.attr("__name__"));
  cls.def(
      "__repr__",
      [name, describe](const typename Class::type& self) {
        return "<" + name + ": " + describe(self) + ">";
      },
      "What it is, on one line.");
}

}  // namespace palpate::bindings
