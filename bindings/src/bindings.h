// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include "calls.h"

namespace palpate::bindings {

// One or more per room of core/sim, called in this order: each needs the types of those before it.
// Where a folder takes more than one file, the first of them calls the others.
void bind_base(pybind11::module_& m);
void bind_mesh(pybind11::module_& m);
void bind_solid_mesh(pybind11::module_& m);
void bind_model(pybind11::module_& m);
void bind_law_tables(pybind11::module_& m);
void bind_solid_tables(pybind11::module_& m);
void bind_builders(pybind11::module_& m);
void bind_membrane(pybind11::module_& m);
void bind_solids(pybind11::module_& m);
void bind_dynamics(pybind11::module_& m);
void bind_forces(pybind11::module_& m);
void bind_response(pybind11::module_& m);
void bind_guard(pybind11::module_& m);
void bind_contact(pybind11::module_& m);
void bind_tree(pybind11::module_& m);
void bind_queries(pybind11::module_& m);
void bind_tick(pybind11::module_& m);
void bind_log(pybind11::module_& m);
void bind_costs(pybind11::module_& m);
void bind_scene(pybind11::module_& m);
void bind_rigid(pybind11::module_& m);
void bind_world(pybind11::module_& m);
void bind_devices(pybind11::module_& m);
void bind_safe_device(pybind11::module_& m);
void bind_arm(pybind11::module_& m);
void bind_plant(pybind11::module_& m);
void bind_serial(pybind11::module_& m);
void bind_multirate(pybind11::module_& m);
void bind_loop(pybind11::module_& m);
void bind_session(pybind11::module_& m);
void bind_bench(pybind11::module_& m);
void bind_scenario(pybind11::module_& parent);  ///< a submodule, as it is a namespace in C++

}  // namespace palpate::bindings
