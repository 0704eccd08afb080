// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/scenario/ranges.h"

#include <algorithm>
#include <array>
#include <string>

#include "palpate/scenario/table_array.h"
#include "palpate/scenario/tables.h"
#include "palpate/sim/base/private/refuse.h"

namespace palpate::scenario {
namespace {

// CONTAINER.md has the same table
constexpr std::array kRanges = {
    Range{"scene.tool.radius", "m", 1e-5, 0.2},
    Range{"scene.tool.stiffness", "N/m³", 1e3, 1e12},
    Range{"scene.coupling.stiffness", "N/m", 0.1, 1e6},
    Range{"scene.coupling.force_max", "N", 1e-3, 1e3},
    Range{"scene.hold_stiffness", "N/m", 1e-3, 1e6},
    Range{"scene.gravity", "m/s²", -1e3, 1e3},
    Range{"scene.rate", "Hz", 1.0, 2e4},
    Range{"scene.force_error", "N", 0.0, 10.0},
    Range{"scene.tissue.nodal_share", "-", 0.0, 1.0},
    Range{"scene.tissue.elastic_nodal_share", "-", 0.0, 1.0},
    Range{"scene.tissue.elastic_damping_time", "s", 0.0, 100.0},
    Range{"scene.tissue.pressure", "Pa", -1e6, 1e6},
    Range{"scene.tissue.drag", "1/s", 0.0, 1e6},
    Range{"scene/tissue/rest_position", "m", -10.0, 10.0},
    Range{"scene/tissue/mass", "kg", 1e-15, 1e3},
    Range{"scene/tissue/springs/rest_length", "m", 1e-9, 10.0},
    Range{"scene/tissue/springs/stiffness", "N/m", -1e12, 1e12},
    Range{"scene/tissue/springs/damping", "N s/m", -1e9, 1e9},
    Range{"scene/tissue/bonds/rest_length", "m", 1e-9, 10.0},
    Range{"scene/tissue/bonds/stiffness", "N/m", -1e12, 1e12},
    Range{"scene/tissue/bonds/damping", "N s/m", -1e9, 1e9},
    Range{"scene/tissue/angles/rest_cosine", "-", -1.0, 1.0},
    Range{"scene/tissue/angles/rest_length", "m", 1e-9, 10.0},
    Range{"scene/tissue/angles/bend_stiffness", "J or N", -1e9, 1e9},
    Range{"scene/tissue/angles/stretch_coupling", "N", -1e9, 1e9},
    Range{"scene/tissue/angles/bond_share", "N/m", -1e12, 1e12},
    Range{"scene/tissue/prisms/rest_difference", "m", -10.0, 10.0},
    Range{"scene/tissue/prisms/shear_stiffness", "N/m", -1e12, 1e12},
    Range{"scene/tissue/prisms/shear_damping", "N s/m", -1e9, 1e9},
    Range{"scene/tissue/volumes/rest_volume", "m³", 1e-20, 10.0},
    Range{"scene/tissue/volumes/bulk", "Pa", -1e13, 1e13},
    Range{"scene/tissue/elastic/lame", "Pa", -1e13, 1e13},
    Range{"scene/tissue/elastic/shear", "Pa", 1e-6, 1e13},
    Range{"scene/tissue/skin/weights", "-", -1e3, 1e3},
    Range{"scene/tissue/home", "N/m", 0.0, 1e12},
    Range{"scene/rest_areas", "m²", 0.0, 100.0},
};

const Range& find_range(std::string_view name) {
  return *std::find_if(kRanges.begin(), kRanges.end(),
                       [&](const Range& range) { return range.name == name; });
}

bool holds(const Range& range, double value) noexcept {
  return value >= range.least && value <= range.most;  // never true of NaN
}

[[noreturn]] void refuse_number(const Range& range, const std::string& where, double value) {
  refuse(where, write_text(value), write_text(range.least, " to ", range.most, " ", range.unit));
}

/// A file has one tissue and one instrument.
void check_count(const char* name, std::size_t count) {
  if (count != 1) refuse(name, write_text(count), "1, which is what a file holds");
}

void check_number(const char* name, double value) {
  const Range& range = find_range(name);
  if (!holds(range, value)) refuse_number(range, name, value);
}

template <class Row>
void check_table(const std::string& name, const std::vector<Row>& table) {
  const Range& range = find_range(name);
  for (std::size_t at = 0; at < table.size(); ++at) {
    const auto check = [&](double value) {
      if (!holds(range, value)) refuse_number(range, write_text(name, ": row ", at), value);
    };
    if constexpr (RowOf<Row>::columns == 0) {
      check(table[at]);
    } else {
      for (const double value : table[at]) check(value);
    }
  }
}

}  // namespace

std::span<const Range> list_ranges() noexcept { return kRanges; }

void check_ranges(const Scene& scene) {
  check_count("scene.bodies", scene.bodies.size());
  check_count("scene.instruments", scene.instruments.size());
  check_number("scene.tool.radius", scene.instruments[0].tool.radius);
  check_number("scene.tool.stiffness", scene.instruments[0].tool.stiffness);
  check_number("scene.coupling.stiffness", scene.instruments[0].coupling.stiffness);
  check_number("scene.coupling.force_max", scene.instruments[0].coupling.force_max);
  check_number("scene.hold_stiffness", scene.instruments[0].hold_stiffness);
  for (const double g : scene.gravity) check_number("scene.gravity", g);
  check_number("scene.rate", scene.rate);
  check_number("scene.force_error", scene.bodies[0].force_error);
  check_number("scene.tissue.nodal_share", scene.bodies[0].tissue.volumes.nodal_share);
  check_number("scene.tissue.elastic_nodal_share", scene.bodies[0].tissue.elastic.nodal_share);
  check_number("scene.tissue.elastic_damping_time", scene.bodies[0].tissue.elastic.damping_time);
  check_number("scene.tissue.pressure", scene.bodies[0].tissue.pressure);
  check_number("scene.tissue.drag", scene.bodies[0].tissue.drag);
  visit_tables(scene, [](const std::string& name, const auto& table) {
    using Row = typename std::decay_t<decltype(table)>::value_type;
    if constexpr (std::is_same_v<typename RowOf<Row>::Number, double>) {
      check_table(name, table);
    }
  });
}

}  // namespace palpate::scenario
