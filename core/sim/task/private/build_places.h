// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/task/task.h"

// How build_task checks places and objects; each throws std::invalid_argument.

namespace palpate {

inline std::string name_row(const char* table, std::size_t row, const char* field) {
  return write_text("task: ", table, "[", row, "].", field);
}

inline void check_index(const std::string& where, int index, int least, std::size_t count) {
  if (index >= least && index < static_cast<int>(count)) return;
  refuse(where, std::to_string(index), write_text(least, " to ", static_cast<long>(count) - 1));
}

inline void check_number(const std::string& where, double value, double least, double most) {
  if (value >= least && value <= most) return;  // refuses what is not a number too
  refuse(where, write_text(value), write_text(least, " to ", most));
}

inline const TaskPlace& place_of(const Task& task, int place) {
  return task.places[static_cast<std::size_t>(place)];
}

/// Every scenery, then every rigid body.
std::vector<TaskObject> build_objects(const Scene& scene);

/// Checks a place and fills in what is derived; surfaces and objects are there.
void build_place(const Scene& scene, Task& task, std::size_t p);

}  // namespace palpate
