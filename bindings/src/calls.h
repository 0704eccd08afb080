// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace palpate::bindings {

/// Refuses Python subclasses that override what only C++ calls.
void refuse_overrides(const pybind11::object& interface);

/// Last of all of a module: what every call of its functions then passes through.
void bind_calls(pybind11::module_& m);

}  // namespace palpate::bindings
