// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include "palpate/sim/task/task.h"

namespace palpate::bindings {

void bind_task(pybind11::module_& m);          ///< called by bind_tick, before the loop
void bind_task_kinds(pybind11::module_& m);    ///< its enumerations
void bind_task_objects(pybind11::module_& m);  ///< cameras, and what is no tissue
void bind_assessment(pybind11::module_& m);    ///< called by bind_scenario, of its submodule

/// Throws std::invalid_argument for a task that build_task has not made for this scene.
void require_fit(const Task& task, const Scene& scene);

}  // namespace palpate::bindings
